#version 460
#define COPY_BITS
#define MATCH_LANES
#include "kernels/pixel_commands/scatter.glsl"
