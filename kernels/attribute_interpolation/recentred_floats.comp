#version 460
#include "kernels/attribute_interpolation/common.glsl"
#include "kernels/attribute_interpolation/recentred.glsl"
#include "kernels/attribute_interpolation/store_floats.glsl"
