#version 460
#define STORED_NORMAL
#include "kernels/vrcs_coordinates/tile.glsl"
