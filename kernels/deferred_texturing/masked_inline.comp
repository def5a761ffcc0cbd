#version 460
// Cut out in visibility; seen from both sides. Interpolates.
#define SHADER_CLASS kShaderMasked
#define HAS_MASKED
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
