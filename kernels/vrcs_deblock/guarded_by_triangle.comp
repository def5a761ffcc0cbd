#version 460
// Neighbours count of the same triangle: the source's own attempt, which mends the silhouette and leaves blocks at every
// edge within a surface.
#include "kernels/vrcs_deblock/apart.glsl"

layout(binding = 8) uniform utexture2D visibility;

bool belongs(ivec2 pixel, ivec2 neighbour) {
#ifdef MUTANT_16  // triangles of all surfaces alike
  return texelFetch(visibility, pixel, 0).r == texelFetch(visibility, neighbour, 0).r;
#else
  return texelFetch(visibility, pixel, 0).rg == texelFetch(visibility, neighbour, 0).rg;
#endif
}
