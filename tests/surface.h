// From a hit of the ray caster to what the frame should keep of the pixel: the surface's frame, its material over the
// pixel's footprint as ranges, and whether a texel of the G-buffer lies within them.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "tests/filter.h"
#include "tests/raycaster.h"

namespace assay::tests {

struct SurfacePoint {
  uint32_t material = 0;
  glm::dvec3 position;         // relative to the camera, world axes, metres
  glm::dvec3 normal, tangent;  // world, unit, on the side that the mesh says
  double handedness = 1;       // bitangent = handedness * cross(normal, tangent)
  bool front = true;           // the side from which its triangle is counter-clockwise
  glm::dvec3 per_x, per_y;     // the position's change a pixel, along the triangle
  double depth_error = 0;      // relative, of a depth that a rasteriser interpolates
  Footprint footprint;         // its errors are those of the stored weights and derivatives
};
// Of a hit that is no background.
SurfacePoint surface_at(const scene::Scene&, const scene::Camera&, Extent, double x, double y, const Hit&);

struct Appearance {
  std::array<Range, 3> base;  // linear
  Range roughness, metallic, occlusion;
  std::array<Range, 3> emissive;
  glm::dvec3 normal;      // world, turned to the seen side where both sides are seen
  double normal_rad = 0;  // by which it may be off
};
// Nothing for the classes whose texturing has rules of its own that this does not repeat: two-layer, wet, foliage.
std::optional<Appearance> appearance_of(const scene::Scene&, const SurfacePoint&, Filter&);

// A pixel of the G-buffer (formats/gbuffer.h), as its bytes are.
struct GBufferPixel {
  std::array<uint8_t, 4> base_roughness = {};
  std::array<int16_t, 2> normal = {};
  std::array<uint8_t, 2> metallic_occlusion = {};
  uint32_t emissive = 0;
  bool operator==(const GBufferPixel&) const = default;
};
// Of a number kept in 8 bits: either code next to it. Roots of a range. What is wrong with a number, or nothing.
Range stored(const Range&);
Range rooted(const Range&);
std::string outside(const char* channel, double got, const Range& allowed);
// An octahedral code may be either neighbour: a step in x and y moves the vector by sqrt(6) steps, at a length of
// 1 / sqrt(3) or more.
constexpr double kOctahedralError_rad = 1.01 * 4.242640687 / 32767;
glm::dvec3 octahedral_direction(const std::array<int16_t, 2>& code);
glm::dvec3 shared_exponent_radiance(uint32_t code);
// Which channels lie outside what the material (by name) allows, with both; empty if none does.
std::string disagreement(const Appearance&, const GBufferPixel&, const std::string& name);

}  // namespace assay::tests
