#version 460
// Cut out in visibility; seen from both sides.
#define SHADER_CLASS kShaderMasked
#define HAS_MASKED
#include "kernels/deferred_texturing/listed.glsl"
