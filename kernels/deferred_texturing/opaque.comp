#version 460
// The material alone.
#define SHADER_CLASS kShaderOpaque
#include "kernels/deferred_texturing/listed.glsl"
