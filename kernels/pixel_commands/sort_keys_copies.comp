#version 460
#define COPY_BITS
#include "kernels/pixel_commands/sort_keys.glsl"
