#version 460
#include "harness/glsl/gbuffer.glsl"

uvec2 encode(vec3 colour) { return uvec2(encode_shared_exponent(colour), 0u); }
vec3 decode(uvec2 code) { return decode_shared_exponent(code.x); }
#include "kernels/radiance_encodings/round_trip.glsl"
