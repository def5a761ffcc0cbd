#version 460
// A detail texture over base colour and emission.
#define SHADER_CLASS kShaderEmissiveDetail
#define CLASS_LAYER emissive_detail_layer
#include "kernels/deferred_texturing/listed.glsl"
