// Items by their outline and faces: which of a word's a bin has, and the slices of one in a column.
#include "kernels/cluster_voxelization/raster.glsl"

READS(7, Outline, outlines);
READS(8, vec4, outline_planes);
#ifdef HI_Z
#include "kernels/cluster_voxelization/depths.glsl"
#endif

shared uint listed[32];  // bits of the word
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

// The word's items that the bin has; for a whole group.
void list_items(Word word, uvec2 first) {
  const uint thread = gl_LocalInvocationID.x;
  if (thread == 0u) listed_count = 0u;
  barrier();
  if (thread < 32u && has_item(word, thread) && is_in_bin(item_of(word, thread), first))
    listed[atomicAdd(listed_count, 1u)] = thread;
#ifndef MUTANT_16  // the barrier dropped: the list is not yet written
  barrier();
#endif
}
