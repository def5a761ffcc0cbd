#version 460
// Two materials mixed by their heights.
#define SHADER_CLASS kShaderTwoLayer
#define CLASS_LAYER two_layer_layer
#include "kernels/deferred_texturing/listed.glsl"
