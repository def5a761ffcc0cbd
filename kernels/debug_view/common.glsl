// Colours of pixels. Integers only, so that there is one right answer.
#include "harness/glsl/ports.glsl"
#include "kernels/debug_view/layout.h"
#include "harness/glsl/tiles.glsl"

layout(binding = 0) uniform utexture2D visibility;
READS(1, SurfaceRecord, surfaces);
READS(2, uint, material_colours);
WRITES(3, uint, image);
PARAMS(ViewParams);

// The finaliser of MurmurHash3 (Appleby, 2011): every input bit reaches every output bit.
uint mixed(uint h) {
  h = (h ^ h >> 16) * 0x85ebca6bu;
  h = (h ^ h >> 13) * 0xc2b2ae35u;
  return h ^ h >> 16;
}

// Channels from 64 to 191: neither lost in the dark nor taken for white.
uint hashed_colour(uint h) { return 0xff000000u | ((mixed(h) & 0x7f7f7fu) + 0x404040u); }

// (part of a + (4 - part) of b) / 4 in each channel, rounded down.
uint blended(uint a, uint b, uint part) {
  const uint low = ((a & 0xff00ffu) * part + (b & 0xff00ffu) * (4u - part)) >> 2 & 0xff00ffu;
  const uint middle = ((a >> 8 & 0xffu) * part + (b >> 8 & 0xffu) * (4u - part)) >> 2;
  return 0xff000000u | middle << 8 | low;
}

// The same brightness without hue, for views whose own colours mean something. Weights of Rec. 601 in 256ths.
uint greyed(uint colour) {
  const uint grey = (77u * (colour & 0xffu) + 150u * (colour >> 8 & 0xffu) + 29u * (colour >> 16 & 0xffu)) >> 8;
  return 0xff000000u | grey * 0x010101u;
}

uvec2 visible_at(uvec2 pixel) { return texelFetch(visibility, ivec2(pixel), 0).xy; }

bool is_nothing(uvec2 visible) { return visible == uvec2(kVisibilityNone); }

uint material_colour(uvec2 visible) {
  if (is_nothing(visible)) return kBackgroundColour;
#ifdef MUTANT_1
  const uint surface = visible.y & ~kVisibilityFlipped;
#else
  const uint surface = visible.y & kVisibilitySurfaceMask;
#endif
  if (surface >= params.surfaces) return kBrokenColour;
  const uint material = surfaces[surface].material;
  if (material >= params.materials) return kBrokenColour;
  return material_colours[material] | 0xff000000u;
}

uint triangle_colour(uvec2 visible) {
  if (is_nothing(visible)) return kBackgroundColour;
  const uint surface = visible.y & kVisibilitySurfaceMask;
#ifdef MUTANT_2
  return hashed_colour(visible.x);
#else
  return hashed_colour(visible.x ^ mixed(surface + 1u));
#endif
}
