// What the variants that rasterise share. A group has 32 items of one kind and a bin of kBinSide columns and as many rows,
// over all slices: a word of each of the bin's cells. Of an item, a half-space leaves a run of slices in a column: a span.
#include "kernels/cluster_voxelization/word.glsl"

layout(constant_id = 0) const uint THREADS = 256u;  // a multiple of 32
layout(local_size_x_id = 0) in;
READS(2, uvec4, item_bounds);
READS(3, vec4, item_planes);

const uint kBinTiles = kBinSide * kBinSide;
const float kFarthest = 3e38;  // beyond all
shared uint cell_bits[kBinTiles * kMaxClusterSlices];

uvec2 first_of_bin(uint bin) {
  const uint across = (columns() + kBinSide - 1u) / kBinSide;
  return uvec2(bin % across, bin / across) * kBinSide;
}
uvec2 last_of_bin(uvec2 first) {
#ifdef MUTANT_15  // a bin ends a column and a row early
  return min(first + kBinSide - 2u, uvec2(columns(), rows()) - 1u);
#else
  return min(first + kBinSide - 1u, uvec2(columns(), rows()) - 1u);
#endif
}
// The i-th column and row of a bin; may lie outside the grid.
uvec2 tile_of_bin(uvec2 first, uint i) { return first + uvec2(i % kBinSide, i / kBinSide); }
bool is_in_grid(uvec2 at) { return at.x < columns() && at.y < rows(); }

// First in bits 0..15, last above.
uvec2 unpacked(uint first_and_last) { return uvec2(first_and_last & 0xffffu, first_and_last >> 16u); }

// Whether the item's bounds have a column and a row of first .. last.
bool is_in_bounds(uint item_index, uvec2 first, uvec2 last) {
  const uvec4 bounds = item_bounds[item_index];
  const uvec2 across = unpacked(bounds.x), down = unpacked(bounds.y);
  return across.x <= across.y && across.x <= last.x && across.y >= first.x &&  // a first beyond its last: none
         down.x <= down.y && down.x <= last.y && down.y >= first.y;
}

struct Tile {
  vec2 x;  // slopes
  vec2 y;
};
Tile tile_between(uvec2 first, uvec2 last) {
  return Tile(vec2(column_edge(first.x), column_edge(last.x + 1u)), vec2(row_edge(first.y), row_edge(last.y + 1u)));
}

// Slices first .. last; a first beyond the last: none.
bool is_empty(ivec2 span) { return span.x > span.y; }

// Slice -1 is what lies before the first, slices() what lies beyond the last.
float start_of(int slice) { return slice < 0 ? 0.0 : slice_edge(uint(slice)); }
float end_of(int slice) { return slice >= int(slices()) ? kFarthest : slice_edge(uint(slice + 1)); }

// Of a span, the slices that reach into depths, a nearest and a farthest.
ivec2 within(ivec2 span, vec2 depths) {
  if (depths.x > depths.y) return ivec2(1, 0);
  while (span.x <= span.y && end_of(span.x) < depths.x) ++span.x;
  while (span.x <= span.y && start_of(span.y) > depths.y) --span.y;
  return span;
}

// Of a span in a tile, what a half-space leaves: inside is dot(plane.xyz, p) <= plane.w. Where the tile is at its lowest
// on the inner side of a plane through the eye, depth helps: near slices are outside; else far ones are.
ivec2 cut(ivec2 span, Tile tile, vec2 depths, vec4 plane) {
  const float low = interval_at_one(tile.x, tile.y, plane.xyz).x;
  if (low < 0.0) {
#ifdef MUTANT_12  // a slice's near end for its far one
    while (span.x <= span.y && low * min(start_of(span.x), depths.y) > plane.w) ++span.x;
#else
    while (span.x <= span.y && low * min(end_of(span.x), depths.y) > plane.w) ++span.x;
#endif
  } else {
    while (span.x <= span.y && low * max(start_of(span.y), depths.x) > plane.w) --span.y;
  }
  return span;
}

void clear_bin() {
  for (uint i = gl_LocalInvocationID.x; i < kBinTiles * slices(); i += THREADS) cell_bits[i] = 0u;
}
void mark(uint tile, int slice, uint bit) {
  atomicOr(cell_bits[uint(slice) * kBinTiles + tile], 1u << bit);
}
void store_bin(Word word, uvec2 first) {
  for (uint i = gl_LocalInvocationID.x; i < kBinTiles * slices(); i += THREADS) {
    const uvec2 at = tile_of_bin(first, i % kBinTiles);
    if (is_in_grid(at)) store_bits(word, (i / kBinTiles * rows() + at.y) * columns() + at.x, cell_bits[i]);
  }
}
