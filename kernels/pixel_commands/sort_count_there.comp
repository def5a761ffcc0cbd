#version 460
#define FROM_KEYS sort_keys
#include "kernels/pixel_commands/sort_count.glsl"
