#version 460
#include "harness/glsl/radiance_encodings.glsl"

uvec2 encode(vec3 colour) { return uvec2(encode_radiance(colour, kLightR11G11B10), 0u); }
vec3 decode(uvec2 code) { return decode_radiance(code.x, kLightR11G11B10); }
#include "kernels/radiance_encodings/round_trip.glsl"
