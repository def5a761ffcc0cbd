// A pass between the prefix and the postfix, as small as can be: a pixel comes out as its place, and the stores to each
// pixel are counted. The outputs are cleared before. No loops.
#extension GL_KHR_shader_subgroup_basic : require
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_remap/layout.h"
#include "harness/glsl/tiles.glsl"

layout(binding = 0) uniform utexture2D visibility;
UPDATES(1, uint, values);
UPDATES(2, uint, visits);
UPDATES(3, uint, waves);
PARAMS(RemapParams);
#define VRCS_EXTENT uvec2(params.width, params.height)
#define VRCS_RESULT uint
#define VRCS_FRAME params.frame
#include "harness/glsl/vrcs.glsl"

// Of several stores to a pixel the largest value is kept: lists that name a pixel twice have one outcome.
void vrcs_store(uvec2 pixel, uint result) {
  const uint at = pixel.y * params.width + pixel.x;
#ifdef MUTANT_1  // a copy comes out as its own place
  result = at + 1u;
#endif
#ifdef MUTANT_2  // stores are not counted
  visits[at] = 1u;
#else
  atomicAdd(visits[at], 1u);
#endif
  atomicMax(values[at], result);
}

bool has_surface(uvec2 pixel) {
  return texelFetch(visibility, ivec2(pixel), 0).xy != uvec2(kVisibilityNone);
}

// Place from 1 on, and the depth's code where there is one.
uint value_of(VrcsPixel p) {
  const uint place = p.at.y * params.width + p.at.x + 1u;
#ifdef MUTANT_3  // depth is dropped
  return place;
#else
  return place + p.depth * 2654435769u;
#endif
}

void visit(VrcsPixel p, uint wave_counter) {
#ifdef MUTANT_4  // sky is shaded
  if (p.code == kVrcsNoWork) return;
#else
  if (p.code == kVrcsSky || p.code == kVrcsNoWork) return;
#endif
  if (subgroupElect()) atomicAdd(waves[wave_counter], 1u);
#ifndef MUTANT_5  // where all are shaded, pixels without a surface are too
  if (p.code == kVrcsAll && !has_surface(p.at)) return;
#endif
  vrcs_postfix(p, value_of(p));
}
