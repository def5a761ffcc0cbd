#version 460
// Two materials mixed by their heights. Interpolates.
#define SHADER_CLASS kShaderTwoLayer
#define HAS_TWO_LAYER
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
