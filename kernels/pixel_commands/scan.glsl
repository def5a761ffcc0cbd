// A group a shader: pixels and waves of the tiles before each tile, the shader's sums, and how many commands it has of
// each bucket were all of it padded. Sums stay below 2^28: no tile has more waves than pixels.
// Loop turns of an invocation: 262,144 tiles are 256 blocks, of each its share, the steps, and the digits of each tile.
#include "kernels/pixel_commands/common.glsl"

const uint kThreads = 256u;
const uint kShare = 4u;  // tiles of a thread; the group goes through blocks of kThreads * kShare
layout(local_size_x = kThreads) in;
UPDATES(0, TileCommands, tiles);
WRITES(1, ShaderCommands, shaders);
WRITES(2, CommandRow, command_rows);
#include "kernels/pixel_commands/digits.glsl"

shared uvec2 sums[2][kThreads];  // pixels, waves

uint all_waves(uint word) {
#ifdef MUTANT_14  // divergent waves do not count
  return word & 0xffffu;
#else
  return (word & 0xffffu) + (word >> 16u);
#endif
}

// Sums of the threads before; log2 of the threads in steps, each from one half of `sums` to the other.
uvec2 sums_before(uint thread, uvec2 own, out uvec2 total) {
  uint from = 0u;
  sums[from][thread] = own;
  barrier();
  for (uint reach = 1u; reach < kThreads; reach *= 2u) {
    const uvec2 lower = thread >= reach ? sums[from][thread - reach] : uvec2(0u);
    sums[1u - from][thread] = sums[from][thread] + lower;
    from = 1u - from;
    STEP_BARRIER();
  }
  barrier();
  total = sums[from][kThreads - 1u];
  const uvec2 before = sums[from][thread] - own;
  barrier();  // the next block writes them over
  return before;
}

#ifdef CHAINED  // the count has done it all, unless it gave up
#include "kernels/pixel_commands/chain.glsl"
READS(3, uint, chain);

bool is_chained(uint shader, uint thread, uint all) {
  if (chain[kChainGaveUp] != 0u || all == 0u) return false;
  const TileCommands last = tiles[shader * all + all - 1u];
  if (thread == 0u)
    shaders[shader] =
        ShaderCommands(last.waves_before + all_waves(last.waves), last.pixels_before + last.pixels, 0u, 0u, 0u);
  if (thread < kOverflowRow)
    command_rows[shader * kCommandRows + thread] = CommandRow(0u, chain[kChainDigits + shader * kOverflowRow + thread]);
  return true;
}
#endif

// A thread's tiles from `begin` on. Their counters are read all at once: none waits for another.
void scan_share(uint shader, uint begin, uint all, uvec2 before_block, out uvec2 total) {
  uvec2 share[kShare];  // pixels, and the word of waves
  uvec2 own = uvec2(0u);
  for (uint i = 0u; i < kShare; ++i) {
    const uint t = shader * all + min(begin + i, all - 1u);
    share[i] = begin + i < all ? uvec2(tiles[t].pixels, tiles[t].waves) : uvec2(0u);
  }
  for (uint i = 0u; i < kShare; ++i) own += uvec2(share[i].x, all_waves(share[i].y));
  uvec2 before = before_block + sums_before(gl_LocalInvocationID.x, own, total);
  for (uint i = 0u; i < kShare && begin + i < all; ++i) {
    tiles[shader * all + begin + i] = TileCommands(share[i].x, share[i].y, before.x, before.y);
    add_digits(shader, share[i].y);
    before += uvec2(share[i].x, all_waves(share[i].y));
  }
}

void main() {
  const uint shader = gl_WorkGroupID.x, thread = gl_LocalInvocationID.x;
  const uint all = tile_count(extent());
  if (shader >= shader_slots()) return;  // the whole group
#ifdef CHAINED
  if (is_chained(shader, thread, all)) return;
#endif
  clear_digits(thread);
  uvec2 before = uvec2(0u);  // of the blocks so far
  for (uint block = 0u; block < all; block += kThreads * kShare) {
    uvec2 total;
    scan_share(shader, block + thread * kShare, all, before, total);
#ifndef MUTANT_44  // every block begins at nothing
    before += total;
#else
    before = total;
#endif
  }
  barrier();
  if (thread == 0u) shaders[shader] = ShaderCommands(before.y, before.x, 0u, 0u, 0u);  // rows.comp makes offsets of it
  if (thread < kOverflowRow) command_rows[shader * kCommandRows + thread] = CommandRow(0u, sum_of_digits(thread));
}
