#version 460
#include "kernels/hi_z/tile_shared.glsl"

void main() { reduce_tile(0u, gl_WorkGroupID.xy); }
