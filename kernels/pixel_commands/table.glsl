// A tile's distinct surfaces in shared memory: an open hash table of as many slots as the tile has pixels, so that it
// cannot run over however many surfaces or materials the scene has, and a list of the slots in use.
// Loop turns of an invocation: at most 1024 probes for each of its pixels; at 64 threads 16,384 were every probe the
// longest.
layout(constant_id = 0) const uint THREADS = 64u;  // divides kTilePixels
layout(local_size_x_id = 0) in;

const uint kPixelsPerThread = kTilePixels / THREADS;
const uint kSlotBits = 10u;  // kTilePixels slots
const uint kFree = 0xffffffffu;

shared uint surface_at[kTilePixels];  // a slot
shared uint pixels_at[kTilePixels];
shared uint used_slots[kTilePixels];  // the first `used` of them, in no order
shared uint used;

// This group's tile, the last first where the pass says so. May lie past the end.
#ifdef BACKWARDS
uint this_tile() { return tile_count(extent()) - 1u - spread_group(); }
#else
uint this_tile() { return spread_group(); }
#endif

void clear_table() {
  for (uint i = gl_LocalInvocationID.x; i < kTilePixels; i += THREADS) {
    surface_at[i] = kFree;
    pixels_at[i] = 0u;
  }
  if (gl_LocalInvocationID.x == 0u) used = 0u;
  barrier();
}

// The surface's slot, taken if it has none.
uint slot_of(uint surface) {
  uint slot = surface * 2654435769u >> 32u - kSlotBits;  // Knuth's multiplicative hash
  for (uint probe = 0u; probe < kTilePixels; ++probe) {
    uint there = surface_at[slot];
    if (there == kFree) {
#ifdef MUTANT_6  // a slot is taken without an atomic: two surfaces share it
      surface_at[slot] = surface;
#else
      there = atomicCompSwap(surface_at[slot], kFree, surface);
#endif
      if (there == kFree) used_slots[atomicAdd(used, 1u)] = slot;
    }
    if (there == kFree || there == surface) break;
    slot = slot + 1u & kTilePixels - 1u;
  }
  return slot;
}

// Where a pixel goes: its slot and how many of its surface are before it; kFree where it goes nowhere.
uint placed[kPixelsPerThread];

#ifdef MATCH_LANES
// Neighbouring lanes take neighbouring pixels, and those of one surface are counted by one atomic.
uint pixel_of_thread(uint i) { return i * THREADS + gl_LocalInvocationID.x; }

void count_pixels(uint tile) {
  for (uint i = 0u; i < kPixelsPerThread; ++i) {
    const uint surface = surface_of_pixel(pixel_of_tile(tile, pixel_of_thread(i), params.width));
    placed[i] = kFree;
    uvec4 rest = subgroupBallot(surface != kNoSurface);
    while (rest != uvec4(0u)) {
      const uint leader = subgroupBallotFindLSB(rest);
      const bool same = subgroupBroadcast(surface, leader) == surface;
      const uvec4 matching = subgroupBallot(same);
      uint first = 0u;
      if (gl_SubgroupInvocationID == leader) {
        const uint slot = slot_of(surface);
        first = slot << kSlotBits | atomicAdd(pixels_at[slot], subgroupBallotBitCount(matching));
      }
      first = subgroupBroadcast(first, leader);
#ifdef MUTANT_7  // the lanes of a surface share one place
      if (same) placed[i] = first;
#else
      if (same) placed[i] = first + subgroupBallotExclusiveBitCount(matching);
#endif
      rest &= ~matching;
    }
  }
}
#else
// A thread takes neighbouring pixels of a row, and a run of one surface among them is counted by one atomic.
uint pixel_of_thread(uint i) { return gl_LocalInvocationID.x * kPixelsPerThread + i; }

void count_pixels(uint tile) {
  uint current = kNoSurface, first = 0u;
  for (uint i = 0u; i <= kPixelsPerThread; ++i) {
    const uint surface = i < kPixelsPerThread
                             ? surface_of_pixel(pixel_of_tile(tile, pixel_of_thread(i), params.width))
                             : kFree - 2u;  // ends the last run
    if (i > 0u && surface == current) continue;
    if (current != kNoSurface && i > first) {
      const uint slot = slot_of(current);
#ifdef MUTANT_8  // a lost atomic
      const uint before = pixels_at[slot];
      pixels_at[slot] = before + i - first;
#else
      const uint before = atomicAdd(pixels_at[slot], i - first);
#endif
      for (uint j = first; j < i; ++j) placed[j] = slot << kSlotBits | before + j - first;
    } else {
      for (uint j = first; j < i; ++j) placed[j] = kFree;
    }
    current = surface;
    first = i;
  }
}
#endif
