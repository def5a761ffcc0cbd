#version 460
// Water that darkens and smooths.
#define SHADER_CLASS kShaderWet
#include "kernels/deferred_texturing/listed.glsl"
