#version 460
#include "kernels/vrcs_coordinates/tile.glsl"
