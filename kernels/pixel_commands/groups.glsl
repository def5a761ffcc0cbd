// From a tile's surfaces to its list (tile_list.glsl). Surfaces are sorted by key; a surface that is alone with its key
// is a uniform group, several are a divergent one. Sums of pixels before a surface, of both kinds at once, then say
// where it stands.
// Loop turns of an invocation: those of the sort, the threads, and four times its share of the surfaces.
#include "kernels/pixel_commands/list_pixel.glsl"
#include "kernels/pixel_commands/group_starts.glsl"
#include "kernels/pixel_commands/sort_surfaces.glsl"

WRITES(3, TileCommands, tiles);
WRITES(11, uint, tile_groups);

// Pixels, those of uniform groups in bits 0..15, of divergent ones above: before the shader's first, and with its last.
shared uint shader_first[kMaxShaders];
shared uint shader_end[kMaxShaders];
shared uint shader_waves[kMaxShaders];  // as TileCommands.waves
shared uint sums[THREADS];
shared uint unlisted;

uint both(uint kinds) { return (kinds & 0xffffu) + (kinds >> 16u); }
uint shader_pixels(uint shader) { return both(shader_end[shader] - shader_first[shader]); }

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

// Of the i-th surface, sorted.
uint slot_at(uint i) { return used_slots[i] & (1u << kSlotBits) - 1u; }
uint key_at(uint i) { return used_slots[i] >> kSlotBits; }
bool starts_group(uint i) { return i == 0u || key_at(i - 1u) != key_at(i); }
bool ends_group(uint i) { return i + 1u == used || key_at(i + 1u) != key_at(i); }
#ifdef MUTANT_10  // several surfaces pass for one
bool is_uniform(uint i) { return true; }
#else
bool is_uniform(uint i) { return starts_group(i) && ends_group(i); }
#endif
uint kinds_of(uint i) {
  if (key_at(i) == kUnlisted) return 0u;
  return pixels_at[slot_at(i)] << (is_uniform(i) ? 0u : 16u);
}

// Pixels before the thread's share of the surfaces.
uint kinds_before(uint thread, uint share, uint own) {
  sums[thread] = own;
  barrier();
  uint before = 0u;
#ifdef MUTANT_9  // its own pixels count
  for (uint t = 0u; t <= thread && t * share < used; ++t) before += sums[t];
#else
  for (uint t = 0u; t < thread && t * share < used; ++t) before += sums[t];
#endif
  return before;
}

// The shader's bounds, where the i-th surface is its first or its last.
void bound_shader(uint i, uint before) {
  const uint key = key_at(i), shader = shader_of(key), end = before + kinds_of(i);
  if (key == kUnlisted) return;
  if (i == 0u || shader_of(key_at(i - 1u)) != shader) shader_first[shader] = before;
  const bool last = i + 1u == used || key_at(i + 1u) == kUnlisted;
  if (last || shader_of(key_at(i + 1u)) != shader) shader_end[shader] = end;
  if (last) listed = both(end);
}

// Its place (tile_list.glsl) takes that of its pixels in the table.
void place_surface(uint i, uint before) {
  const uint slot = slot_at(i), key = key_at(i), shader = shader_of(key);
  if (key == kUnlisted) {
    atomicAdd(unlisted, pixels_at[slot]);
    pixels_at[slot] = kNowhere;
    return;
  }
  const bool alone = is_uniform(i);
#ifdef MUTANT_18  // divergent groups over the uniform ones
  const uint at = (shader_first[shader] >> 16u) + (alone ? before & 0xffffu : before >> 16u);
#else
  const uint at =
      alone ? (shader_first[shader] >> 16u) + (before & 0xffffu) : (shader_end[shader] & 0xffffu) + (before >> 16u);
#endif
  if (starts_group(i)) {
    atomicOr(group_starts[at >> 5u], 1u << (at & 31u));
    atomicOr(words_with_starts, 1u << (at >> 5u));
  }
  pixels_at[slot] = (alone ? key : key | kListDivergent) << kPlaceBits | at;
}

void add_waves(uint i) {
  const uint key = key_at(i);
  if (key == kUnlisted || !starts_group(i)) return;
  const uint at = position_of(pixels_at[slot_at(i)]);
#ifdef MUTANT_12  // waves rounded down
  const uint waves = group_end(at) - at >> wave_log2();
#else
  const uint waves = waves_of(group_end(at) - at);
#endif
  atomicAdd(shader_waves[shader_of(key)], waves << (is_uniform(i) ? 0u : 16u));
}

// Groups the tile's surfaces, and sums them by shader. Call it with the table filled.
void group_surfaces() {
  const uint thread = gl_LocalInvocationID.x;
#ifndef MUTANT_11  // the barrier dropped: surfaces that higher subgroups have yet to list
  barrier();
#endif
  for (uint i = thread; i < used; i += THREADS)
    used_slots[i] |= key_of(surface_at[used_slots[i]]) << kSlotBits;
  barrier();
  sort_surfaces(thread);
  const uint share = ceil_div(used, THREADS);
  const uint begin = min(thread * share, used), end = min(begin + share, used);
  uint own = 0u;
  for (uint i = begin; i < end; ++i) own += kinds_of(i);
  const uint first = kinds_before(thread, share, own);
  uint before = first;
  for (uint i = begin; i < end; ++i) {
    bound_shader(i, before);
    before += kinds_of(i);
  }
  barrier();
  before = first;
  for (uint i = begin; i < end; ++i) {
    const uint kinds = kinds_of(i);
    place_surface(i, before);
    before += kinds;
  }
#ifndef MUTANT_33  // the barrier dropped: groups end where higher subgroups have yet to say
  barrier();
#endif
  for (uint i = begin; i < end; ++i) add_waves(i);
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
