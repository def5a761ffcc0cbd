#version 460
// Items as their faces, in two passes over a bin: those that look away from the eye store the farthest slice that they
// reach in a column, those that look at it walk there from the nearest. With the eye inside, those that look away walk,
// from the item's first slice.
// Loop turns of an invocation, at 64 threads: 3 faces a pass, of 64 columns each, with 10 cuts and 35 slices that they take
// away, in the second pass 32 more to walk: 23,000; 100 for the bin's words.
#include "kernels/cluster_voxelization/raster.glsl"
#include "kernels/cluster_voxelization/eye.glsl"
#include "kernels/cluster_voxelization/face.glsl"

shared uint farthest[32u * kBinTiles];  // by item and column: the slice after; 0: none

bool may_be_inside(uint item_index) {
  for (uint p = 0u; p < kMaxPlanes; ++p)
    if (item_planes[item_index * kMaxPlanes + p].w < 0.0) return false;
  return true;
}

// The face's part of a span in a tile.
ivec2 span_of(FacePlanes planes, ivec2 span, Tile tile) {
  span = within(span, planes.depths);
  for (uint i = 0u; i < 5u && !is_empty(span); ++i) {
    span = cut(span, tile, planes.depths, vec4(planes.normals[i], planes.reach[i].y));
    span = cut(span, tile, planes.depths, vec4(-planes.normals[i], -planes.reach[i].x));
  }
  return span;
}

void pass_face(uint item_index, uint bit, uint face_index, uvec2 first, bool walk) {
  const ClusterItem item = items[item_index];
  if (item.shape == kShapePyramid && face_index == 5u) return;
  const Face face = face_of(item, face_index);
  const bvec2 facing = front_and_back(item, face);
#ifdef MUTANT_20  // the eye is never inside
  const bool inside = false;
#else
  const bool inside = may_be_inside(item_index);
#endif
  if (walk ? !facing.x && !inside : !facing.y) return;
  const FacePlanes planes = planes_of(item, face);
  const ivec2 slices_of_item = ivec2(unpacked(item_bounds[item_index].z));
  // An item that begins before the first slice, or ends beyond the last, may have faces there alone.
#ifdef MUTANT_25  // they are forgotten
  const ivec2 span_of_item = slices_of_item;
#else
  const ivec2 span_of_item = slices_of_item + ivec2(slices_of_item.x == 0 ? -1 : 0, slices_of_item.y + 1 == int(slices()) ? 1 : 0);
#endif
  if (is_empty(slices_of_item)) return;
  for (uint tile = 0u; tile < kBinTiles; ++tile) {
    const uvec2 at = tile_of_bin(first, tile);
    if (!is_in_bounds(item_index, at, at) || !is_in_column(item, face, at)) continue;
    const ivec2 span = span_of(planes, span_of_item, tile_between(at, at));
    if (is_empty(span)) continue;
    const uint to = bit * kBinTiles + tile;
    if (!walk) {
#ifdef MUTANT_21  // the last face's, not the farthest
      farthest[to] = uint(min(span.y, slices_of_item.y) + 1);
#else
      atomicMax(farthest[to], uint(min(span.y, slices_of_item.y) + 1));
#endif
      continue;
    }
    const int nearest = inside ? slices_of_item.x : max(span.x, slices_of_item.x);
#ifdef MUTANT_22  // the farthest is left out
    for (int slice = nearest; slice + 1 < int(farthest[to]); ++slice) mark(tile, slice, bit);
#else
    for (int slice = nearest; slice < int(farthest[to]); ++slice) mark(tile, slice, bit);
#endif
  }
}

void pass_faces(Word word, uvec2 first, bool walk) {
  for (uint i = gl_LocalInvocationID.x; i < 32u * kMaxPlanes; i += THREADS) {
    const uint bit = i / kMaxPlanes;
    if (has_item(word, bit) && is_in_bounds(item_of(word, bit), first, last_of_bin(first)))
      pass_face(item_of(word, bit), bit, i % kMaxPlanes, first, walk);
  }
}

void main() {
  const Word word = word_of_group(gl_WorkGroupID.x);
  const uvec2 first = first_of_bin(gl_WorkGroupID.y);
  if (!is_in_grid(first) || slices() == 0u || !is_word(word)) return;  // the whole group
  clear_bin();
  for (uint i = gl_LocalInvocationID.x; i < 32u * kBinTiles; i += THREADS) farthest[i] = 0u;
  barrier();
  pass_faces(word, first, false);
#ifndef MUTANT_23  // the barrier dropped: faces walk before all have stored
  barrier();
#endif
  pass_faces(word, first, true);
  barrier();
  store_bin(word, first);
}
