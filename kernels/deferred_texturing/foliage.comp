#version 460
// As masked, tinted by instance.
#define SHADER_CLASS kShaderFoliage
#include "kernels/deferred_texturing/listed.glsl"
