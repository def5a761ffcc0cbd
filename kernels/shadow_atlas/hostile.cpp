// Cases that no frame should hold.
#include <limits>

#include "kernels/shadow_atlas/builder.h"

namespace assay::shadow_atlas {

using namespace raster;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A still and a moving quad in a tile amid loud texels, and what breaks them.
template <class T>
Case broken(const std::string& port, const std::function<void(T&)>& change) {
  Builder b(64, 64);
  b.add_both({16, 16, 32});
  b.add(cover({}, 2), {}, {{0, {}}});
  b.add(cover({}, 1), {.moving = true}, {{0, {}}});
  Case c = b.finish();
  const auto values = c.input<T>(port);
  std::vector<T> changed(values.begin(), values.end());
  for (T& value : changed) change(value);
  c.set_input(port, changed);
  return c;
}

Case with_position(const vec3& broken_position) {
  Case c = broken<vec3>("positions", [](vec3&) {});
  const auto values = c.input<vec3>("positions");
  std::vector<vec3> changed(values.begin(), values.end());
  changed.front() = changed.back() = broken_position;
  for (const size_t i : {size_t{1}, changed.size() - 2}) changed[i].x *= 0.25f;  // else what is left has no area
  c.set_input("positions", changed);
  return c;
}

Case with_tiles(const std::vector<ShadowTile>& tiles) {
  Builder b(64, 64);
  std::vector<Placed> placed;
  for (const ShadowTile& t : tiles) placed.push_back({b.add_both(t), {}});
  b.add(cover({}, 2), {}, placed);
  b.add(cover({}, 1), {.moving = true}, placed);
  return b.finish();
}

Case without(uint SceneCounts::*scene, uint ShadowCounts::*shadows, const std::vector<std::string>& ports) {
  Case c = with_tiles({{16, 16, 32}});
  auto params = c.params<ShadowAtlasParams>();
  if (scene) params.scene.*scene = 0;
  if (shadows) params.shadows.*shadows = 0;
  c.set_params(params);
  for (const std::string& port : ports) c.inputs[port].clear();
  return c;
}

}  // namespace

std::vector<HardCase> hostile_cases() {
  return {
      {"tile_past_end", "casters of tiles past the list's end are not drawn",
       [] {
         return broken<ShadowCaster>("casters", [n = 0u](ShadowCaster& c) mutable { c.tile = n++ ? 0xffffffffu : 1u; });
       }},
      {"tile_beyond_atlas", "tiles that reach out of the atlas by a texel, and lie outside",
       [] {
         return with_tiles({{33, 0, 32}, {0, 33, 32}, {64, 64, 8}, {0, 0, 128}});
       }},
      {"tile_wraps", "tiles whose end overflows",
       [] {
         return with_tiles({{0xffffffff, 0, 32}, {0, 0, 0xffffffff}, {0xfffffff0, 0xfffffff0, 32}});
       }},
      {"tile_of_no_side", "a side of 0",
       [] {
         return with_tiles({{16, 16, 0}});
       }},
      {"row_nan", "NaN in a row: the caster lies before the near plane",
       [] { return broken<ShadowCaster>("casters", [](ShadowCaster& c) { c.clip_x.y = kNaN; }); }},
      {"row_infinite", "infinity in a row",
       [] { return broken<ShadowCaster>("casters", [](ShadowCaster& c) { c.clip_w.z = -kInfinity; }); }},
      {"row_zero", "rows of nothing: w is 0",
       [] {
         return broken<ShadowCaster>("casters",
                                     [](ShadowCaster& c) { c.clip_x = c.clip_y = c.clip_z = c.clip_w = vec4(0); });
       }},
      {"position_nan", "NaN in two positions of a still and a moving quad",
       [] { return with_position(vec3(kNaN, 0, -2)); }},
      {"position_infinite", "an infinite position", [] { return with_position(vec3(0, kInfinity, -2)); }},
      {"position_huge", "positions near the largest float", [] { return with_position(vec3(1e38f, 1e38f, -1)); }},
      {"position_large", "coordinates just below what is taken for infinite",
       [] { return with_position(vec3(1e29f, 1e29f, -1)); }},
      {"position_denormal", "denormal coordinates, flushed or not",
       [] { return with_position(vec3(1e-40f, -1e-42f, -2)); }},
      {"index_past_end", "an index past the vertices is the last",
       [] { return broken<uint>("indices", [](uint& i) { i = i == 1 ? 1000000 : i; }); }},
      {"instance_past_end", "instances past the casters are the last again",
       [] {
         return broken<DrawCommand>("draws", [](DrawCommand& d) { d.instance_count = 5, d.first_instance += 1; });
       }},
      {"material_past_end", "a material past the end is the last",
       [] {
         Builder b(64, 64);
         b.add_both({16, 16, 32});
         b.add(cover({}, 2), masked_look(1, 2), {{0, {}}});
         b.add(cover({}, 1), masked_look(1, 0.5f), {{0, {}}});
         Case c = b.finish();
         const auto values = c.input<ShadowCaster>("casters");
         std::vector<ShadowCaster> changed(values.begin(), values.end());
         for (ShadowCaster& caster : changed) caster.material += 70000;
         c.set_input("casters", changed);
         return c;
       }},
      {"no_casters", "draws without casters: tiles are clear",
       [] { return without(nullptr, &ShadowCounts::casters, {"casters"}); }},
      {"no_vertices", "casters without vertices: tiles are clear",
       [] {
         return without(&SceneCounts::vertices, nullptr, {"positions", "attributes"});
       }},
      {"uv_nan", "NaN in the coordinates of a cut: any texel, or none",
       [] {
         Builder b(64, 64);
         b.add_both({16, 16, 32});
         b.add_texture(
             alpha_texture(8, 2, 1, Format::rgba8_unorm, [](uint32_t x, uint32_t, uint32_t) { return x % 2 * 255; }));
         Mesh m = cover({}, 2);
         m.attributes[0].uv.x = kNaN;
         b.add(m, masked_look(1, 0.5f, texture_name(0, 0)), {{0, {}}});
         return b.finish();
       }},
  };
}

}  // namespace assay::shadow_atlas
