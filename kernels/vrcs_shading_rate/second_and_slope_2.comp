#version 460
#define TILE 2
#define SLOPE
#include "kernels/vrcs_shading_rate/common.glsl"
