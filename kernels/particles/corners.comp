// The light of a particle's corners, each once, as the vertices of an indexed draw would have it.
#include "kernels/particles/common.glsl"
#include "kernels/particles/lit.glsl"

layout(local_size_x = kCornersGroup) in;
WRITES(6, vec3, corners);

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.drawn * kCorners) return;
  const uint particle = order[i / kCorners];
  corners[i] = vec3(0.0);
  if (particle >= params.particles) return;
  const ParticleRecord p = particles[particle];
#ifdef MUTANT_16  // all at the first
  if (is_drawn(p)) corners[i] = storable(lit(p, particle_position(p, corner(0u))));
#else
  if (is_drawn(p)) corners[i] = storable(lit(p, particle_position(p, corner(i % kCorners))));
#endif
}
