#version 460
#define TILE 8
#define FIRST
#include "kernels/vrcs_shading_rate/common.glsl"
