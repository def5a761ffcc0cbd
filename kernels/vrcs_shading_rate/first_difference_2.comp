#version 460
#define TILE 2
#define FIRST
#include "kernels/vrcs_shading_rate/common.glsl"
