#include "kernels/shadow_atlas/oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "harness/raster/alpha.h"
#include "harness/raster/winners.h"

namespace assay::shadow_atlas {

using namespace raster;

namespace {

constexpr double u = kUnitRoundoff;
constexpr uint64_t kSampledAbove = 1u << 18;  // texels
constexpr uint8_t kInStill = 1, kInTiles = 2;

struct Scene {
  ShadowAtlasParams params;
  std::span<const vec3> positions;
  std::span<const VertexAttributes> attributes;
  std::span<const uint> indices;
  std::span<const ShadowCaster> casters;
  std::span<const DrawCommand> draws;
  std::span<const MaterialRecord> materials;
  std::span<const Texture> textures;
  uint32_t sub_texel_bits;
  double grid;
};

Scene scene_of(const Case& c) {
  std::span<const Texture> textures;
  if (const auto it = c.textures.find("textures"); it != c.textures.end()) textures = it->second;
  return {c.params<ShadowAtlasParams>(),
          c.input<vec3>("positions"),
          c.input<VertexAttributes>("attributes"),
          c.input<uint>("indices"),
          c.input<ShadowCaster>("casters"),
          c.input<DrawCommand>("draws"),
          c.input<MaterialRecord>("materials"),
          textures,
          c.device.sub_texel_bits,
          std::ldexp(1.0, static_cast<int>(c.device.sub_pixel_bits))};
}

// Which lists' tiles a texel lies in.
std::vector<uint8_t> areas(const Case& c) {
  std::vector<uint8_t> area(pixels(c), 0);
  const ShadowCounts n = c.params<ShadowAtlasParams>().shadows;
  const auto add = [&](const char* port, uint8_t bit) {
    for (const ShadowTile& t : c.input<ShadowTile>(port))
      if (is_tile(t, n))
        for (uint32_t y = t.y; y < t.y + t.side; ++y)
          for (uint32_t x = t.x; x < t.x + t.side; ++x) area[uint64_t{y} * n.width + x] |= bit;
  };
  add("still_tiles", kInStill);
  add("tiles", kInTiles);
  return area;
}

// Of large atlases the borders of the tiles, and of a grid of 32 texels, and a stratified sample.
std::vector<uint64_t> judged_texels(const Case& c, const std::vector<uint8_t>& area) {
  std::vector<uint64_t> list = judged_pixels(c, kSampledAbove);
  if (list.empty()) {
    for (uint64_t i = 0; i < area.size(); ++i)
      if (area[i]) list.push_back(i);
    return list;
  }
  const ShadowCounts n = c.params<ShadowAtlasParams>().shadows;
  for (const char* port : {"still_tiles", "tiles"})
    for (const ShadowTile& t : c.input<ShadowTile>(port))
      for (uint32_t i = 0; is_tile(t, n) && i < t.side; ++i) {
        const auto add = [&](uint32_t x, uint32_t y) { list.push_back(uint64_t{y} * n.width + x); };
        add(t.x + i, t.y), add(t.x + i, t.y + t.side - 1), add(t.x, t.y + i), add(t.x + t.side - 1, t.y + i);
      }
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
  std::erase_if(list, [&](uint64_t i) { return area[i] == 0; });
  return list;
}

bool is_power_of_two(uint32_t v) { return (v & (v - 1)) == 0; }

// x or y within the tile's -w..w on to the atlas's: v * side / size + w * offset, products, sum and quotients rounded.
struct Mapped {
  double value, error;
};
Mapped in_atlas(double v, double v_error, double w, double w_error, uint32_t first, uint32_t side, uint32_t size) {
  const double scale = double(side) / size, offset = (2.0 * first + side - size) / size;
  const double a = v * scale, b = w * offset, value = a + b;
  const auto is_float = [](double d) { return double{static_cast<float>(d)} == d; };
  const double quotients = is_power_of_two(size) ? 0 : 5 * u * (std::fabs(a) + std::fabs(b));
  const double carried = v_error * scale + w_error * std::fabs(offset);
  if (quotients == 0 && carried == 0 && is_float(a) && is_float(b) && is_float(value)) return {value, 0};
  return {value, 1.01 * (carried + quotients + u * (std::fabs(a) + std::fabs(b) + std::fabs(value)))};
}

constexpr ClipVertex kNowhere = {.z = 2, .w = 1};  // of clip coordinates that are too large or no numbers
enum class Known { yes, nowhere, no };

bool is_finite(const vec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// By the sum of the magnitudes, which rounding may tip.
Known known(const ClipVertex& v) {
  const double sum = std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z) + std::fabs(v.w);
  const double error = 4 * u * sum + v.x_error + v.y_error + v.z_error + v.w_error;
  if (sum - error >= double{kFarthest}) return Known::nowhere;
  return sum + error < double{kFarthest} ? Known::yes : Known::no;
}

struct Placed {
  std::array<ClipVertex, 3> vertices;
  bool known = true;
};
Placed place(const Scene& scene, const ShadowCaster& c, const ShadowTile& t, const DrawnTriangle& drawn) {
  const ShadowCounts& n = scene.params.shadows;
  Placed placed;
  for (uint32_t k = 0; k < 3; ++k) {
    const vec3 p = scene.positions[drawn.vertices[k]];
    ClipVertex v = kNowhere;
    if (is_finite(c.clip_x) && is_finite(c.clip_y) && is_finite(c.clip_z) && is_finite(c.clip_w) &&
        is_finite(vec4(p, 1)))
      v = transform({c.clip_x, c.clip_y, c.clip_z, c.clip_w}, p);
    if (const Known k_known = known(v); k_known != Known::yes) v = kNowhere, placed.known &= k_known != Known::no;
    const Mapped x = in_atlas(v.x, v.x_error, v.w, v.w_error, t.x, t.side, n.width);
    const Mapped y = in_atlas(v.y, v.y_error, v.w, v.w_error, t.y, t.side, n.height);
    v.x = x.value, v.x_error = x.error, v.y = y.value, v.y_error = y.error;
    placed.vertices[k] = v;
  }
  return placed;
}

void add_triangle(const Scene& scene, const JudgedMap& judged, std::span<const ShadowTile> tiles,
                  const DrawnTriangle& t, Winners& winners) {
  const ShadowCounts& n = scene.params.shadows;
  const ShadowCaster& caster = scene.casters[t.surface];
  if (caster.tile >= tiles.size() || !is_tile(tiles[caster.tile], n)) return;
  const ShadowTile& tile = tiles[caster.tile];
  const Target target = {double(n.width), double(n.height),           double(tile.x),
                         double(tile.y),  double(tile.x + tile.side), double(tile.y + tile.side),
                         scene.grid};
  const Placed placed = place(scene, caster, tile, t);
  Shape shape = shape_of(placed.vertices, t.facing, target);
  if (!placed.known) {
    shape = {.edges = {{}}, .anywhere = true, .planes_known = false};
    shape.x_first = tile.x, shape.y_first = tile.y, shape.x_end = tile.x + tile.side, shape.y_end = tile.y + tile.side;
  }
  const auto kept = [&](double x, double y) {
    const auto uv = [&](uint32_t k) { return scene.attributes[t.vertices[k]].uv; };
    const uint32_t last = std::max(scene.params.scene.materials, 1u) - 1;
    const MaterialRecord& m = scene.materials[std::min(caster.material, last)];
    return kept_at(shape, {uv(0), uv(1), uv(2)}, m, scene.textures, scene.sub_texel_bits, x, y);
  };
  const uint32_t id = add_candidates(winners, judged, n.width, t, shape, kept);
  if (id != kNoTriangle) winners.set(id, {.drawn = t});
}

// The casters of two ranges of draws, opaque and masked, in these tiles.
Winners draw(const Scene& scene, const JudgedMap& judged, std::span<const ShadowTile> tiles, uint32_t first_range) {
  const ShadowCounts& n = scene.params.shadows;
  Winners winners(judged.list.size());
  if (n.casters == 0 || scene.params.scene.vertices == 0) return winners;
  DrawnTriangle t;
  for (const uint32_t range : {first_range, first_range + 1}) {
    t.masked = range == kShadowStillMasked || range == kShadowMovingMasked;
    for (uint32_t d = n.draw_first[range]; d < n.draw_first[range + 1]; ++d)
      for_each_triangle(scene.draws[d], scene.indices, scene.params.scene.vertices, n.casters, t,
                        [&](const DrawnTriangle& drawn) { add_triangle(scene, judged, tiles, drawn, winners); });
  }
  return winners;
}

// Depths that a texel may have, ascending; those that touch are one.
using Depths = std::vector<Interval>;

void merge(Depths& depths) {
  std::ranges::sort(depths, {}, &Interval::low);
  size_t kept = 0;
  for (size_t i = 1; i < depths.size(); ++i) {
    if (depths[i].low <= depths[kept].high)
      depths[kept].high = std::max(depths[kept].high, depths[i].high);
    else
      depths[++kept] = depths[i];
  }
  depths.resize(kept + 1);
}

Depths drawn_at(Winners& winners, uint64_t i) {
  Depths depths;
  for (const Outcome& o : winners.outcomes(i)) depths.push_back({o.low, o.high});  // of none: 0
  merge(depths);
  return depths;
}

// Of what was there and what was drawn the nearer stays.
Depths over(const Depths& there, const Depths& drawn) {
  Depths depths;
  for (const Interval& a : there)
    for (const Interval& b : drawn) depths.push_back({std::max(a.low, b.low), std::max(a.high, b.high)});
  merge(depths);
  return depths;
}

void append(Expected& e, uint64_t texel, const Depths& depths) {
  const auto put = [](Bytes& to, float f) {
    const auto* p = reinterpret_cast<const std::byte*>(&f);
    to.insert(to.end(), p, p + sizeof f);
  };
  for (const Interval& d : depths) {
    put(e.low, float_at_most(d.low));
    put(e.high, float_at_least(d.high));
  }
  e.first.push_back(static_cast<uint32_t>(e.low.size() / sizeof(float)));
  e.judged.push_back(texel);
}

std::vector<Expected::Run> runs_in(const std::vector<uint8_t>& area, uint8_t bits) {
  std::vector<Expected::Run> runs;
  for (uint64_t i = 0; i < area.size(); ++i) {
    if ((area[i] & bits) == 0) continue;
    if (runs.empty() || runs.back().first + runs.back().count != i) runs.push_back({i, 0});
    ++runs.back().count;
  }
  return runs;
}

}  // namespace

bool is_tile(const ShadowTile& t, const ShadowCounts& n) {
  return t.side > 0 && t.side <= n.width && t.side <= n.height && t.x <= n.width - t.side && t.y <= n.height - t.side;
}

Answer shadows(const Case& c) {
  const Scene scene = scene_of(c);
  const std::vector<uint8_t> area = areas(c);
  const JudgedMap judged = judged_map(judged_texels(c, area), c.extent);
  Winners still = draw(scene, judged, c.input<ShadowTile>("still_tiles"), kShadowStill);
  Winners moving = draw(scene, judged, c.input<ShadowTile>("tiles"), kShadowMoving);
  const auto before = c.input<float>("still");
  Expected of_still, of_depth, redrawn;
  of_still.live = runs_in(area, kInStill), of_depth.live = runs_in(area, kInTiles);
  redrawn.live = runs_in(area, kInStill | kInTiles);
  for (Expected* e : {&of_still, &of_depth, &redrawn}) e->first = {0};
  for (uint64_t i = 0; i < judged.list.size(); ++i) {
    const uint64_t texel = judged.list[i];
    const bool in_still = area[texel] & kInStill, in_tiles = area[texel] & kInTiles;
    const Depths of_still_casters = drawn_at(still, i), of_moving = drawn_at(moving, i);
    const Depths cached = in_still ? of_still_casters : Depths{{before[texel], before[texel]}};
    if (in_still) append(of_still, texel, cached);
    // Rounding takes a depth past 1 at the near plane; copied, it may be clamped.
    Depths copied = cached;
    for (Interval& d : copied) d.low = std::min(d.low, 1.0);
    if (in_tiles) append(of_depth, texel, over(copied, of_moving));
    append(redrawn, texel, over(of_still_casters, of_moving));
  }
  return {{"still", std::move(of_still)}, {"depth", std::move(of_depth)}, {"redrawn", std::move(redrawn)}};
}

}  // namespace assay::shadow_atlas
