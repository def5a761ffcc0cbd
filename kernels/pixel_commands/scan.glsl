// A group a shader: pixels and waves of the tiles before each tile, the shader's sums, and how many commands it has of
// each bucket were all of it padded. Sums stay below 2^28: no tile has more waves than pixels.
// Loop turns of an invocation: three times its share of the tiles, 256 of 262,144, and the digits of each.
#include "kernels/pixel_commands/common.glsl"

const uint kThreads = 1024u;
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
  return sums[from][thread] - own;
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

void main() {
  const uint shader = gl_WorkGroupID.x, thread = gl_LocalInvocationID.x;
  const uint all = tile_count(extent());
  if (shader >= shader_slots()) return;  // the whole group
#ifdef CHAINED
  if (is_chained(shader, thread, all)) return;
#endif
  clear_digits(thread);
  const uint share = ceil_div(all, kThreads);
  const uint begin = min(thread * share, all), end = min(begin + share, all);
  uvec2 own = uvec2(0u);
  for (uint t = begin; t < end; ++t) {
    const TileCommands tile = tiles[shader * all + t];
    own += uvec2(tile.pixels, all_waves(tile.waves));
  }
  uvec2 total;
  uvec2 before = sums_before(thread, own, total);
  for (uint t = begin; t < end; ++t) {
    TileCommands tile = tiles[shader * all + t];
    tile.pixels_before = before.x;
    tile.waves_before = before.y;
    tiles[shader * all + t] = tile;
    add_digits(shader, tile.waves);
    before += uvec2(tile.pixels, all_waves(tile.waves));
  }
  barrier();
  if (thread == 0u) shaders[shader] = ShaderCommands(total.y, total.x, 0u, 0u, 0u);  // rows.comp makes offsets of it
  if (thread < kOverflowRow) command_rows[shader * kCommandRows + thread] = CommandRow(0u, sum_of_digits(thread));
}
