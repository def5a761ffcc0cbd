#version 460
// The material alone.
#define SHADER_CLASS kShaderOpaque
#define CLASS_LAYER opaque_layer
#include "kernels/deferred_texturing/listed.glsl"
