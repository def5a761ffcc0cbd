// Where levels lie, what a texel is, and how texels are joined. A texel is a uvec2 of floats' bits, least and greatest:
// none is negative, so bits are in the order of the floats, whatever a device does to denormal numbers.
// Loop turns of an invocation: the level's number to find its place, for each level that is read or written.
#include "harness/glsl/ports.glsl"
#include "kernels/hi_z/layout.h"
#include "harness/glsl/tiles.glsl"

layout(binding = 0) uniform texture2D depth;
UPDATES(1, vec2, ranges);
PARAMS(HiZParams);

const uvec2 kNothing = uvec2(0xffffffffu, 0u);  // joined with anything, it is that

uvec2 size_of(uint level) {
#ifdef MUTANT_1  // what is left over at an odd side is dropped
  return max(uvec2(params.width, params.height) >> level, uvec2(1u));
#else
  return (uvec2(params.width, params.height) + (1u << level) - 1u) >> level;
#endif
}

// Whether there is such a level: the first, and any below which one texel is not all yet.
bool is_level(uint level) { return level == 1u || any(greaterThan(size_of(level - 1u), uvec2(1u))); }

// Of its first texel; of level 0, the image, 0.
uint place_of(uint level) {
  uint place = 0u;
  for (uint i = 1u; i < level; ++i) place += size_of(i).x * size_of(i).y;
  return place;
}

uvec2 joined(uvec2 a, uvec2 b) {
#ifdef MUTANT_2  // the farthest for the nearest
  return uvec2(min(a.x, b.x), min(a.y, b.y));
#else
  return uvec2(min(a.x, b.x), max(a.y, b.y));
#endif
}

// A pixel; what is not a number, negative, or the background is 0.
uvec2 pixel_range(uvec2 at) {
  if (any(greaterThanEqual(at, uvec2(params.width, params.height)))) return kNothing;
  const uint bits = floatBitsToUint(texelFetch(depth, ivec2(at), 0).r);
#ifdef MUTANT_3  // NaN passes, as beyond infinity
  return uvec2(bits & 0x7fffffffu);
#else
  return uvec2(bits > 0x7f800000u ? 0u : bits);
#endif
}

// A texel of a level that begins at `place`, or of level 0 a pixel; beyond the level's end, nothing.
uvec2 range_at(uint level, uint place, uvec2 at) {
  if (level == 0u) return pixel_range(at);
  const uvec2 size = size_of(level);
#ifdef MUTANT_4  // beyond a row's end, the next row
  if (at.y >= size.y) return kNothing;
#else
  if (any(greaterThanEqual(at, size))) return kNothing;
#endif
  return floatBitsToUint(ranges[place + at.y * size.x + at.x]);
}

// What texel `at` of a level covers of the level below.
uvec2 range_below(uint level, uvec2 at) {
  const uint below = level - 1u, place = place_of(below);
  const uvec2 first = 2u * at;
  const uvec2 upper = joined(range_at(below, place, first), range_at(below, place, first + uvec2(1u, 0u)));
#ifdef MUTANT_5  // the fourth is forgotten
  return joined(upper, range_at(below, place, first + uvec2(0u, 1u)));
#else
  const uvec2 lower = joined(range_at(below, place, first + uvec2(0u, 1u)), range_at(below, place, first + 1u));
  return joined(upper, lower);
#endif
}

void store(uint level, uvec2 at, uvec2 range) {
  const uvec2 size = size_of(level);
  if (!is_level(level) || any(greaterThanEqual(at, size))) return;
  ranges[place_of(level) + at.y * size.x + at.x] = uintBitsToFloat(range);
}
