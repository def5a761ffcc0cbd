// From a tile's surfaces to its list (tile_list.glsl). Surfaces are sorted by key; a surface that is alone with its key
// is a uniform group, several are a divergent one. Sums of pixels before a surface, of both kinds at once, then say
// where it stands. On lavapipe what is in an `if` is paid for in any case, and every read of shared memory.
// Loop turns of an invocation: those of the sort, the threads, and four times its share of the surfaces.
#include "kernels/pixel_commands/list_pixel.glsl"
#include "kernels/pixel_commands/group_starts.glsl"
#include "kernels/pixel_commands/sort_surfaces.glsl"

WRITES(3, TileCommands, tiles);
WRITES(11, uint, tile_groups);

// Sums over the surfaces before, in one word that may wrap at the end of a full list: pixels of uniform groups in bits
// 0..10, of divergent ones in 11..21, groups in 22..31.
const uint kDivergentShift = 11u, kGroupShift = 22u;
uint uniform_pixels(uint sums) { return sums & bits_below(kDivergentShift); }
uint divergent_pixels(uint sums) { return sums >> kDivergentShift & bits_below(kDivergentShift); }
uint both(uint sums) { return uniform_pixels(sums) + divergent_pixels(sums); }
#define GROUP_FIRST surface_at  // a group, sorted: divergent pixels before it. Surfaces are no longer asked for by then

shared uint shader_first[kMaxShaders];  // before the shader's first surface, and with its last
shared uint shader_end[kMaxShaders];
shared uint shader_waves[kMaxShaders];  // as TileCommands.waves
shared uint sums[THREADS];
shared uint unlisted;

uint shader_pixels(uint shader) { return both(shader_end[shader]) - both(shader_first[shader]); }

void clear_groups() {
  for (uint s = gl_LocalInvocationID.x; s < kMaxShaders; s += THREADS) {
    shader_first[s] = 0u;
    shader_end[s] = 0u;
    shader_waves[s] = 0u;
  }
  for (uint w = gl_LocalInvocationID.x; w < kStartWords; w += THREADS) group_starts[w] = 0u;
  if (gl_LocalInvocationID.x == 0u) {
    words_with_starts = 0u;
    listed = 0u;
    unlisted = 0u;
  }
}

uint slot_at(uint i) { return used_slots[i] & (1u << kSlotBits) - 1u; }

struct Surface {  // the i-th, sorted
  uint slot, key, shader;
  bool starts_group, ends_group, starts_shader, ends_shader, ends_list;
};
Surface surface(uint i, uint n) {
  const uint word = used_slots[i], key = word >> kSlotBits;
  const uint key_below = used_slots[max(i, 1u) - 1u] >> kSlotBits;
  const uint key_above = used_slots[min(i + 1u, n - 1u)] >> kSlotBits;
  const bool first = i == 0u, last = i + 1u == n, last_listed = last || key_above == kUnlisted;
  return Surface(word & (1u << kSlotBits) - 1u, key, shader_of(key), first || key_below != key,
                 last || key_above != key, first || shader_of(key_below) != shader_of(key),
                 last_listed || shader_of(key_above) != shader_of(key), last_listed);
}
#ifdef MUTANT_10  // several surfaces pass for one
bool is_uniform(Surface s) { return true; }
#else
bool is_uniform(Surface s) { return s.starts_group && s.ends_group; }
#endif
// Its part of the sums; the group is counted with its last surface.
uint part_of(Surface s) {
  const uint pixels = pixels_at[s.slot];
  const uint part = is_uniform(s) ? pixels : pixels << kDivergentShift;
  return s.key == kUnlisted ? 0u : s.ends_group ? part + (1u << kGroupShift) : part;
}

// What is before the thread's share of the surfaces.
uint sums_before(uint thread, uint share, uint n, uint own) {
  sums[thread] = own;
  barrier();
  uint before = 0u;
#ifdef MUTANT_9  // its own pixels count
  for (uint t = 0u; t <= thread && t * share < n; ++t) before += sums[t];
#else
  for (uint t = 0u; t < thread && t * share < n; ++t) before += sums[t];
#endif
  return before;
}

