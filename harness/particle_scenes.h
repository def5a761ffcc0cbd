// Particles made by hand, for the cases of the kernels that light and draw them. Host only.
#pragma once
#include <vector>

#include "harness/formats/particle.h"
#include "harness/oracle.h"

namespace assay {

// A square quad that faces the eye, which is the origin; turned about its normal. White, half opaque.
ParticleRecord facing_particle(const glm::dvec3& centre, double radius, double turn_rad = 0);
// A puff somewhere in a view of 90 degrees along -z, in front of the eye: distances and sizes are spread evenly by
// their logarithm, a few are long as sparks, a few are at an angle to the eye.
ParticleRecord random_particle(Pcg32&, double nearest, double farthest);

}  // namespace assay
