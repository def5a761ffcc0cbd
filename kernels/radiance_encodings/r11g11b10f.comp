#version 460
#include "harness/glsl/r11g11b10.glsl"

uvec2 encode(vec3 colour) { return uvec2(encode_r11g11b10(colour), 0u); }
vec3 decode(uvec2 code) { return decode_r11g11b10(code.x); }
#include "kernels/radiance_encodings/round_trip.glsl"
