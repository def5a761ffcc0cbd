#version 460
#include "kernels/pixel_commands/count_chained.glsl"
