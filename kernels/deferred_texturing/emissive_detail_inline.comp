#version 460
// A detail texture over base colour and emission. Interpolates.
#define SHADER_CLASS kShaderEmissiveDetail
#define HAS_EMISSIVE_DETAIL
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
