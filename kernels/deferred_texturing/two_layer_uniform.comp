#version 460
// Two materials mixed by their heights. Over waves of one surface.
#define SHADER_CLASS kShaderTwoLayer
#define HAS_TWO_LAYER
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
