#version 460
#define FROM_KEYS other_keys
#define FROM other_sorted
#define TO_KEYS sort_keys
#define TO sorted
#include "kernels/pixel_commands/sort_scatter.glsl"
