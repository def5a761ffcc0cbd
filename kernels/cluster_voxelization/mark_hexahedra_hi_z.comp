#version 460
#define HI_Z
#include "kernels/cluster_voxelization/mark_hexahedra.glsl"
