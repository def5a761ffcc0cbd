#version 460
#define SHADOW_FILTER 2
#include "kernels/shadow_lookup/lookup.glsl"
