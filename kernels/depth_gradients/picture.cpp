// Pictures as cases.
#include "kernels/depth_gradients/inputs.h"

namespace assay::depth_gradients {

namespace {

constexpr double kNearPlane_m = 0.1;

dvec3 row(const vec4& r) { return {r.x, r.y, r.z}; }

}  // namespace

Picture::Picture(Extent e)
    : extent(e), visibility(pixel_count(e), uvec2(kVisibilityNone)), depth(pixel_count(e), 0.0f) {}

void Picture::add_surface(SurfaceRecord s) {
  s.first_index = static_cast<uint32_t>(indices.size());
  s.vertex_offset = static_cast<uint32_t>(positions.size());
  surfaces.push_back(s);
}
void Picture::add_surface() {
  SurfaceRecord s = {};
  s.clip_x = {1, 0, 0, 0}, s.clip_y = {0, 1, 0, 0}, s.clip_w = {0, 0, 1, 0};
  add_surface(s);
}

uint32_t Picture::add_triangle(const std::array<dvec3, 3>& corners) {
  SurfaceRecord& s = surfaces.back();
  const glm::dmat3 rows = {row(s.clip_x), row(s.clip_y), row(s.clip_w)};
  const dvec3 moved = {s.clip_x.w, s.clip_y.w, s.clip_w.w};
  for (const dvec3& c : corners) {
    indices.push_back(static_cast<uint32_t>(positions.size()) - s.vertex_offset);
    positions.push_back(vec3(glm::inverse(glm::transpose(rows)) * (c - moved)));
  }
  return s.triangle_count++;
}

uint32_t Picture::add_triangle(const Plane& p, const std::array<dvec2, 3>& pixels) {
  const dvec2 half = dvec2(extent.width, extent.height) * 0.5;
  std::array<dvec3, 3> corners;
  for (size_t k = 0; k < 3; ++k) {
    double inverse = p.inverse_depth(pixels[k]);
    if (std::fabs(inverse * p.w) < 1e-3) inverse = 1e-3 / p.w;
    corners[k] = dvec3(pixels[k] / half - 1.0, 1) / inverse;
  }
  return add_triangle(corners);
}

void Picture::show(uint32_t x, uint32_t y, uint32_t triangle, const Plane& p) {
  const uint32_t flags = surfaces.back().flags;
  const size_t at = size_t{y} * extent.width + x;
  visibility[at] = {triangle, static_cast<uint32_t>(surfaces.size() - 1) |
                                  ((flags & kSurfaceInstanced) != 0 ? kVisibilityInstanced : 0u) |
                                  ((flags & kSurfaceFlipped) != 0 ? kVisibilityFlipped : 0u)};
  depth[at] = static_cast<float>(std::max(0.0, kNearPlane_m * p.inverse_depth({x + 0.5, y + 0.5})));
}
void Picture::show_all(uint32_t triangle, const Plane& p) {
  for (uint32_t y = 0; y < extent.height; ++y)
    for (uint32_t x = 0; x < extent.width; ++x) show(x, y, triangle, p);
}

Case Picture::to_case() const {
  Case c = {.extent = extent};
  c.set_params(GradientParams{extent.width, extent.height, static_cast<uint32_t>(positions.size()),
                              static_cast<uint32_t>(indices.size()), static_cast<uint32_t>(surfaces.size()),
                              kProbeFactor, kProbeAddend});
  c.set_input("visibility", visibility);
  c.set_input("depth", depth);
  c.set_input("positions", positions);
  c.set_input("indices", indices);
  c.set_input("surfaces", surfaces);
  return c;
}

}  // namespace assay::depth_gradients
