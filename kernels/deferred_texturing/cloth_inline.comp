#version 460
// A weave that roughens. Interpolates.
#define SHADER_CLASS kShaderCloth
#define HAS_CLOTH
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
