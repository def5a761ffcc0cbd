#version 460
#define SHADOWED
#include "kernels/deferred_lighting/cell_lights.glsl"
#include "kernels/deferred_lighting/pixels.glsl"
