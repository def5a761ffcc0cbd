#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_remap/tile.glsl"
