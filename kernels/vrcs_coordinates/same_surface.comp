#version 460
#define SAME_SURFACE
#include "kernels/vrcs_coordinates/tile.glsl"
