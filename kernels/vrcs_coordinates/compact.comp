#version 460
#define COMPACT
#include "kernels/vrcs_coordinates/tile.glsl"
