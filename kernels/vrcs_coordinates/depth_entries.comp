#version 460
#define DEPTH_ENTRIES
#include "kernels/vrcs_coordinates/tile.glsl"
