// What each particle and each slot of the atlas goes through; the variants differ in who does it when. Of each size,
// largest first: particles claim the slots that they had, and who has none of his own takes a free one, both ascending;
// who finds none waits for the next smaller size. A slot is a rectangle of a region, numbered row by row; of all slots,
// those of 8x8 come first.
#include "harness/glsl/particles.glsl"
#include "harness/glsl/ports.glsl"
#include "kernels/particle_rects/layout.h"

READS(0, ParticleRecord, particles);
READS(1, uint, previous);
UPDATES(2, uint, rects);
UPDATES(3, uint, owners);
UPDATES(4, uint, free_slots);
UPDATES(5, ParticleRectCounts, counts);
WRITES(6, uint, blocks);
WRITES(7, DispatchArgs, args);
PARAMS(RectParams);

#include "harness/glsl/tiles.glsl"
#include "kernels/particle_rects/wanted.glsl"

const uint THREADS = kBlock, SCANNED = kBlock;
layout(local_size_x = THREADS) in;
#include "harness/glsl/scan.glsl"

uint particle_count() { return min(params.particles, kMostParticles); }

struct Region {
  uint size;    // of its rectangles: their side is 4 << size
  uint row;     // texels, where it begins
  uint across;  // slots in a row
  uint slots;
  uint first;  // its first slot's number
};

// Within the atlas, whatever the parameters say.
Region region_of(uint size) {
  Region r = Region(size, 0u, 0u, 0u, 0u);
  const uint width = min(params.atlas.side, kMostAtlasSide) / 32u * 32u;
  uint row = 0u;
  for (uint k = kRectSizes; k > 0u; --k) {
    const uint side = 4u << k;
    const uint high = min(params.atlas.rows[k - 1u], width - row) / side;
    if (k == size) r = Region(size, row, width / side, width / side * high, 0u);
    if (k < size) r.first += width / side * high;
    row += high * side;
  }
  return r;
}
uint all_slots() {
  const Region last = region_of(kRectSizes);
  return last.first + last.slots;
}

// Until it has its word, a particle waits: for which size, and which it wanted.
const uint kWaits = 0x80000000u;
bool waits_for(uint i, uint size) { return i < particle_count() && (rects[i] & ~0xcu) == (kWaits | size); }

void start_particle(uint i) {
  const uint size = wanted_size(particles[i]);
  rects[i] = size == 0u ? kNoRect : kWaits | size << 2u | size;
}

// The slot of the region that the particle had, or nobody's.
uint slot_before(Region r, uint i) {
  const uint word = previous[i], side = 4u << r.size;
  const LightRect rect = light_rect(word);
#ifdef MUTANT_6  // a rectangle of another size is as good
  if (rect.corner.y < r.row) return kNobody;
#else
  if (word >> kRectSizeShift != r.size || rect.corner.y < r.row) return kNobody;
#endif
  const uvec2 from = rect.corner - uvec2(0u, r.row), at = from / side;
#ifdef MUTANT_7  // slots that begin where none does
  const bool is_slot = true;
#else
  const bool is_slot = at * side == from;
#endif
  if (!is_slot || at.x >= r.across || at.y * r.across >= r.slots) return kNobody;
  return at.y * r.across + at.x;
}
void claim(Region r, uint i) {
  const uint slot = waits_for(i, r.size) ? slot_before(r, i) : kNobody;
#ifdef MUTANT_8  // to the highest of those that had it
  if (slot != kNobody) atomicMax(owners[r.first + slot], i);
#else
  if (slot != kNobody) atomicMin(owners[r.first + slot], i);
#endif
}

// Whether it waits and the slot that it had is its own, or not.
bool keeps(Region r, uint i) {
  if (!waits_for(i, r.size)) return false;
  const uint slot = slot_before(r, i);
  return slot != kNobody && owners[r.first + slot] == i;
}
bool wants_slot(Region r, uint i) { return waits_for(i, r.size) && !keeps(r, i); }
bool is_free(Region r, uint slot) { return slot < r.slots && owners[r.first + slot] == kNobody; }

shared ParticleRectCounts of_group;
void count_nothing() {
  if (gl_LocalInvocationID.x == 0u) of_group = ParticleRectCounts(0u, 0u, 0u, 0u);
  barrier();
}
void add_counts() {
  barrier();
  if (gl_LocalInvocationID.x != 0u) return;
  if (of_group.lit != 0u) atomicAdd(counts[0].lit, of_group.lit);
  if (of_group.smaller != 0u) atomicAdd(counts[0].smaller, of_group.smaller);
  if (of_group.dropped != 0u) atomicAdd(counts[0].dropped, of_group.dropped);
}

void take(Region r, uint i, uint slot) {
  const uvec2 corner = uvec2(slot % r.across, slot / r.across) * (4u << r.size) + uvec2(0u, r.row);
#ifdef MUTANT_9  // it is never smaller than wanted
  const bool is_smaller = false;
#else
  const bool is_smaller = (rects[i] >> 2u & kRectSizes) != r.size;
#endif
  rects[i] = rect_word(corner, r.size);
  owners[r.first + slot] = i;
  atomicAdd(of_group.lit, 1u);
  if (is_smaller) atomicAdd(of_group.smaller, 1u);
}
// A particle that waits for this size; `rank` among those that want a slot, of which `found` are free.
void place(Region r, uint i, uint rank, uint found) {
  if (keeps(r, i)) {
    take(r, i, slot_before(r, i));
  } else if (rank < found) {
    take(r, i, free_slots[r.first + rank]);
#ifdef MUTANT_10  // who finds none is dropped
  } else if (false) {
#else
  } else if (r.size > 1u) {
#endif
    rects[i] = rects[i] - 1u;
  } else {
    rects[i] = kNoRect;
    atomicAdd(of_group.dropped, 1u);
  }
}

uint block_count(uint i) {
  if (i >= particle_count()) return 0u;
  const uint across = light_rect(rects[i]).side / kLightBlockSide;
  return across * across;
}
void list_blocks(uint i, uint first) {
#ifdef MUTANT_11  // the last is left out
  for (uint k = 0u; k + 1u < block_count(i); ++k) blocks[first + k] = i << kLightBlockBits | k;
#else
  for (uint k = 0u; k < block_count(i); ++k) blocks[first + k] = i << kLightBlockBits | k;
#endif
}
void finish(uint all) {
  counts[0].blocks = all;
  const uvec2 groups = spread(ceil_div(all, kLightGroupBlocks));
  args[0] = DispatchArgs(groups.x, groups.y, 1u);
}
