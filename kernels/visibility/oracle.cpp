#include "kernels/visibility/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "harness/raster/alpha.h"
#include "harness/raster/winners.h"
#include "kernels/visibility/fat_texel.h"

namespace assay::visibility {

using namespace raster;

namespace {

struct Scene {
  VisibilityParams params;
  Target target;
  std::span<const vec3> positions;
  std::span<const VertexAttributes> attributes;
  std::span<const SurfaceRecord> surfaces;
  std::span<const MaterialRecord> materials;
  std::span<const Texture> textures;
  uint32_t sub_texel_bits;

  const MaterialRecord& material(uint32_t surface) const {
    return materials[std::min(surfaces[surface].material, std::max(params.scene.materials, 1u) - 1)];
  }
};

Scene scene_of(const Case& c) {
  const auto params = c.params<VisibilityParams>();
  const double width = c.extent.width, height = c.extent.height;
  const Target target = {
      width, height, 0, 0, width, height, std::ldexp(1.0, static_cast<int>(c.device.sub_pixel_bits))};
  std::span<const Texture> textures;
  if (const auto it = c.textures.find("textures"); it != c.textures.end()) textures = it->second;
  return {params,
          target,
          c.input<vec3>("positions"),
          c.input<VertexAttributes>("attributes"),
          c.input<SurfaceRecord>("surfaces"),
          c.input<MaterialRecord>("materials"),
          textures,
          c.device.sub_texel_bits};
}

uint32_t word_of(const SurfaceRecord& s, uint32_t surface) {
  return (surface & kVisibilitySurfaceMask) | ((s.flags & kSurfaceInstanced) != 0 ? kVisibilityInstanced : 0) |
         ((s.flags & kSurfaceFlipped) != 0 ? kVisibilityFlipped : 0);
}

// A triangle with a vertex that is no number: Vulkan does not say what is drawn, so it may appear anywhere at any
// depth.
void add_anywhere(Winners& winners, uint32_t triangle) {
  for (uint64_t i = 0; i < winners.pixels(); ++i)
    winners.add(
        i, {.cover = Cover::maybe, .low = 0, .high = std::numeric_limits<double>::infinity(), .triangle = triangle});
}

void add_triangle(const Scene& scene, const JudgedMap& judged, const DrawnTriangle& t, Winners& winners) {
  std::array<ClipVertex, 3> v;
  const SurfaceRecord& surface = scene.surfaces[t.surface];
  const Rows rows = {surface.clip_x, surface.clip_y, vec4(0, 0, 0, scene.params.near_plane), surface.clip_w};
  for (uint32_t k = 0; k < 3; ++k) v[k] = transform(rows, scene.positions[t.vertices[k]]);
  WinningTriangle w = {.drawn = t};
  if (!(v[0].finite && v[1].finite && v[2].finite)) {
    w.shape.planes_known = false;
    return add_anywhere(winners, winners.add(std::move(w)));
  }
  w.shape = shape_of(v, t.facing, scene.target);
  const auto kept = [&](double x, double y) {
    const auto uv = [&](uint32_t k) { return scene.attributes[t.vertices[k]].uv; };
    return kept_at(w.shape, {uv(0), uv(1), uv(2)}, scene.material(t.surface), scene.textures, scene.sub_texel_bits, x,
                   y);
  };
  const auto width = static_cast<uint64_t>(scene.target.width);
  const uint32_t id = add_candidates(winners, judged, width, t, w.shape, kept);
  if (id == kNoTriangle) return;
  w.shape.edges.clear(), w.shape.edges.shrink_to_fit();
  winners.set(id, std::move(w));
}

// An element of the joined ports visibility and depth.
struct Texel {
  uint32_t x, y;
  float depth;
};

void append(Bytes& to, const Texel& t) {
  const auto* p = reinterpret_cast<const std::byte*>(&t);
  to.insert(to.end(), p, p + sizeof t);
}

void append_ids(Expected& ids, const Scene& scene, const Winners& winners, const Outcome& o) {
  if (o.triangle == kNoTriangle) {
    append(ids.low, {kVisibilityNone, kVisibilityNone, 0});
    append(ids.high, {kVisibilityNone, kVisibilityNone, 0});
    return;
  }
  const DrawnTriangle& t = winners.triangle(o.triangle).drawn;
  const uint32_t word = word_of(scene.surfaces[t.surface], t.surface);
  append(ids.low, {t.primitive, word, float_at_most(o.low)});
  append(ids.high, {t.primitive, word, float_at_least(o.high)});
}

void append_outcome(Expected& fat, const Scene& scene, const Winners& winners, const Outcome& o, uint32_t x,
                    uint32_t y) {
  if (o.triangle == kNoTriangle) return append_cleared(fat);
  const WinningTriangle& w = winners.triangle(o.triangle);
  const auto attribute = [&](uint32_t k) -> const VertexAttributes& { return scene.attributes[w.drawn.vertices[k]]; };
  append_fat(fat, w.shape, {attribute(0), attribute(1), attribute(2)}, scene.surfaces[w.drawn.surface], x, y);
}

constexpr uint64_t kFatPixels = 1u << 14;

}  // namespace

Answer rasterise(const Case& c) {
  const Scene scene = scene_of(c);
  JudgedMap judged = judged_map(c);
  Winners winners(judged.list.empty() ? pixel_count(c.extent) : judged.list.size());
  for_each_triangle(c, [&](const DrawnTriangle& t) { add_triangle(scene, judged, t, winners); });

  // The fat texel takes forty times the work of an id: past kFatPixels, it is judged of a share of the pixels.
  const uint64_t stride = c.judge_all ? 1 : (winners.pixels() + kFatPixels - 1) / kFatPixels;
  Expected ids, fat;
  ids.first = {0}, fat.first = {0};
  for (uint64_t i = 0; i < winners.pixels(); ++i) {
    const uint64_t pixel = judged.list.empty() ? i : judged.list[i];
    const std::vector<Outcome>& outcomes = winners.outcomes(i);
    for (const Outcome& o : outcomes) append_ids(ids, scene, winners, o);
    ids.first.push_back(static_cast<uint32_t>(ids.low.size() / sizeof(Texel)));
    if (i % std::max<uint64_t>(stride, 1) != 0) continue;
    const auto x = static_cast<uint32_t>(pixel % c.extent.width), y = static_cast<uint32_t>(pixel / c.extent.width);
    for (const Outcome& o : outcomes) append_outcome(fat, scene, winners, o, x, y);
    fat.first.push_back(static_cast<uint32_t>(fat.low.size() / sizeof(FatFields)));
    fat.judged.push_back(pixel);
  }
  ids.judged = std::move(judged.list);
  return {{"visibility", std::move(ids)}, {"fat", std::move(fat)}};
}

}  // namespace assay::visibility
