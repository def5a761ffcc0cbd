#version 460
// The material alone. Interpolates.
#define SHADER_CLASS kShaderOpaque
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
