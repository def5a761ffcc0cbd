#version 460
// The ballot loop of Lazarek, Hammer 2025 (tile classification), used for loads: each distinct surface of the wave is looked up once,
// with a uniform index, for all lanes that hold it. At most one iteration a lane of the subgroup, so at most 128.
#extension GL_KHR_shader_subgroup_ballot : require
#include "kernels/material_features/common.glsl"

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  const uint surface = surface_at(pixel);
  uint bits = 0u;
  bool waiting = true;
  while (waiting) {
    const uint first = subgroupBroadcastFirst(surface);
    const uint found = features_of(first);
#ifdef MUTANT_10
    bits |= found;
#else
    if (first == surface) bits = found;
#endif
#ifdef MUTANT_11
    waiting = false;
#else
    waiting = first != surface;
#endif
  }
  store(pixel, bits);
}
