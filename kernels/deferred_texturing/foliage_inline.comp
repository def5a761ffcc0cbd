#version 460
// As masked, tinted by instance. Interpolates.
#define SHADER_CLASS kShaderFoliage
#define HAS_FOLIAGE
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
