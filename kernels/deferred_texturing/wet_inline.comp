#version 460
// Water that darkens and smooths. Interpolates.
#define SHADER_CLASS kShaderWet
#define HAS_WET
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
