#version 460
// As masked, tinted by instance. Over waves of one surface.
#define SHADER_CLASS kShaderFoliage
#define HAS_FOLIAGE
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
