#version 460
// What all passes of the frame use: a search of the table.
#include "kernels/cluster_slices/common.glsl"

#include "harness/glsl/clusters.glsl"

uint slice_at(float d) { return slice_of(params.grid, d); }
