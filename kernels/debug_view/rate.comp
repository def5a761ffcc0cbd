#version 460
// The rate view: how coarsely the pixel's cell may be shaded. A thread a pixel.
#include "kernels/debug_view/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 4) uniform utexture2D rates;
READS(5, uint, vrcs_colours);

uint rate_colour(uint rate) {
  switch (rate) {
    case kRate1x1: return vrcs_colours[kColour1x1];
#ifdef MUTANT_22  // pairs across and down swapped
    case kRate1x2: return vrcs_colours[kColour2x1];
    case kRate2x1: return vrcs_colours[kColour1x2];
#else
    case kRate1x2: return vrcs_colours[kColour1x2];
    case kRate2x1: return vrcs_colours[kColour2x1];
#endif
    case kRate2x2: return vrcs_colours[kColour2x2];
    default: return kBrokenColour;
  }
}

uint shown(uvec2 pixel, uvec2 visible) {
  if (is_nothing(visible)) return kBackgroundColour;
#ifdef MUTANT_23  // a rate a pixel
  const uint rate = texelFetch(rates, ivec2(min(pixel, (uvec2(params.width, params.height) - 1u) / kCellSide)), 0).r;
#else
  const uint rate = texelFetch(rates, ivec2(pixel / kCellSide), 0).r;
#endif
  return blended(rate_colour(rate), greyed(material_colour(visible)), 3u);
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
  image[pixel.y * params.width + pixel.x] = shown(pixel, visible_at(pixel));
}
