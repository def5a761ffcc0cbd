#version 460
#define ENCODING kLightRgb9e5
#define ATLAS atlas_rgb9e5
#include "kernels/particle_light_atlas/own.glsl"
#include "kernels/particle_light_atlas/store_word.glsl"
#include "kernels/particle_light_atlas/texels.glsl"
