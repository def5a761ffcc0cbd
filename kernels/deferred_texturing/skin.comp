#version 460
// Thickness for subsurface lighting.
#define SHADER_CLASS kShaderSkin
#include "kernels/deferred_texturing/listed.glsl"
