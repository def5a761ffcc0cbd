#version 460
// Cut out in visibility; seen from both sides.
#define SHADER_CLASS kShaderMasked
#include "kernels/deferred_texturing/listed.glsl"
