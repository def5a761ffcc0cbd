#include "kernels/attribute_interpolation/scene_builder.h"

#include <algorithm>
#include <glm/gtc/matrix_access.hpp>
#include <glm/mat3x3.hpp>

namespace assay::attribute_interpolation {

VertexAttributes flat_attributes() { return {vec3(0, 0, 1), vec4(1, 0, 0, 1), vec2(0)}; }

namespace {

AttributeParams params_of(Extent e) {
  return {.width = e.width,
          .height = e.height,
          .vertices = 0,
          .indices = 0,
          .surfaces = 0,
          .clip_samples = 0,
          .probe_factor = kProbeFactor,
          .probe_addend = kProbeAddend};
}

}  // namespace

Case clip_case(std::string name, const std::vector<ClipSample>& samples, uint32_t width) {
  const auto count = static_cast<uint32_t>(samples.size());
  Case c = {.name = std::move(name), .extent = {width, std::max(ceil_div(count, width), 1u)}};
  AttributeParams p = params_of(c.extent);
  p.clip_samples = count;
  c.set_params(p);
  c.set_input("clip_samples", samples);
  c.set_input("visibility", std::vector<uvec2>(pixels(c), uvec2(kVisibilityNone)));
  c.set_input("positions", std::vector<vec3>());
  c.set_input("attributes", std::vector<VertexAttributes>());
  c.set_input("indices", std::vector<uint32_t>());
  c.set_input("surfaces", std::vector<SurfaceRecord>());
  return c;
}

SceneBuilder::SceneBuilder(Extent e) : extent(e), visibility_(pixel_count(e), uvec2(kVisibilityNone)) {}

uint32_t SceneBuilder::add_surface(const glm::dmat4& place) {
  const double side = std::min(extent.width, extent.height);
  glm::dmat4 camera(0);
  camera[0][0] = side / extent.width;
  camera[1][1] = -side / extent.height;  // y down
  camera[2][3] = -1;                     // w: distance along -z
  const glm::dmat4 clip = camera * place;
  SurfaceRecord s = {};
  s.clip_x = vec4(glm::row(clip, 0)), s.clip_y = vec4(glm::row(clip, 1)), s.clip_w = vec4(glm::row(clip, 3));
  s.world_x = vec4(glm::row(place, 0)), s.world_y = vec4(glm::row(place, 1)), s.world_z = vec4(glm::row(place, 2));
  if (glm::determinant(place) < 0) s.flags |= kSurfaceFlipped;
  return add_surface(s);
}

uint32_t SceneBuilder::add_surface(const SurfaceRecord& record) {
  SurfaceRecord s = record;
  s.first_index = static_cast<uint32_t>(indices.size());
  s.vertex_offset = static_cast<uint32_t>(positions.size());
  surfaces.push_back(s);
  return static_cast<uint32_t>(surfaces.size() - 1);
}

uint32_t SceneBuilder::add_triangle(const std::array<vec3, 3>& p, const std::array<VertexAttributes, 3>& a) {
  SurfaceRecord& s = surfaces.back();
  for (size_t k = 0; k < 3; ++k) {
    indices.push_back(static_cast<uint32_t>(positions.size()) - s.vertex_offset);
    positions.push_back(p[k]);
    attributes.push_back(a[k]);
  }
  return s.triangle_count++;
}

vec3 SceneBuilder::object_position(const glm::dvec3& clip) const {
  const SurfaceRecord& s = surfaces.back();
  const glm::dvec3 x(s.clip_x), y(s.clip_y), w(s.clip_w);
  const glm::dmat3 rows = transpose(glm::dmat3(x, y, w));
  return vec3(inverse(rows) * (clip - glm::dvec3(s.clip_x.w, s.clip_y.w, s.clip_w.w)));
}

void SceneBuilder::show(uint32_t x, uint32_t y, uint32_t triangle) {
  const uint32_t flags = surfaces.back().flags;
  const auto surface = static_cast<uint32_t>(surfaces.size() - 1);
  show_bits(x, y,
            {triangle, surface | ((flags & kSurfaceInstanced) != 0 ? kVisibilityInstanced : 0u) |
                           ((flags & kSurfaceFlipped) != 0 ? kVisibilityFlipped : 0u)});
}

void SceneBuilder::show_bits(uint32_t x, uint32_t y, uvec2 bits) { visibility_[size_t{y} * extent.width + x] = bits; }

Case SceneBuilder::finish(std::string name) const {
  Case c = {.name = std::move(name), .extent = extent};
  AttributeParams p = params_of(extent);
  p.vertices = static_cast<uint32_t>(positions.size());
  p.indices = static_cast<uint32_t>(indices.size());
  p.surfaces = static_cast<uint32_t>(surfaces.size());
  c.set_params(p);
  c.set_input("visibility", visibility_);
  c.set_input("positions", positions);
  c.set_input("attributes", attributes);
  c.set_input("indices", indices);
  c.set_input("surfaces", surfaces);
  c.set_input("clip_samples", std::vector<ClipSample>());
  return c;
}

}  // namespace assay::attribute_interpolation
