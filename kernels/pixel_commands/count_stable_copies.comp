#version 460
#define COPY_BITS
#define STABLE
#include "kernels/pixel_commands/count.glsl"
