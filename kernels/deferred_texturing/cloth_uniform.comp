#version 460
// A weave that roughens. Over waves of one surface.
#define SHADER_CLASS kShaderCloth
#define HAS_CLOTH
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
