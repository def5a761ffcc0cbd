#version 460
// A weave that roughens.
#define SHADER_CLASS kShaderCloth
#define CLASS_LAYER cloth_layer
#include "kernels/deferred_texturing/listed.glsl"
