#version 460
#include "kernels/cluster_voxelization/mark_hexahedra.glsl"
