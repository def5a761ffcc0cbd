#version 460
// Water that darkens and smooths.
#define SHADER_CLASS kShaderWet
#define HAS_WET
#include "kernels/deferred_texturing/listed.glsl"
