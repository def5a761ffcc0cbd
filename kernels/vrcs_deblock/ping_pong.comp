#version 460
// Every neighbour counts, across edges too.
#include "kernels/vrcs_deblock/apart.glsl"

bool belongs(ivec2 pixel, ivec2 neighbour) { return true; }
