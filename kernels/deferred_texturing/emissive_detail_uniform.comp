#version 460
// A detail texture over base colour and emission. Over waves of one surface.
#define SHADER_CLASS kShaderEmissiveDetail
#define HAS_EMISSIVE_DETAIL
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
