#version 460
#include "kernels/attribute_interpolation/common.glsl"
#include "kernels/attribute_interpolation/ray_triangle.glsl"
#include "kernels/attribute_interpolation/store_packed.glsl"
