#version 460
#define CHAINED
#include "kernels/pixel_commands/scan.glsl"
