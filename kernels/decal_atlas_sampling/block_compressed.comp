#version 460
// As gradient, from pages in blocks of 4x4.
#define SAMPLE_BLOCKS
#include "kernels/decal_atlas_sampling/walk.glsl"

void main() { update_pixel(gl_GlobalInvocationID.xy); }
