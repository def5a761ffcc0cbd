#version 460
// A weave that roughens.
#define SHADER_CLASS kShaderCloth
#define HAS_CLOTH
#include "kernels/deferred_texturing/listed.glsl"
