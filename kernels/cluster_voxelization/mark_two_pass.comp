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

// In a column that the face reaches in `span`: the farthest slice is stored, or slices are marked from the nearest on.
void store_farthest(uint bit, uint tile, ivec2 span, ivec2 of_item) {
#ifdef MUTANT_21  // the last face's, not the farthest
  farthest[bit * kBinTiles + tile] = uint(min(span.y, of_item.y) + 1);
#else
  atomicMax(farthest[bit * kBinTiles + tile], uint(min(span.y, of_item.y) + 1));
#endif
}
void walk_from_nearest(uint bit, uint tile, ivec2 span, ivec2 of_item, bool inside) {
  const int nearest = inside ? of_item.x : max(span.x, of_item.x);
#ifdef MUTANT_22  // the farthest is left out
  const int end = int(farthest[bit * kBinTiles + tile]) - 1;
#else
  const int end = int(farthest[bit * kBinTiles + tile]);
#endif
  for (int slice = nearest; slice < end; ++slice) mark(tile, slice, bit);
}

// Slices of an item, and one more before the first and beyond the last of the grid: its faces may lie there alone.
ivec2 with_outer(ivec2 span) {
#ifdef MUTANT_25  // they are forgotten
  return span;
#else
  return span + ivec2(span.x == 0 ? -1 : 0, span.y + 1 == int(slices()) ? 1 : 0);
#endif
}

void pass_face(uint item_index, uint bit, uint face_index, uvec2 first, bool walk) {
  const ClusterItem item = items[item_index];
  const Face face = face_of(item, face_index);
  const bvec2 facing = front_and_back(item, face);
#ifdef MUTANT_20  // the eye is never inside
  const bool inside = false;
#else
  const bool inside = may_be_inside(item_index);
#endif
  if (walk ? !facing.x && !inside : !facing.y) return;
  const FacePlanes planes = planes_of(item, face);
  const uvec4 bounds = item_bounds[item_index];
  const ivec2 of_item = ivec2(unpacked(bounds.z)), all = with_outer(of_item);
  const uvec2 across = unpacked(bounds.x), down = unpacked(bounds.y), last = last_of_bin(first);
  if (is_empty(of_item) || is_empty(span_of(planes, all, tile_between(first, last)))) return;
  for (uint y = max(first.y, down.x); y <= min(last.y, down.y); ++y)
    for (uint x = max(first.x, across.x); x <= min(last.x, across.y); ++x) {
      const uvec2 at = uvec2(x, y);
      if (!is_in_column(item, face, at)) continue;
      const ivec2 span = span_of(planes, all, tile_between(at, at));
      if (is_empty(span)) continue;
      const uint tile = (y - first.y) * kBinSide + x - first.x;
      if (walk) walk_from_nearest(bit, tile, span, of_item, inside);
      else store_farthest(bit, tile, span, of_item);
    }
}

void pass_faces(Word word, uvec2 first, bool walk) {
  for (uint i = gl_LocalInvocationID.x; i < 32u * kMaxPlanes; i += THREADS) {
    const uint bit = i / kMaxPlanes, face = i % kMaxPlanes;
    if (!has_item(word, bit) || (face == 5u && items[item_of(word, bit)].shape == kShapePyramid)) continue;
    if (is_in_bounds(item_of(word, bit), first, last_of_bin(first)))
      pass_face(item_of(word, bit), bit, face, first, walk);
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
