#version 460
// A detail texture over base colour and emission.
#define SHADER_CLASS kShaderEmissiveDetail
#define HAS_EMISSIVE_DETAIL
#include "kernels/deferred_texturing/listed.glsl"
