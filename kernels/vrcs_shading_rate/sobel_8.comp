#version 460
#define TILE 8
#define SOBEL
#include "kernels/vrcs_shading_rate/common.glsl"
