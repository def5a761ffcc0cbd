#version 460
// Cut out in visibility; seen from both sides.
#define SHADER_CLASS kShaderMasked
#define CLASS_LAYER masked_layer
#include "kernels/deferred_texturing/listed.glsl"
