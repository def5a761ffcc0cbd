// Items are rasterised: which of them the bin sees, then, a thread an item and a column, the slices between the faces of
// those. Loop turns of an invocation, at 32 threads: 64 pairs of an item and a column, each with 30 half-spaces, 33
// slices that they cut off and 32 to mark; 130 for the bin's words.
#include "kernels/cluster_voxelization/raster.glsl"

READS(7, Outline, outlines);
READS(8, vec4, outline_planes);
#ifdef HI_Z
#include "kernels/cluster_voxelization/depths.glsl"
#endif

shared uint listed[32];
shared uint listed_count;

ivec2 span_of(uint item_index, Tile tile, vec2 tile_depths) {
  const Outline outline = outlines[item_index];
  const vec2 depths = vec2(max(outline.nearest, tile_depths.x), min(outline.farthest, tile_depths.y));
  ivec2 span = within(ivec2(unpacked(item_bounds[item_index].z)), depths);
  for (uint p = 0u; p < kMaxPlanes && !is_empty(span); ++p)
    span = cut(span, tile, depths, item_planes[item_index * kMaxPlanes + p]);
  for (uint p = 0u; p < outline.planes && !is_empty(span); ++p)
    span = cut(span, tile, depths, outline_planes[item_index * kMaxOutline + p]);
  return span;
}

bool is_in_bin(uint item_index, uvec2 first) {
  const uvec2 last = last_of_bin(first);
  return is_in_bounds(item_index, first, last) &&
         !is_empty(span_of(item_index, tile_between(first, last), vec2(0.0, kFarthest)));
}

void mark_tile(uint item_index, uint bit, uvec2 at, uint tile) {
  if (!is_in_bounds(item_index, at, at)) return;  // nor are columns and rows that the grid has not
#ifdef HI_Z
  const ivec2 span = span_of(item_index, tile_between(at, at), depths_of(at));
#else
  const ivec2 span = span_of(item_index, tile_between(at, at), vec2(0.0, kFarthest));
#endif
  for (int slice = span.x; slice <= span.y; ++slice) mark(tile, slice, bit);
}

void main() {
  const Word word = word_of_group(gl_WorkGroupID.x);
  const uvec2 first = first_of_bin(gl_WorkGroupID.y);
  const uint thread = gl_LocalInvocationID.x;
  if (!is_in_grid(first) || slices() == 0u || !is_word(word)) return;  // the whole group
  clear_bin();
  if (thread == 0u) listed_count = 0u;
  barrier();
  if (thread < 32u && has_item(word, thread) && is_in_bin(item_of(word, thread), first))
    listed[atomicAdd(listed_count, 1u)] = thread;
#ifndef MUTANT_16  // the barrier dropped: the list is not yet written
  barrier();
#endif
  for (uint i = thread; i < listed_count * kBinTiles; i += THREADS) {
    const uint bit = listed[i / kBinTiles], tile = i % kBinTiles;
    mark_tile(item_of(word, bit), bit, tile_of_bin(first, tile), tile);
  }
#ifndef MUTANT_17  // the barrier dropped: what higher subgroups have yet to mark is missing
  barrier();
#endif
  store_bin(word, first);
}
