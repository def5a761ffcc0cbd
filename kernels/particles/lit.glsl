// Ambient light and that of every record. Loop turns of an invocation: 32,768.
#include "harness/glsl/particle_surface.glsl"
READS(5, LightRecord, lights);

vec3 lit(ParticleRecord p, vec3 position) {
  const Surface s = particle_surface(p, position);
  vec3 sum = shade_ambient(s, params.ambient);
  const uint count = min(params.lights, kMostLights);
#ifdef MUTANT_15  // the last is left out
  for (uint i = 0u; i + 1u < count; ++i) sum += shade(s, lights[i], 1.0);
#else
  for (uint i = 0u; i < count; ++i) sum += shade(s, lights[i], 1.0);
#endif
  return sum;
}
