#version 460
#define TILE 8
#define SLOPE
#include "kernels/vrcs_shading_rate/common.glsl"
