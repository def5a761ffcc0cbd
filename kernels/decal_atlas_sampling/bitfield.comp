#version 460
// The decals of a cell as bits, word after word of all cells (Pettineo 2016). Words times their bits: twice 4096
// turns at most, and one a word.
#include "kernels/decal_atlas_sampling/blend.glsl"
READS(9, uint, decal_bits);

uint next_bit(uint bits) {
#ifdef MUTANT_17  // the highest bit first
  return uint(findMSB(bits));
#else
  return uint(findLSB(bits));
#endif
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  const float d = depth_at(pixel);
  if (d == 0.0) return;
  const Point p = point_at(pixel, d);
  Material m = load_material(pixel);
  const uint all_cells = params.grid.columns * params.grid.rows * params.grid.slices;
  const uint cell = cell_of(params.grid, pixel, d);
  const uint words = (min(params.decals, kMaxClusterDecals) + 31u) / 32u;
  for (uint w = 0u; w < words; ++w) {
    uint bits = decal_bits[w * all_cells + cell];
    while (bits != 0u) {
      while (bits != 0u && !holds(w * 32u + next_bit(bits), p)) bits &= ~(1u << next_bit(bits));
      if (bits == 0u) break;
      const uint bit = next_bit(bits);
      bits &= ~(1u << bit);
      apply_decal(m, w * 32u + bit, p);
    }
  }
  store_material(pixel, m);
}
