#version 460
#define COPY_BITS
#define PER_TILE
#include "kernels/pixel_commands/scatter.glsl"
