// The encodings of radiance in double: for the oracles of kernels that include harness/glsl/radiance_encodings.glsl.
// Host only.
#pragma once
#include "harness/bounded.h"
#include "harness/formats/particle.h"

namespace assay::radiance {

// `encoding`: kLight... of formats/particle.h. Words of two colours' halves, or one, the other 0.
glm::dvec3 decoded(uvec2 code, uint32_t encoding);
// The word that is the nearest; of halves of a shared exponent the upper, of others the even. NaN is 0.
uvec2 encoded(const glm::dvec3& colour, uint32_t encoding);

// What colours within an interval may be once they are stored and read again.
struct Stored {
  glm::dvec3 low, high;
};
Stored stored(const Intervals3&, uint32_t encoding);

}  // namespace assay::radiance
