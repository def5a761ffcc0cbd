#version 460
#define SHADOWED
#include "kernels/deferred_lighting/all_lights.glsl"
#include "kernels/deferred_lighting/tile_list.glsl"
