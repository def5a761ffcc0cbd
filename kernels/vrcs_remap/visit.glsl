// A pass between the prefix and the postfix, as small as can be: a pixel comes out as its place, and the stores to each
// pixel are counted. The outputs are cleared before. No loops.
#extension GL_KHR_shader_subgroup_basic : require
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_remap/layout.h"
#include "harness/glsl/tiles.glsl"

UPDATES(1, uint, values);
UPDATES(2, uint, visits);
UPDATES(3, uint, waves);
PARAMS(RemapParams);
#define VRCS_EXTENT uvec2(params.width, params.height)
#define VRCS_RESULT uint
#define VRCS_FRAME params.frame
#include "harness/glsl/vrcs.glsl"

// From 1 on.
uint place_of(uvec2 pixel) { return pixel.y * params.width + pixel.x + 1u; }

// Of several stores to a pixel the largest value is kept: lists that name a pixel twice have one outcome.
void vrcs_store(uvec2 pixel, uint result) {
  const uint at = place_of(pixel) - 1u;
#ifdef MUTANT_1  // a copy comes out as its own place
  result = place_of(pixel);
#endif
#ifdef MUTANT_2  // stores are not counted
  visits[at] = 1u;
#else
  atomicAdd(visits[at], 1u);
#endif
  atomicMax(values[at], result);
}

// By the lanes with work, and by one of each subgroup.
void count_wave(uint counter) {
  if (subgroupElect()) atomicAdd(waves[counter], 1u);
}
