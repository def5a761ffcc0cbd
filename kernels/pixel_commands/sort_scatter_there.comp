#version 460
#define FROM_KEYS sort_keys
#define FROM sorted
#define TO_KEYS other_keys
#define TO other_sorted
#include "kernels/pixel_commands/sort_scatter.glsl"
