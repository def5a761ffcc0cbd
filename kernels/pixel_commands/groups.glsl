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

uint slot_at(uint i) { return used_slots[i] & (1u << kSlotBits) - 1u; }

struct Surface {  // the i-th, sorted
  uint slot, key, shader;
  bool starts_group, ends_group, starts_shader, ends_shader, ends_list;
};
Surface surface(uint i) {
  const uint word = used_slots[i], key = word >> kSlotBits;
  const uint key_below = used_slots[max(i, 1u) - 1u] >> kSlotBits, key_above = used_slots[min(i + 1u, used - 1u)] >> kSlotBits;
  const bool first = i == 0u, last = i + 1u == used, last_listed = last || key_above == kUnlisted;
  return Surface(word & (1u << kSlotBits) - 1u, key, shader_of(key), first || key_below != key, last || key_above != key,
                 first || shader_of(key_below) != shader_of(key),
                 last_listed || shader_of(key_above) != shader_of(key), last_listed);
}
#ifdef MUTANT_10  // several surfaces pass for one
bool is_uniform(Surface s) { return true; }
#else
bool is_uniform(Surface s) { return s.starts_group && s.ends_group; }
#endif
uint kinds_of(Surface s) {
  const uint pixels = pixels_at[s.slot];
  return s.key == kUnlisted ? 0u : is_uniform(s) ? pixels : pixels << 16u;
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

// The shader's bounds, where the surface is its first or its last.
void bound_shader(Surface s, uint before, uint end) {
  if (s.key == kUnlisted) return;
  if (s.starts_shader) shader_first[s.shader] = before;
  if (s.ends_shader) shader_end[s.shader] = end;
  if (s.ends_list) listed = both(end);
}

// Its place (tile_list.glsl) takes that of its pixels in the table.
void place_surface(Surface s, uint before) {
  if (s.key == kUnlisted) {
    atomicAdd(unlisted, pixels_at[s.slot]);
    pixels_at[s.slot] = kNowhere;
    return;
  }
  const bool alone = is_uniform(s);
#ifdef MUTANT_18  // divergent groups over the uniform ones
  const uint at = (shader_first[s.shader] >> 16u) + (alone ? before & 0xffffu : before >> 16u);
#else
  const uint at =
      alone ? (shader_first[s.shader] >> 16u) + (before & 0xffffu) : (shader_end[s.shader] & 0xffffu) + (before >> 16u);
#endif
  if (s.starts_group) {
    atomicOr(group_starts[at >> 5u], 1u << (at & 31u));
    atomicOr(words_with_starts, 1u << (at >> 5u));
  }
  pixels_at[s.slot] = (alone ? s.key : s.key | kListDivergent) << kPlaceBits | at;
}

void add_waves(Surface s) {
  if (s.key == kUnlisted || !s.starts_group) return;
  const uint at = position_of(pixels_at[s.slot]);
#ifdef MUTANT_12  // waves rounded down
  const uint waves = group_end(at) - at >> wave_log2();
#else
  const uint waves = waves_of(group_end(at) - at);
#endif
  atomicAdd(shader_waves[s.shader], waves << (is_uniform(s) ? 0u : 16u));
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
  for (uint i = begin; i < end; ++i) own += kinds_of(surface(i));
  const uint first = kinds_before(thread, share, own);
  uint before = first;
  for (uint i = begin; i < end; ++i) {
    const Surface s = surface(i);
    const uint kinds = kinds_of(s);
    bound_shader(s, before, before + kinds);
    before += kinds;
  }
  barrier();
  before = first;
  for (uint i = begin; i < end; ++i) {
    const Surface s = surface(i);
    const uint kinds = kinds_of(s);
    place_surface(s, before);
    before += kinds;
  }
#ifndef MUTANT_33  // the barrier dropped: groups end where higher subgroups have yet to say
  barrier();
#endif
  for (uint i = begin; i < end; ++i) add_waves(surface(i));
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
