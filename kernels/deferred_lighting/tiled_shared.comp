#version 460
// A group of 16x16 pixels walks the lights together, 64 at a time through shared memory: each record is fetched once a
// group instead of once a pixel.
#include "kernels/deferred_lighting/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

const uint kBatch = 64u;
shared LightRecord batch[kBatch];

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  const float d = depth_at(pixel);  // 0 off the screen too: every thread stays for the barriers
  Lit lit;
  if (d != 0.0) lit = start(pixel, d);
  const uint count = light_count();
  for (uint first = 0u; first < count; first += kBatch) {
    const uint mine = first + gl_LocalInvocationIndex;
    if (gl_LocalInvocationIndex < kBatch && mine < count) batch[gl_LocalInvocationIndex] = lights[mine];
#ifndef MUTANT_8  // the barrier dropped: read before the first subgroups have fetched
    barrier();
#endif
#ifdef MUTANT_9  // a whole batch though fewer lights are left
    const uint here = kBatch;
#else
    const uint here = min(count - first, kBatch);
#endif
    if (d != 0.0)
      for (uint i = 0u; i < here; ++i) lit.radiance += lit_by(lit, batch[i]);
#ifndef MUTANT_10  // the barrier dropped: the next batch overwrites what slower subgroups still read
    barrier();
#endif
  }
  if (!on_screen(pixel)) return;
  if (d == 0.0)
    store_background(pixel);
  else
    store(pixel, texel_of(lit.radiance));
}
