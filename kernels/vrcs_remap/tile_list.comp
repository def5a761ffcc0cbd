#version 460
#include "harness/glsl/ports.glsl"
READS(4, uint, tiles);
READS(5, uint, entries);
#include "kernels/vrcs_remap/tile.glsl"
