#version 460
// Cut out in visibility; seen from both sides. Over waves of one surface.
#define SHADER_CLASS kShaderMasked
#define HAS_MASKED
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
