// What vertices and fragments bind alike, and which particles are drawn at all.
#ifndef PARTICLES_COMMON
#define PARTICLES_COMMON
#include "harness/formats/particle.h"
#include "harness/glsl/lighting.glsl"
#include "harness/glsl/particles.glsl"
#include "harness/glsl/ports.glsl"
#include "kernels/particles/layout.h"

READS(0, ParticleRecord, particles);
READS(1, uint, order);
PARAMS(ParticlesParams);

bool all_within(vec3 v, float most) { return all(lessThanEqual(abs(v), vec3(most))); }
float largest(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// Comparisons are false of NaN.
bool is_drawn(ParticleRecord p) {
#ifdef MUTANT_1  // whatever the numbers are
  return true;
#else
  return all_within(p.centre, kFarthest) && all_within(p.right, kFarthest) && all_within(p.up, kFarthest) &&
         largest(p.right) >= kSmallest && largest(p.up) >= kSmallest && all_within(p.albedo, kGreatestRadiance) &&
         p.opacity >= kLeastShown && p.quality >= kLeastShown && abs(p.softness) <= kFarthest;
#endif
}

vec2 corner(uint i) { return vec2(i == 1u || i == 2u ? 1.0 : -1.0, i >= 2u ? 1.0 : -1.0); }
#endif
