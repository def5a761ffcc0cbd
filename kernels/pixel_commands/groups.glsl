// From a tile's surfaces to its groups: the pixels of one shader and material, uniform where they have one surface.
// Of a shader the uniform groups come first, then the divergent ones, each ascending by material, in whole waves.
// Every surface compares itself with every other: the few of a usual tile cost less than a sort would.
// Loop turns of an invocation: twice 1024 for each of its surfaces, at 64 threads 32,768 where every pixel has another.

shared uint key_at[kTilePixels];      // of a used slot, by its number in used_slots
shared uint group_at[kTilePixels];    // packed, likewise
shared uint shader_pixels[kMaxShaders];
shared uint shader_waves[kMaxShaders];  // as TileCommands.waves

// A surface's place in its group (10 bits), the group's pixels less one (10), whether it is divergent, and whether this
// surface is the one that speaks for it.
const uint kGroupPixelsShift = 10u;
const uint kGroupDivergent = 1u << 20u;
const uint kGroupLeader = 1u << 21u;
uint group_pixels(uint group) { return (group >> kGroupPixelsShift & kTilePixels - 1u) + 1u; }
uint waves_word(uint group) {
  return waves_of(group_pixels(group)) << ((group & kGroupDivergent) != 0u ? 16u : 0u);
}

void clear_groups() {
  for (uint s = gl_LocalInvocationID.x; s < kMaxShaders; s += THREADS) {
    shader_pixels[s] = 0u;
    shader_waves[s] = 0u;
  }
}

uint group_of(uint i) {
  uint before = 0u, pixels = 0u, surfaces = 0u;
  bool leader = true;
  for (uint j = 0u; j < used; ++j) {
    if (key_at[j] != key_at[i]) continue;
    const uint count = pixels_at[used_slots[j]];
    pixels += count;
    ++surfaces;
    if (j < i) before += count;
    if (j < i) leader = false;
  }
#ifdef MUTANT_10  // several surfaces pass for one
  const bool divergent = false;
#else
  const bool divergent = surfaces > 1u;
#endif
  return before | (pixels - 1u) << kGroupPixelsShift | (divergent ? kGroupDivergent : 0u) |
         (leader ? kGroupLeader : 0u);
}

// Counts and groups the tile's surfaces, and sums the groups by shader. Call it with the table filled.
void group_surfaces() {
#ifndef MUTANT_11  // the barrier dropped: keys of surfaces that higher subgroups have yet to list
  barrier();
#endif
  for (uint i = gl_LocalInvocationID.x; i < used; i += THREADS) key_at[i] = key_of(surface_at[used_slots[i]]);
  barrier();
  for (uint i = gl_LocalInvocationID.x; i < used; i += THREADS) {
    const uint key = key_at[i];
    const uint group = group_of(i);
    group_at[i] = group;
    if (key == kUnlisted || (group & kGroupLeader) == 0u) continue;
    atomicAdd(shader_pixels[shader_of(key)], group_pixels(group));
#ifdef MUTANT_12  // waves rounded down
    atomicAdd(shader_waves[shader_of(key)],
              (group_pixels(group) >> wave_log2()) << ((group & kGroupDivergent) != 0u ? 16u : 0u));
#else
    atomicAdd(shader_waves[shader_of(key)], waves_word(group));
#endif
  }
  barrier();
}
