#version 460
#include "kernels/pixel_commands/sort_keys.glsl"
