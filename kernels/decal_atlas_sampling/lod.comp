#version 460
// One level, worked out once for all three pages.
#define SAMPLE_LEVEL
#include "kernels/decal_atlas_sampling/walk.glsl"

void main() { update_pixel(gl_GlobalInvocationID.xy); }
