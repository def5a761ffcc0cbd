// What the variants that rasterise must mark, and may.
#pragma once
#include "kernels/cluster_voxelization/apart.h"

namespace assay::cluster_voxelization {

struct Bits {
  std::vector<uint> low, high;
  explicit Bits(uint64_t n) : low(n), high(n) {}
  static void set(std::vector<uint>& to, uint item, uint64_t cell, uint64_t cells) {
    to[item / 32 * cells + cell] |= 1u << item % 32;
  }
  static bool has(const std::vector<uint>& in, uint item, uint64_t cell, uint64_t cells) {
    return in[item / 32 * cells + cell] >> item % 32 & 1;
  }
};
Expected expect_bits(const Bits&);

// The depths of a column and row that a pair of reversed depths, least and greatest, stands for: exactly, and as wide
// as a device may see it. Metres; a first beyond its second: none.
struct Depths {
  dvec2 exact{0, HUGE_VAL}, wide{0, HUGE_VAL};
};
Depths depths_of(const vec2& reversed, float near_plane);

// "hexahedra_lights", "hi_z_lights", "two_pass_lights" and so on, of items first .. first + count - 1 of the case.
// `may_touch`: bits of pairs that are not certainly apart; no other is marked as touching.
void answer_raster(const Case&, Answer&, const std::string& kind, uint first, uint count,
                   const std::vector<uint>& may_touch);

// "smaller_lights" and so on: of each cell, the shorter of two lists, its column's of all slices (of `hi_z`, the same
// items') and that of its bin and slice.
void answer_smaller(const Case&, Answer&, const std::string& kind, uint first, uint count, const Bits& hi_z);

}  // namespace assay::cluster_voxelization
