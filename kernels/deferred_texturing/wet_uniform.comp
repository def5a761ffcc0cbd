#version 460
// Water that darkens and smooths. Over waves of one surface.
#define SHADER_CLASS kShaderWet
#define HAS_WET
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
