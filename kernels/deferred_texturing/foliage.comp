#version 460
// As masked, tinted by instance.
#define SHADER_CLASS kShaderFoliage
#define HAS_FOLIAGE
#include "kernels/deferred_texturing/listed.glsl"
