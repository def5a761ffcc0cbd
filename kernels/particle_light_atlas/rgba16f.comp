#version 460
#include "kernels/particle_light_atlas/own.glsl"
#include "kernels/particle_light_atlas/store_rgba16.glsl"
#include "kernels/particle_light_atlas/texels.glsl"
