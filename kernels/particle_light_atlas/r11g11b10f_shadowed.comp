#version 460
#define ENCODING kLightR11G11B10
#define SHADOWED
#include "kernels/particle_light_atlas/own.glsl"
#include "kernels/particle_light_atlas/store_word.glsl"
#include "kernels/particle_light_atlas/texels.glsl"
