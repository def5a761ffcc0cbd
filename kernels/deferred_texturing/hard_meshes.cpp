// Hard cases of the mesh: what a shader finds that interpolates for itself. The others read what is stored, which says
// the same where the mesh is sound, and nothing of a mesh that was broken afterwards.
#include <limits>

#include "harness/formats/features.h"
#include "harness/formats/visibility.h"
#include "kernels/deferred_texturing/inputs.h"

namespace assay::deferred_texturing {

namespace {

constexpr Extent kExtent = {40, 36};
constexpr Rectangle kAll = {0, 0, 40, 36};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// Stripes, magnified, on one sheet.
Builder striped(const Shape& shape, const Frame& frame = {}) {
  Builder b(kExtent);
  b.textures = {texture_of(
      Format::rgba8_unorm, {4, 4}, 1,
      [](uint32_t x, uint32_t y, uint32_t, uint32_t c) { return 60 * ((x + c) % 3) + (c == 2 ? 100 * (y % 2) : 60u); },
      false)};
  MaterialRecord m = plain_material();
  m.base_texture = texture_name(0, 0);
  b.add_sheet(kAll, b.add_material(m), uv_by_pixel(kAll, vec2(0.01f)), frame, shape);
  return b;
}

// A colour a level, far from its neighbours', on a sheet at this distance.
Builder levelled(double distance) {
  Builder b(kExtent);
  b.textures = {levels_texture(Format::rgba8_unorm, {256, 256}, [](uint32_t level, uint32_t c) {
    return (level + c) % 2 == 0 ? 20 + 10 * level : 240 - 15 * level;
  })};
  MaterialRecord m = plain_material();
  m.base_texture = texture_name(0, 0);
  b.add_sheet(kAll, b.add_material(m), uv_by_pixel(kAll, vec2(0.015f)), {},
              {.depths = {distance, distance, distance, distance}});
  return b;
}

template <class F>
Case broken(F change) {
  Builder b = striped({.depths = {1, 2, 3, 1.5}});
  change(b);
  return b.finish();
}

void scale(Builder& b, float by) {
  for (vec3& p : b.positions) p *= by;
  for (SurfaceRecord& s : b.surfaces) s.clip_x.w *= by, s.clip_y.w *= by, s.clip_w.w *= by;
}

}  // namespace

std::vector<HardCase> mesh_cases() {
  return {
      {"mesh_in_perspective", "depths of 1 to 8 at the corners, a different change in each triangle",
       [] {
         return striped({.depths = {1, 8, 3, 2}}).finish();
       }},
      {"mesh_near_and_far", "127 away, beside a power of two: derivatives are of what is seen, not of it over w",
       [] { return levelled(127).finish(); }},
      {"mesh_curved", "normals lean outwards, under a transform that stretches",
       [] {
         Frame f;
         f.normal = glm::normalize(glm::dvec3(1, 2, -2)), f.tangent = glm::normalize(glm::dvec3(2, 0, 1));
         return striped({.bulge = 0.7}, f).finish();
       }},
      {"mesh_grazing", "depths of 1 and 10^4: a floor up to the horizon",
       [] {
         return striped({.depths = {1e4, 1e4, 1, 1}}).finish();
       }},
      {"mesh_huge", "coordinates of 10^19, whose products overflow",
       [] { return broken([](Builder& b) { scale(b, 1e19f); }); }},
      {"mesh_small", "and of 10^-25", [] { return broken([](Builder& b) { scale(b, 1e-25f); }); }},
      {"mesh_beside_the_pixel", "pixels that the triangle does not cover get weights of a point inside",
       [] {
         return broken([](Builder& b) {
           for (uvec2& v : b.visibility) v.x ^= 1;
         });
       }},
      {"mesh_behind_the_eye", "a corner behind the eye, then all of them",
       [] {
         return broken([](Builder& b) {
           b.positions[3].z -= 20;
           for (size_t i = 0; i < b.visibility.size(); i += 2) b.visibility[i].x = 1;
         });
       }},
      {"mesh_point", "all vertices the same: weights of a third",
       [] {
         return broken([](Builder& b) {
           for (vec3& p : b.positions) p = b.positions[0];
         });
       }},
      {"mesh_line", "two the same: no area, anything within the triangle",
       [] { return broken([](Builder& b) { b.positions[1] = b.positions[0]; }); }},
      {"mesh_nan", "a position that is none: weights of a third, no derivatives",
       [] { return broken([](Builder& b) { b.positions[2].y = kNaN; }); }},
      {"mesh_infinite", "and one without end", [] { return broken([](Builder& b) { b.positions[2].x = -kInf; }); }},
      {"mesh_transform_nan", "a transform that is none",
       [] { return broken([](Builder& b) { b.surfaces[0].clip_w = vec4(kNaN), b.surfaces[0].world_y.x = kNaN; }); }},
      {"mesh_without_normals", "normals and tangents of length 0: +z, +x",
       [] {
         return broken([](Builder& b) {
           for (VertexAttributes& v : b.vertices) v.normal = vec3(0), v.tangent = vec4(0, 0, 0, 1);
         });
       }},
  };
}

}  // namespace assay::deferred_texturing
