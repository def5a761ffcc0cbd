// Direct light in double: Lambert and GGX with height-correlated Smith and Schlick's Fresnel, under the scene's own
// lights by the formulas of KHR_lights_punctual. Written from the literature, apart from the renderer's.
#pragma once
#include <glm/vec3.hpp>
#include <span>

#include "harness/scene/scene.h"
#include "tests/surface.h"

namespace assay::tests {

struct Shaded {  // what is shaded: of a material, or of a pixel of the G-buffer
  glm::dvec3 base = glm::dvec3(1);
  double roughness = 1, metallic = 0;  // metallic of skin: its thickness
  glm::dvec3 normal = {0, 0, 1};
  uint32_t features = 0;  // cloth, skin and subsurface change the diffuse lobe
};
Shaded shaded_of(const GBufferPixel&, uint32_t features);

// Radiance, and how far a renderer in floats may be from it: to first order, doubled (shading.cpp). Infinite where the
// light is on the surface.
struct Lit {
  glm::dvec3 radiance = {}, error = {};
};
// One light's share. `position` and `eye` are in the world; the direction to the eye is theirs.
Lit reflected(const Shaded&, const glm::dvec3& position, const glm::dvec3& eye, const scene::Light&);
Lit reflected(const Shaded&, const glm::dvec3& position, const glm::dvec3& eye, std::span<const scene::Light>);

// The microfacet part alone, of unit vectors: D V F without n.l.
glm::dvec3 specular(const Shaded&, const glm::dvec3& to_light, const glm::dvec3& to_eye);
// D of GGX by the angle's cosine; alpha is roughness squared.
double ggx(double n_dot_h, double alpha);

}  // namespace assay::tests
