#version 460
#define MATCH_LANES
#include "kernels/pixel_commands/scatter.glsl"
