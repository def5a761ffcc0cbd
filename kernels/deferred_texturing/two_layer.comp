#version 460
// Two materials mixed by their heights.
#define SHADER_CLASS kShaderTwoLayer
#include "kernels/deferred_texturing/listed.glsl"
