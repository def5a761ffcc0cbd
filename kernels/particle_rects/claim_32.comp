#version 460
// A thread a particle: the rectangles of 32x32 that they had. Smaller ones are claimed once it is known who steps down.
#include "kernels/particle_rects/common.glsl"

void main() { claim(region_of(kRectSizes), gl_GlobalInvocationID.x); }
