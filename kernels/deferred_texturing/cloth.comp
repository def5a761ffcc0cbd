#version 460
// A weave that roughens.
#define SHADER_CLASS kShaderCloth
#include "kernels/deferred_texturing/listed.glsl"
