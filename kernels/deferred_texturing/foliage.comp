#version 460
// As masked, tinted by instance.
#define SHADER_CLASS kShaderFoliage
#define CLASS_LAYER foliage_layer
#include "kernels/deferred_texturing/listed.glsl"
