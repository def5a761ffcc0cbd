#version 460
#include "harness/glsl/rgba16.glsl"

uvec2 encode(vec3 colour) { return encode_rgba16(colour); }
vec3 decode(uvec2 code) { return decode_rgba16(code); }
#include "kernels/radiance_encodings/round_trip.glsl"
