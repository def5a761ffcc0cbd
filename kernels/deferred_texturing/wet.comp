#version 460
// Water that darkens and smooths.
#define SHADER_CLASS kShaderWet
#define CLASS_LAYER wet_layer
#include "kernels/deferred_texturing/listed.glsl"
