#version 460
// Neighbours count of the same surface at about the same depth, so that nothing spills over a silhouette.
#include "kernels/vrcs_deblock/apart.glsl"

layout(binding = 8) uniform utexture2D visibility;
layout(binding = 9) uniform texture2D depth;

uint surface_of(ivec2 pixel) { return texelFetch(visibility, pixel, 0).g & kVisibilitySurfaceMask; }
uint depth_bits(ivec2 pixel) { return floatBitsToUint(texelFetch(depth, pixel, 0).r); }

// Bits of floats that are not negative are ordered as the floats are; whatever else stands there is far off.
bool belongs(ivec2 pixel, ivec2 neighbour) {
#ifndef MUTANT_14  // surfaces are not asked for
  if (surface_of(pixel) != surface_of(neighbour)) return false;
#endif
  const uint a = depth_bits(pixel), b = depth_bits(neighbour);
#ifdef MUTANT_15  // the farther neighbour is close, however far
  return b <= a || b - a <= kCloseDepths;
#else
  return max(a, b) - min(a, b) <= kCloseDepths;
#endif
}
