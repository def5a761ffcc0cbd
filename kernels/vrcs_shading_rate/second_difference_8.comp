#version 460
#define TILE 8
#include "kernels/vrcs_shading_rate/common.glsl"