// What others ask for: bounds of its shader, the first of its group.
void bound_surface(Surface s, uint before, uint end) {
  if (s.key == kUnlisted) return;
  if (s.starts_group) GROUP_FIRST[before >> kGroupShift] = divergent_pixels(before);
  if (s.starts_shader) shader_first[s.shader] = before;
  if (s.ends_shader) shader_end[s.shader] = end;
  if (s.ends_list) listed = both(end);
}

// The waves of a group, when its last surface is at hand.
void add_waves(Surface s, uint before, uint end) {
  const bool alone = is_uniform(s);
  const uint pixels = alone ? uniform_pixels(end) - uniform_pixels(before)
                            : divergent_pixels(end) - GROUP_FIRST[before >> kGroupShift];
#ifdef MUTANT_12  // waves rounded down
  const uint waves = pixels >> wave_log2();
#else
  const uint waves = waves_of(pixels);
#endif
  if (s.ends_group) atomicAdd(shader_waves[s.shader], waves << (alone ? 0u : 16u));
}

// Its place (tile_list.glsl) takes that of its pixels in the table.
void place_surface(Surface s, uint before, uint end) {
  if (s.key == kUnlisted) {
    atomicAdd(unlisted, pixels_at[s.slot]);
    pixels_at[s.slot] = kNowhere;
    return;
  }
  const bool alone = is_uniform(s);
#ifdef MUTANT_18  // divergent groups over the uniform ones
  const uint at =
      divergent_pixels(shader_first[s.shader]) + (alone ? uniform_pixels(before) : divergent_pixels(before));
#else
  const uint at = alone ? divergent_pixels(shader_first[s.shader]) + uniform_pixels(before)
                        : uniform_pixels(shader_end[s.shader]) + divergent_pixels(before);
#endif
  if (s.starts_group) {
    atomicOr(group_starts[at >> 5u], 1u << (at & 31u));
    atomicOr(words_with_starts, 1u << (at >> 5u));
  }
  pixels_at[s.slot] = (alone ? s.key : s.key | kListDivergent) << kPlaceBits | at;
  add_waves(s, before, end);
}

// Groups the tile's surfaces, and sums them by shader. Call it with the table filled.
void group_surfaces() {
  const uint thread = gl_LocalInvocationID.x;
#ifndef MUTANT_11  // the barrier dropped: surfaces that higher subgroups have yet to list
  barrier();
#endif
  const uint n = used;
  for (uint i = thread; i < n; i += THREADS) used_slots[i] |= key_of(surface_at[used_slots[i]]) << kSlotBits;
  barrier();
  sort_surfaces(thread, n);
  const uint share = ceil_div(n, THREADS);
  const uint begin = min(thread * share, n), end = min(begin + share, n);
  uint own = 0u;
  for (uint i = begin; i < end; ++i) own += part_of(surface(i, n));
  const uint first = sums_before(thread, share, n, own);
  uint before = first;
  for (uint i = begin; i < end; ++i) {
    const Surface s = surface(i, n);
    const uint part = part_of(s);
    bound_surface(s, before, before + part);
    before += part;
  }
#ifndef MUTANT_33  // the barrier dropped: uniform pixels of a shader that higher subgroups have yet to sum
  barrier();
#endif
  before = first;
  for (uint i = begin; i < end; ++i) {
    const Surface s = surface(i, n);
    const uint part = part_of(s);
    place_surface(s, before, before + part);
    before += part;
  }
  barrier();
}

// What the scatter is to know of the tile's list beside its pixels.
void write_groups(uint tile) {
  for (uint w = gl_LocalInvocationID.x; w < kTileWords; w += THREADS)
    tile_groups[tile * kTileWords + w] = w < kStartWords        ? group_starts[w]
                                         : w == kWordsWithStarts ? words_with_starts
                                         : w == kListedWord      ? listed
                                                                 : unlisted;
}
void write_sums(uint tile) {
  const uint all = tile_count(extent());
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS)
    tiles[s * all + tile] = TileCommands(shader_pixels(s), shader_waves[s], 0u, 0u);
}
