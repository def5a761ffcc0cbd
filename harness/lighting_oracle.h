// The shading model in double, with what fp32 may make of it: for the oracles of every kernel that includes
// harness/glsl/lighting.glsl. Host only.
#pragma once
#include "harness/bounded.h"
#include "harness/formats/lighting.h"

namespace assay::shading {

using Colour = Intervals3;

// What a shader reads of an 8-bit unorm channel: Vulkan leaves the conversion's rounding open, and both a division by
// 255 and a product with its rounded inverse lie within 3u.
Interval unorm8(uint32_t code);

struct OracleSurface {
  Ball position, normal, to_eye;
  Colour base_colour;
  Interval metallic, roughness;
  uint32_t features = 0;
};

// What of a light leaves the surface towards the eye, of which this share arrives. A light with a NaN or an infinity in
// its position, colour, direction or cone sheds nothing, nor does one of an unknown kind.
Colour shade(const OracleSurface&, const LightRecord&, Interval visible = exactly(1));
Colour shade_ambient(const OracleSurface&, const vec3& ambient);

}  // namespace assay::shading
