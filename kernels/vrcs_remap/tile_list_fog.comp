#version 460
#define VRCS_SHADE_FOG
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_remap/tile.glsl"
