#version 460
#define FROM_KEYS other_keys
#include "kernels/pixel_commands/sort_count.glsl"
