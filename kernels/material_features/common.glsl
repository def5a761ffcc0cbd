// What every variant binds, and the two dependent loads that they differ in sharing.
#include "harness/formats/features.h"
#include "harness/glsl/ports.glsl"
#include "kernels/material_features/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform utexture2D visibility;
READS(1, SurfaceRecord, surfaces);
READS(2, MaterialRecord, materials);
WRITES(3, uint, features);
PARAMS(FeatureParams);

bool on_screen(uvec2 pixel) {
#ifdef MUTANT_1
  return pixel.x + 1u < params.width && pixel.y < params.height;
#else
  return pixel.x < params.width && pixel.y < params.height;
#endif
}

// Bits 0 to 29; a pixel without a surface gets 2^30 - 1, which no scene holds.
uint surface_at(uvec2 pixel) {
#ifdef MUTANT_2
  return texelFetch(visibility, ivec2(pixel), 0).y & ~kVisibilityFlipped;
#elif defined(MUTANT_3)
  return texelFetch(visibility, ivec2(pixel), 0).y & ~kVisibilityInstanced;
#elif defined(MUTANT_4)
  return texelFetch(visibility, ivec2(pixel), 0).x & kVisibilitySurfaceMask;
#else
  return texelFetch(visibility, ivec2(pixel), 0).y & kVisibilitySurfaceMask;
#endif
}

uint features_of(uint surface) {
#ifdef MUTANT_5
  if (surface + 1u >= params.surfaces) return 0u;
#else
  if (surface >= params.surfaces) return 0u;
#endif
  const uint material = surfaces[surface].material;
#ifdef MUTANT_6
  return materials[min(material, params.materials - 1u)].features;
#else
  return material < params.materials ? materials[material].features : 0u;
#endif
}

void store(uvec2 pixel, uint bits) {
#ifdef MUTANT_7
  features[pixel.x * params.height + pixel.y] = bits;
#else
  features[pixel.y * params.width + pixel.x] = bits;
#endif
}
