#version 460
#define UNBOUNDED
#include "kernels/cluster_voxelization/mark.glsl"
