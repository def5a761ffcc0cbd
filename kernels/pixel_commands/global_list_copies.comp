#version 460
#define COPY_BITS
#include "kernels/pixel_commands/global_list.glsl"
