#version 460
#define PER_TILE
#include "kernels/pixel_commands/scatter.glsl"
