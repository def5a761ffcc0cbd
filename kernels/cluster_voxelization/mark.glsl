// A group 32 items of one kind and a slice: it owns a word of each of the slice's cells. THREADS / 32 threads walk the
// cells that an item reaches, in blocks of rows.
// Loop turns of an invocation: 8 blocks at 120 columns, the cells of a block over the threads of an item, at most 128,
// each with 6 planes and (in separating_axis) 36 axes.
#include "kernels/cluster_voxelization/word.glsl"

layout(constant_id = 0) const uint THREADS = 256u;  // a multiple of 32
layout(local_size_x_id = 0) in;
READS(2, uvec4, item_bounds);
READS(3, vec4, item_planes);

const uint kBlock = 1024u;  // cells
shared uint cell_bits[kBlock];

struct Cell {
  vec2 x;  // slopes
  vec2 y;
  vec2 z;
};

// The cell's interval along m, with room for rounding: of one at depth 1, so that a far end does not make a near one
// vague. z is not negative.
vec2 interval_of_cell(Cell cell, vec3 m) {
  const vec2 at_one = interval_at_one(cell.x, cell.y, m);
#ifdef MUTANT_11  // the near end alone
  return at_one * cell.z.x;
#else
  return vec2(min(at_one.x * cell.z.x, at_one.x * cell.z.y), max(at_one.y * cell.z.x, at_one.y * cell.z.y));
#endif
}

bool is_outside_planes(uint item_index, Cell cell) {
  for (uint p = 0u; p < kMaxPlanes; ++p) {
    const vec4 plane = item_planes[item_index * kMaxPlanes + p];
    if (interval_of_cell(cell, plane.xyz).x > plane.w) return true;
  }
  return false;
}

#ifdef SEPARATING_AXIS
bool separates(ClusterItem item, Cell cell, vec3 m) {
  const vec2 there = interval(item, m), here = interval_of_cell(cell, m);
  const float slack = rounding(magnitudes(item, m));
  return there.x - here.y > slack || here.x - there.y > slack;
}

// The directions square to an edge of the cell and one of the item.
bool is_apart_across(ClusterItem item, Cell cell, vec3 edge) {
  if (separates(item, cell, vec3(0.0, -edge.z, edge.y))) return true;
  if (separates(item, cell, vec3(edge.z, 0.0, -edge.x))) return true;
#ifdef MUTANT_10  // one of the four edges that run to the eye
  for (uint i = 0u; i < 1u; ++i)
#else
  for (uint i = 0u; i < 4u; ++i)
#endif
    if (separates(item, cell, cross(vec3(cell.x[i & 1u], cell.y[i >> 1u], 1.0), edge))) return true;
  return false;
}

bool is_apart(ClusterItem item, Cell cell) {
  // The cell's own sides; bounds have asked, but of all columns and rows between the first and the last.
  if (separates(item, cell, vec3(1.0, 0.0, -cell.x.x)) || separates(item, cell, vec3(1.0, 0.0, -cell.x.y))) return true;
  if (separates(item, cell, vec3(0.0, 1.0, -cell.y.x)) || separates(item, cell, vec3(0.0, 1.0, -cell.y.y))) return true;
  if (is_apart_across(item, cell, item.a) || is_apart_across(item, cell, item.b)) return true;
  if (item.shape != kShapePyramid) return is_apart_across(item, cell, item.c);
  for (uint i = 0u; i < 4u; ++i) {
    const vec3 side = item.c + ((i & 1u) == 0u ? item.a : -item.a) + (i < 2u ? item.b : -item.b);
    if (is_apart_across(item, cell, side)) return true;
  }
  return false;
}
#endif

// `at`: column and row.
bool touches(uint item_index, uvec2 at, vec2 depths) {
  const Cell cell = Cell(vec2(column_edge(at.x), column_edge(at.x + 1u)), vec2(row_edge(at.y), row_edge(at.y + 1u)), depths);
  if (is_outside_planes(item_index, cell)) return false;
#ifdef SEPARATING_AXIS
  return !is_apart(items[item_index], cell);
#else
  return true;
#endif
}

// The item's part of rows `first` to `last`.
void mark_rows(uint item_index, uint bit, uint slice, uint first, uint last) {
#ifdef UNBOUNDED
  const uvec2 across = uvec2(0u, columns() - 1u), down = uvec2(first, last);
#else
  const uvec4 bounds = item_bounds[item_index];
  const uvec2 across = uvec2(bounds.x & 0xffffu, bounds.x >> 16u), depth = uvec2(bounds.z & 0xffffu, bounds.z >> 16u);
  const uvec2 down = uvec2(max(bounds.y & 0xffffu, first), min(bounds.y >> 16u, last));
  if (slice < depth.x || slice > depth.y || across.x > across.y || down.x > down.y) return;
#endif
  const uint width = across.y - across.x + 1u, all = width * (down.y - down.x + 1u), threads = THREADS / 32u;
  const vec2 depths = vec2(slice_edge(slice), slice_edge(slice + 1u));
  for (uint i = gl_LocalInvocationID.x % threads; i < all; i += threads) {
    const uvec2 at = uvec2(across.x + i % width, down.x + i / width);
    if (!touches(item_index, at, depths)) continue;
#ifdef MUTANT_7  // the atomic is lost
    cell_bits[(at.y - first) * columns() + at.x] |= 1u << bit;
#else
    atomicOr(cell_bits[(at.y - first) * columns() + at.x], 1u << bit);
#endif
  }
}

void main() {
  const Word word = word_of_group(gl_WorkGroupID.x);
  const uint slice = gl_WorkGroupID.y, thread = gl_LocalInvocationID.x;
  if (slice >= slices() || !is_word(word)) return;  // the whole group
  const uint bit = thread / (THREADS / 32u);
  const uint rows_at_once = max(kBlock / max(columns(), 1u), 1u);
  for (uint first = 0u; first < rows(); first += rows_at_once) {
    const uint last = min(first + rows_at_once, rows()) - 1u, block = (last - first + 1u) * columns();
    for (uint i = thread; i < block; i += THREADS) cell_bits[i] = 0u;
    barrier();
    if (has_item(word, bit)) mark_rows(item_of(word, bit), bit, slice, first, last);
#ifndef MUTANT_9  // the barrier dropped: what higher subgroups have yet to mark is missing
    barrier();
#endif
    const uint to = (slice * rows() + first) * columns();
    for (uint i = thread; i < block; i += THREADS) store_bits(word, to + i, cell_bits[i]);
    barrier();
  }
}
