#version 460
#define SHADOW_FILTER 3
#include "kernels/shadow_lookup/lookup.glsl"
