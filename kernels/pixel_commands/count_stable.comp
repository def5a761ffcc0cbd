#version 460
#define STABLE
#include "kernels/pixel_commands/count.glsl"
