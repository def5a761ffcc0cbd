#version 460
// Lazarek, Hammer 2025, deferred texturing optimisations: where all lanes hold the same surface, broadcasting it tells the compiler
// that the loads are uniform (one scalar load a wave); other waves take the divergent path. Both paths are one shader
// here: the branch is uniform, and the work behind it is too small to be worth a second dispatch.
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_vote : require
#include "kernels/material_features/common.glsl"

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  const uint surface = surface_at(pixel);
#ifdef MUTANT_8
  const bool same = true;
#elif defined(MUTANT_9)
  const bool same = subgroupAllEqual(texelFetch(visibility, ivec2(pixel), 0).x);
#else
  const bool same = subgroupAllEqual(surface);
#endif
  if (same)
    store(pixel, features_of(subgroupBroadcastFirst(surface)));
  else
    store(pixel, features_of(surface));
}
