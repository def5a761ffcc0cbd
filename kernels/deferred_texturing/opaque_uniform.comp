#version 460
// The material alone. Over waves of one surface.
#define SHADER_CLASS kShaderOpaque
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
