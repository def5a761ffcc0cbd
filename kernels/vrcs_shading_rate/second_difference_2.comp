#version 460
#define TILE 2
#include "kernels/vrcs_shading_rate/common.glsl"
