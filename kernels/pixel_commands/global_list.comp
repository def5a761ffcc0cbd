#version 460
#include "kernels/pixel_commands/global_list.glsl"
