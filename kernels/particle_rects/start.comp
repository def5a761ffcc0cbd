#version 460
// A thread a particle and a slot: which size it wants, and that it is nobody's.
#include "kernels/particle_rects/common.glsl"

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < particle_count()) start_particle(i);
  if (i < all_slots()) owners[i] = kNobody;
  if (i == 0u) counts[0] = ParticleRectCounts(0u, 0u, 0u, 0u);
}
