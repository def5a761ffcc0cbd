// The depths of a column and row that have surfaces, as of a depth pyramid.
READS(9, vec2, depth_ranges);  // reversed depth: least, the farthest, and greatest, the nearest; by column and row

const float kLeastDepth = 1e-30, kMostDepth = 1.2676506e30;  // 2^100: between them a quotient is as precise as Vulkan says
const float kQuotient = 1.0 / 1048576.0;                     // six roundings, of which 16 are given

// In metres, nearest and farthest, no less than there is; a nearest beyond the farthest: none.
vec2 depths_of(uvec2 at) {
  const uint exponent = floatBitsToUint(params.near_plane) >> 23u;
  if (exponent < 127u - 38u || exponent >= 127u + 38u) return vec2(0.0, kFarthest);
  const vec2 reversed = depth_ranges[params.first_range + at.y * columns() + at.x];
  const uvec2 bits = floatBitsToUint(reversed);  // a NaN compares with nothing, so bits do
  if (bits.y > 0x7f800000u || bits.x > bits.y) return vec2(0.0, kFarthest);
  if (reversed.y < kLeastDepth) return vec2(kFarthest, 0.0);
  vec2 depths = vec2(0.0, kFarthest);
#ifdef MUTANT_18  // nearest and farthest swapped
  const vec2 ends = reversed.yx;
#else
  const vec2 ends = reversed;
#endif
  if (ends.y <= kMostDepth) depths.x = params.near_plane / ends.y * (1.0 - kQuotient);
#ifdef MUTANT_19  // a background behind surfaces is forgotten
  depths.y = params.near_plane / clamp(ends.x == 0.0 ? ends.y : ends.x, kLeastDepth, kMostDepth) * (1.0 + kQuotient);
#else
  if (ends.x >= kLeastDepth) depths.y = params.near_plane / min(ends.x, kMostDepth) * (1.0 + kQuotient);
#endif
  return depths;
}
