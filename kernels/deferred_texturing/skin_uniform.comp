#version 460
// Thickness for subsurface lighting. Over waves of one surface.
#define SHADER_CLASS kShaderSkin
#define HAS_SKIN
#define ONE_SURFACE
#include "kernels/deferred_texturing/listed.glsl"
