#include "kernels/visibility/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "kernels/visibility/alpha.h"
#include "kernels/visibility/fat_texel.h"
#include "kernels/visibility/winners.h"

namespace assay::visibility {

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
  const Target target = {double(c.extent.width), double(c.extent.height), double{params.near_plane},
                         std::ldexp(1.0, static_cast<int>(c.device.sub_pixel_bits))};
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

Cover kept_at(const Scene& scene, const DrawnTriangle& t, const Shape& shape, double x, double y) {
  const MaterialRecord& m = scene.material(t.surface);
  const auto component = [&](uint32_t axis) {
    const auto at = [&](uint32_t k) { return double{scene.attributes[t.vertices[k]].uv[static_cast<int>(axis)]}; };
    return attribute_at(shape, {at(0), at(1), at(2)}, x, y);
  };
  return kept(m, sampled_alpha(m, scene.textures, component(0), component(1), scene.sub_texel_bits));
}

// What is known of a triangle at a pixel.
Candidate candidate_at(const Scene& scene, const DrawnTriangle& t, const Shape& shape, double x, double y) {
  Candidate c;
  const Coverage coverage = covers(shape, x, y);
  c.cover = coverage.cover;
  if (c.cover == Cover::out) return c;
  const Cover front = before_near(shape, x, y);
  const Cover solid = t.masked && front != Cover::out ? kept_at(scene, t, shape, x, y) : Cover::in;
  c.cover = std::min({c.cover, front, solid});
  if (c.cover == Cover::out) return c;
  const Interval depth = depth_at(shape, x, y);
  c.low = depth.low, c.high = depth.high;
  if (c.low <= 0) c.cover = Cover::maybe;  // the cleared depth is not surely behind it
  if (coverage.only_doubt != kNoEdge && shape.whole && front == Cover::in && solid == Cover::in) {
    const Edge& e = shape.edges[coverage.only_doubt];
    c.edge_from = t.vertices[e.from], c.edge_to = t.vertices[e.to];
  }
  return c;
}

// A triangle with a vertex that is no number: Vulkan does not say what is drawn, so it may appear anywhere at any
// depth.
void add_anywhere(Winners& winners, uint32_t triangle) {
  for (uint64_t i = 0; i < winners.pixels(); ++i)
    winners.add(
        i, {.cover = Cover::maybe, .low = 0, .high = std::numeric_limits<double>::infinity(), .triangle = triangle});
}

void add_triangle(const Scene& scene, const JudgedPixels& judged, const DrawnTriangle& t, Winners& winners) {
  std::array<ClipVertex, 3> v;
  for (uint32_t k = 0; k < 3; ++k) v[k] = transform(scene.surfaces[t.surface], scene.positions[t.vertices[k]]);
  const SurfaceRecord& surface = scene.surfaces[t.surface];
  WinningTriangle w = {.drawn = t, .word = word_of(surface, t.surface), .shape = {}};
  if (!(v[0].finite && v[1].finite && v[2].finite)) {
    w.shape.planes_known = false;
    return add_anywhere(winners, winners.add(std::move(w)));
  }
  w.shape = shape_of(v, t.facing, scene.target);
  if (w.shape.edges.empty()) return;
  uint32_t id = kNoTriangle;
  Shape& shape = w.shape;
  const auto width = static_cast<uint64_t>(scene.target.width);
  for (uint32_t y = shape.y_first; y < shape.y_end; ++y)
    for (uint32_t x = shape.x_first; x < shape.x_end; ++x) {
      uint64_t pixel = y * width + x;
      if (!judged.list.empty()) {
        if (judged.position[pixel] == kNotJudged) continue;
        pixel = judged.position[pixel];
      }
      Candidate c = candidate_at(scene, t, shape, x + 0.5, y + 0.5);
      if (c.cover == Cover::out) continue;
      if (id == kNoTriangle) id = winners.reserve();
      c.triangle = id;
      winners.add(pixel, c);
    }
  if (id == kNoTriangle) return;
  w.shape.edges.clear(), w.shape.edges.shrink_to_fit();
  winners.set(id, std::move(w));
}

// An element of the joined ports visibility and depth.
struct Texel {
  uint32_t x, y;
  float depth;
};

float at_most(double v) {
  const auto f = static_cast<float>(v);
  return double{f} > v ? std::nextafter(f, -1.0f) : f;
}
float at_least(double v) {
  const auto f = static_cast<float>(v);
  return double{f} < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

void append(Bytes& to, const Texel& t) {
  const auto* p = reinterpret_cast<const std::byte*>(&t);
  to.insert(to.end(), p, p + sizeof t);
}

void append_ids(Expected& ids, const Winners& winners, const Outcome& o) {
  if (o.triangle == kNoTriangle) {
    append(ids.low, {kVisibilityNone, kVisibilityNone, 0});
    append(ids.high, {kVisibilityNone, kVisibilityNone, 0});
    return;
  }
  const WinningTriangle& w = winners.triangle(o.triangle);
  append(ids.low, {w.drawn.primitive, w.word, at_most(o.low)});
  append(ids.high, {w.drawn.primitive, w.word, at_least(o.high)});
}

void append_fat(Expected& fat, const Scene& scene, const Winners& winners, const Outcome& o, uint32_t x, uint32_t y) {
  if (o.triangle == kNoTriangle) return append_cleared(fat);
  const WinningTriangle& w = winners.triangle(o.triangle);
  const auto attribute = [&](uint32_t k) -> const VertexAttributes& { return scene.attributes[w.drawn.vertices[k]]; };
  append_fat(fat, w.shape, {attribute(0), attribute(1), attribute(2)}, scene.surfaces[w.drawn.surface], x, y);
}

constexpr uint64_t kFatPixels = 1u << 14;

}  // namespace

Answer rasterise(const Case& c) {
  const Scene scene = scene_of(c);
  JudgedPixels judged = judged_pixels(c);
  Winners winners(judged.list.empty() ? pixel_count(c.extent) : judged.list.size());
  for_each_triangle(c, [&](const DrawnTriangle& t) { add_triangle(scene, judged, t, winners); });

  // The fat texel takes forty times the work of an id: past kFatPixels, it is judged of a share of the pixels.
  const uint64_t stride = c.judge_all ? 1 : (winners.pixels() + kFatPixels - 1) / kFatPixels;
  Expected ids, fat;
  ids.first = {0}, fat.first = {0};
  for (uint64_t i = 0; i < winners.pixels(); ++i) {
    const uint64_t pixel = judged.list.empty() ? i : judged.list[i];
    const std::vector<Outcome>& outcomes = winners.outcomes(i);
    for (const Outcome& o : outcomes) append_ids(ids, winners, o);
    ids.first.push_back(static_cast<uint32_t>(ids.low.size() / sizeof(Texel)));
    if (i % std::max<uint64_t>(stride, 1) != 0) continue;
    const auto x = static_cast<uint32_t>(pixel % c.extent.width), y = static_cast<uint32_t>(pixel / c.extent.width);
    for (const Outcome& o : outcomes) append_fat(fat, scene, winners, o, x, y);
    fat.first.push_back(static_cast<uint32_t>(fat.low.size() / sizeof(FatFields)));
    fat.judged.push_back(pixel);
  }
  ids.judged = std::move(judged.list);
  return {{"visibility", std::move(ids)}, {"fat", std::move(fat)}};
}

}  // namespace assay::visibility
