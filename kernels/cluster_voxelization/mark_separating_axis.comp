#version 460
#define SEPARATING_AXIS
#include "kernels/cluster_voxelization/mark.glsl"
