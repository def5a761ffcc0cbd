#version 460
// Thickness for subsurface lighting.
#define SHADER_CLASS kShaderSkin
#define CLASS_LAYER skin_layer
#include "kernels/deferred_texturing/listed.glsl"
