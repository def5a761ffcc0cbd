#version 460
#define SHADOW_FILTER 7
#include "kernels/shadow_lookup/lookup.glsl"
