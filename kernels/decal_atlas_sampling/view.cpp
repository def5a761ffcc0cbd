// Views with decals as cases.
#include <glm/matrix.hpp>

#include "harness/clusters.h"
#include "harness/half.h"
#include "harness/image/block_textures.h"
#include "kernels/decal_atlas_sampling/inputs.h"

namespace assay::decal_atlas_sampling {

using glm::dvec3;

namespace {

uint16_t half_of(double v) { return half_bits(std::clamp(v, -kLargestHalf, kLargestHalf)); }

struct CellRange {
  uint32_t first[3] = {0, 0, 0}, last[3];  // column, row, slice; `last` is one of them
};

uint32_t slice_of(const std::vector<float>& edges, double w) {
  uint32_t slice = 0;
  for (size_t k = 1; k + 1 < edges.size(); ++k) slice += edges[k] <= w;
  return slice;
}

dvec3 row(const vec4& r) { return {r.x, r.y, r.z}; }
double offset(const vec4& r) { return r.w; }
template <class R>
dvec3 moved(const R& r, const dvec3& p) {
  return {glm::dot(row(r.row_x), p) + offset(r.row_x), glm::dot(row(r.row_y), p) + offset(r.row_y),
          glm::dot(row(r.row_z), p) + offset(r.row_z)};
}
// Back from the space that the rows lead to.
template <class R>
dvec3 moved_back(const R& r, const dvec3& q) {
  const glm::dmat3 rows = {row(r.row_x), row(r.row_y), row(r.row_z)};
  return glm::inverse(glm::transpose(rows)) * (q - dvec3(offset(r.row_x), offset(r.row_y), offset(r.row_z)));
}

// Bounds of a box on the screen and in depth, a hundredth of it wider; all cells where a corner is behind the eye.
CellRange cells_of(const View& v, const DecalRecord& d, const std::vector<float>& edges) {
  const DecalParams& p = v.params;
  const uint32_t counts[3] = {p.grid.columns, p.grid.rows, p.grid.slices};
  CellRange r;
  for (int i = 0; i < 3; ++i) r.last[i] = counts[i] - 1;
  dvec3 low(INFINITY), high(-INFINITY);
  for (uint32_t corner = 0; corner < 8; ++corner) {
    const auto end = [&](uint32_t axis) { return (corner >> axis & 1) != 0 ? 1.01 : -0.01; };
    dvec3 at = moved_back(d, {end(0), end(1), end(2)});
    if (d.receiver < v.receivers.size()) at = moved_back(v.receivers[d.receiver], at);
    if (!(-at.z > p.near_plane && glm::length(at) < 1e12)) return r;
    const double slope = double(v.extent.height) / v.extent.width, w = -at.z;
    const dvec3 here = {(at.x / w + 1) / 2 * v.extent.width / p.grid.cell_width,
                        (1 - at.y / w / slope) / 2 * v.extent.height / p.grid.cell_height, w};
    low = glm::min(low, here), high = glm::max(high, here);
  }
  for (int i = 0; i < 2; ++i) {
    r.first[i] = static_cast<uint32_t>(std::clamp(low[i], 0.0, double(r.last[i])));
    r.last[i] = static_cast<uint32_t>(std::clamp(high[i], 0.0, double(r.last[i])));
  }
  r.first[2] = slice_of(edges, low.z), r.last[2] = slice_of(edges, high.z);
  return r;
}

}  // namespace

uint32_t packed_normal(const dvec3& n) {
  const double sum = std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
  double x = n.x / sum, y = n.y / sum;
  if (n.z < 0) {
    const double folded = (1 - std::fabs(y)) * (x < 0 ? -1 : 1);
    y = (1 - std::fabs(x)) * (y < 0 ? -1 : 1), x = folded;
  }
  const auto code = [](double v) { return static_cast<uint32_t>(std::lround(v * 32767)) & 0xffffu; };
  return code(x) | code(y) << 16;
}

DecalRecord decal(const dvec3& at, const dvec3& outward, double angle, const dvec3& half, const AtlasPlan& a,
                  uint32_t cell) {
  const dvec3 aside = glm::normalize(glm::cross(std::fabs(outward.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), outward));
  const dvec3 up = glm::cross(outward, aside);
  const dvec3 axes[3] = {aside * std::cos(angle) + up * std::sin(angle), up * std::cos(angle) - aside * std::sin(angle),
                         outward};
  const auto row_of = [&](int i) {
    const dvec3 r = axes[i] / (2 * half[i]);
    return vec4(vec3(r), static_cast<float>(0.5 - glm::dot(r, at)));
  };
  const uint32_t columns = a.width / a.side, rows = a.height / a.side;
  const vec2 size = {static_cast<float>(a.width), static_cast<float>(a.height)};
  const vec2 scale = vec2(static_cast<float>(a.side - 2 * a.border)) / size;
  const vec2 bias = vec2(static_cast<float>(cell % columns * a.side + a.border),
                         static_cast<float>(cell / columns % rows * a.side + a.border)) /
                    size;
  return {.row_x = row_of(0),
          .row_y = row_of(1),
          .row_z = row_of(2),
          .scale_bias = {scale.x, scale.y, bias.x, bias.y},
          .weights = vec3(1),
          .fade_distance = 0,
          .tangent = vec3(axes[0]),
          .normal_mode = kNormalWhiteout,
          .bitangent = vec3(axes[1]),
          .receiver = kNoReceiver,
          .outward = vec3(axes[2]),
          .page = cell / (columns * rows) % a.pages};
}

void set_atlas(Case& c, std::vector<Texture> atlas) {
  c.textures["atlas_blocks"] = {image::in_blocks(atlas[kAtlasAlbedo], Format::bc7_srgb),
                                image::in_blocks(atlas[kAtlasNormal], Format::bc5_unorm),
                                image::in_blocks(atlas[kAtlasRoughness], Format::bc4_unorm)};
  c.textures["atlas"] = std::move(atlas);
}

View::View(Extent e) : extent(e) {
  params.width = e.width, params.height = e.height;
  params.grid = grid_over(e, coarse_cell(e), 24);
  params.near_plane = 0.5f;
  const float slope = static_cast<float>(e.height) / static_cast<float>(e.width);
  params.rays = {vec3(-1, slope, -1), vec3(2.0f / static_cast<float>(e.width), 0, 0),
                 vec3(0, -2 * slope / static_cast<float>(e.height), 0)};
  const size_t n = pixel_count(e);
  depth.assign(n, 0), gradients.assign(n, {0, 0});
  base_roughness.assign(n, 0x80a0b4c8u), normal.assign(n, packed_normal({0, 0, 1}));
}

dvec3 View::ray(double x, double y) const {
  return dvec3(params.rays.corner) + dvec3(params.rays.across) * x + dvec3(params.rays.down) * y;
}

void View::set_plane(uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1, const dvec3& at, const dvec3& n) {
  for (uint32_t y = y0; y < y1; ++y)
    for (uint32_t x = x0; x < x1; ++x) {
      const dvec3 r = ray(x + 0.5, y + 0.5);
      const double along = glm::dot(n, r), w = glm::dot(n, at) / along;
      if (!(w > params.near_plane) || w > 1e7) continue;
      const size_t i = size_t{y} * extent.width + x;
      depth[i] = static_cast<float>(params.near_plane / w);
      gradients[i] = {half_of(glm::dot(n, dvec3(params.rays.across)) / along),
                      half_of(glm::dot(n, dvec3(params.rays.down)) / along)};
      normal[i] = packed_normal(n);
    }
}

dvec3 View::position(uint32_t x, uint32_t y) const {
  return ray(x + 0.5, y + 0.5) * (double{params.near_plane} / depth[size_t{y} * extent.width + x]);
}

Case View::to_case() const {
  DecalParams p = params;
  const ClusterGrid& g = p.grid;
  const std::vector<float> edges = slice_edges(p.near_plane, far, g.slices);
  const uint32_t cell_count = g.columns * g.rows * g.slices;
  std::vector<std::vector<uint32_t>> lists(cell_count);
  for (uint32_t i = 0; i < decals.size(); ++i) {
    const CellRange r = cells_of(*this, decals[i], edges);
    for (uint32_t z = r.first[2]; z <= r.last[2]; ++z)
      for (uint32_t y = r.first[1]; y <= r.last[1]; ++y)
        for (uint32_t x = r.first[0]; x <= r.last[0]; ++x) lists[(z * g.rows + y) * g.columns + x].push_back(i);
  }
  const auto words = static_cast<uint32_t>((decals.size() + 31) / 32);
  std::vector<uint> bits(size_t{words} * cell_count), entries;
  std::vector<uvec2> cells;
  for (uint32_t cell = 0; cell < cell_count; ++cell) {
    const auto count = std::min(static_cast<uint32_t>(lists[cell].size()), kMaxClusterEntries);
    cells.emplace_back(static_cast<uint32_t>(entries.size()), count << kClusterDecalShift);
    for (uint32_t k = 0; k < count; ++k) entries.push_back(lists[cell][k] << kClusterDecalShift);
    for (const uint32_t i : lists[cell]) bits[size_t{i / 32} * cell_count + cell] |= 1u << i % 32;
  }
  p.decals = static_cast<uint32_t>(decals.size()), p.entries = static_cast<uint32_t>(entries.size());
  p.receivers = static_cast<uint32_t>(receivers.size());
  p.atlas_border = static_cast<float>(atlas.border);
  Case c = {.extent = extent};
  c.set_params(p);
  c.set_input("depth", depth);
  c.set_input("depth_gradients", gradients);
  c.set_input("base_roughness", base_roughness);
  c.set_input("normal", normal);
  c.set_input("slice_edges", reversed_slice_edges(edges, p.near_plane));
  c.set_input("decals", decals);
  c.set_input("receivers", receivers);
  c.set_input("cells", cells);
  c.set_input("entries", entries);
  c.set_input("decal_bits", bits);
  set_atlas(c, atlas_of(atlas));
  if (last) last(c);
  set_primaries(c, *this);
  return c;
}

}  // namespace assay::decal_atlas_sampling
