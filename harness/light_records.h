// Lights made by hand, for the cases of kernels that are lit. Host only.
#pragma once
#include "harness/formats/light.h"
#include "harness/oracle.h"

namespace assay {

LightRecord directional(const glm::dvec3& direction, const vec3& colour);
LightRecord point(const glm::dvec3& position, double range, const vec3& colour);
// `inner` and `outer`: half angles of the cone.
LightRecord spot(const glm::dvec3& position, const glm::dvec3& direction, double range, double inner_rad,
                 double outer_rad, const vec3& colour);
// Of any kind, about a point, bright enough to be seen there; `reach`: metres about it.
LightRecord random_light(Pcg32&, const glm::dvec3& target, double reach);

}  // namespace assay
