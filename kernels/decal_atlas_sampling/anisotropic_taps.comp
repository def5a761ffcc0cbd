#version 460
// Several samples along the longer derivative.
#define SAMPLE_TAPS
#include "kernels/decal_atlas_sampling/walk.glsl"

void main() { update_pixel(gl_GlobalInvocationID.xy); }
