#version 460
#include "kernels/pixel_commands/scatter.glsl"
