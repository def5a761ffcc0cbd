#version 460
#define REBUILT_NORMAL
#include "kernels/vrcs_coordinates/tile.glsl"
