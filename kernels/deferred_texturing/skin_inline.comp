#version 460
// Thickness for subsurface lighting. Interpolates.
#define SHADER_CLASS kShaderSkin
#define HAS_SKIN
#define INTERPOLATES
#include "kernels/deferred_texturing/listed.glsl"
