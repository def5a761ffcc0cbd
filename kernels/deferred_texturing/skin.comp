#version 460
// Thickness for subsurface lighting.
#define SHADER_CLASS kShaderSkin
#define HAS_SKIN
#include "kernels/deferred_texturing/listed.glsl"
