#version 460
// Water that darkens and smooths. Over waves of one surface.
#define SHADER_CLASS kShaderWet
#define CLASS_LAYER wet_layer
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
