// A particle as lighting.glsl sees it: white and rough, seen from either side; half of the light from behind comes through.
#ifndef HARNESS_GLSL_PARTICLE_SURFACE
#define HARNESS_GLSL_PARTICLE_SURFACE
#include "harness/formats/particle.h"
#include "harness/glsl/lighting.glsl"

// Of the quad's plane, towards the eye; 0 of a quad that has none.
vec3 particle_normal(ParticleRecord p) {
#ifdef MUTANT_9841  // of small quads, shorter than 1
  const vec3 n = unit_or_shorter(cross(p.right, p.up));
#else
  const vec3 n = unit_or_shorter(cross(unit_or_shorter(p.right), unit_or_shorter(p.up)));
#endif
#ifdef MUTANT_9842  // whichever way the axes go round
  return n;
#else
  return dot(n, p.centre) > 0.0 ? -n : n;
#endif
}

Surface particle_surface(ParticleRecord p, vec3 position) {
  return make_surface(position, particle_normal(p), -unit_or_shorter(position), vec3(1.0), 0.0, 1.0,
                      kFeatureSubsurface);
}
#endif
