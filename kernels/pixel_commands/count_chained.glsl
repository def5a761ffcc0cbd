// A group a tile: counts and lists as count.glsl does, and adds up the tiles before it while they are still being
// counted (Merrill, Garland 2016, decoupled look-back), a thread a shader. A tile's state is its own sums until it knows all
// before it. Tiles are taken in the order in which groups start, so that those waited for have started.
// A wait is bounded: a thread that gives up says so, and scan_chained.comp scans as ever.
// Loop turns of an invocation: as count.glsl, and for each shader of its share the look-back and at most PATIENCE waits.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/slots.glsl"
#include "kernels/pixel_commands/table.glsl"
#include "kernels/pixel_commands/groups.glsl"
#include "kernels/pixel_commands/match.glsl"
#include "kernels/pixel_commands/chain.glsl"
UPDATES(4, uint, chain);
#define ADD_DIGIT(shader, row, n) atomicAdd(chain[kChainDigits + (shader) * kOverflowRow + (row)], n)
#include "kernels/pixel_commands/digits.glsl"

const uint kOwn = 1u << 30;        // a sum of the tile alone
const uint kInclusive = 2u << 30;  // of the tile and all before it
const uint kSum = kOwn - 1u;
layout(constant_id = 1) const uint PATIENCE = 4096u;

shared uint taken;

// Sum and state are one word: no order of memory is asked for.
uint state_at(uint at) { return atomicOr(chain[at], 0u); }
void publish(uint at, uint state) { atomicExchange(chain[at], state); }

// The sum of word `word` of the shader's tiles before this one; false where it waited too long.
bool sum_before(uint shader, uint tile, uint word, out uint sum) {
  const uint row = chain_sums() + shader * tile_count(extent()) * 2u;
  uint patience = PATIENCE;
  sum = 0u;
  for (uint t = tile; t > 0u;) {
    const uint state = state_at(row + (t - 1u) * 2u + word);
    if (state == 0u) {  // not counted yet
      if (--patience == 0u) return false;
      continue;
    }
    sum += state & kSum;
    if ((state & kInclusive) != 0u) return true;
    --t;
  }
  return true;
}

void chain_shader(uint shader, uint tile) {
  const uint at = shader * tile_count(extent()) + tile;
  const uint sums = chain_sums() + at * 2u;
  const uint waves = (shader_waves[shader] & 0xffffu) + (shader_waves[shader] >> 16u);
  publish(sums, shader_pixels(shader) | kOwn);
  publish(sums + 1u, waves | kOwn);
  uint pixels_before, waves_before;
  if (sum_before(shader, tile, 0u, pixels_before) && sum_before(shader, tile, 1u, waves_before)) {
#ifdef MUTANT_35  // what is before is left out
    publish(sums, shader_pixels(shader) | kInclusive);
#else
    publish(sums, pixels_before + shader_pixels(shader) | kInclusive);
#endif
    publish(sums + 1u, waves_before + waves | kInclusive);
  } else {
    atomicOr(chain[kChainGaveUp], 1u);
  }
  add_digits(shader, shader_waves[shader]);
  tiles[at] = TileCommands(shader_pixels(shader), shader_waves[shader], pixels_before, waves_before);
}

void main() {
  if (gl_LocalInvocationID.x == 0u) taken = atomicAdd(chain[kChainNextTile], 1u);
  clear_groups();
  clear_table();  // its barrier is also for `taken`
  if (taken >= tile_count(extent())) return;  // the whole group
  count_pixels(taken);
  group_surfaces();
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS) chain_shader(s, taken);
  write_groups(taken);
  list_pixels(taken);
}
