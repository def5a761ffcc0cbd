#version 460
// Two materials mixed by their heights.
#define SHADER_CLASS kShaderTwoLayer
#define HAS_TWO_LAYER
#include "kernels/deferred_texturing/listed.glsl"
