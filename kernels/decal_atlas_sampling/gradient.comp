#version 460
// Gradients are given to the sampler.
#include "kernels/decal_atlas_sampling/walk.glsl"

void main() { update_pixel(gl_GlobalInvocationID.xy); }
