#version 460
// A group a row: its commands in the order of the tiles.
// Loop turns of an invocation: twice its share of the tiles and the threads; 2304 of 262,144 tiles.
#include "kernels/pixel_commands/common.glsl"

const uint kThreads = 256u;
layout(local_size_x = kThreads) in;
READS(0, TileCommands, tiles);
READS(1, ShaderCommands, shaders);
UPDATES(2, CommandRow, command_rows);
WRITES(3, uint, commands);

shared uint commands_of[kThreads];

uint waves_in(uint word, uint kind) { return kind == kUniformLists ? word & 0xffffu : word >> 16u; }
uint digit(uint waves, uint k) { return k + 1u < kCommandBuckets ? waves >> k & 1u : waves >> k; }

void main() {
  const uint shader = gl_WorkGroupID.x / kOverflowRow, r = gl_WorkGroupID.x % kOverflowRow;
  const uint kind = r / kCommandBuckets, k = r % kCommandBuckets;
  const uint thread = gl_LocalInvocationID.x;
  const uint row = shader * kCommandRows + r;
  const uint all = tile_count(extent()), padded = shaders[shader].padded_tiles;
  const uint share = ceil_div(padded, kThreads);
  const uint begin = min(thread * share, padded), end = min(begin + share, padded);
  uint own = 0u;
  for (uint t = begin; t < end; ++t) own += digit(waves_in(tiles[shader * all + t].waves, kind), k);
  commands_of[thread] = own;
#ifndef MUTANT_27  // the barrier dropped: the sums of higher subgroups are missing
  barrier();
#endif
  uint at = command_rows[row].first, total = 0u;
  for (uint t = 0u; t < kThreads; ++t) {
    if (t < thread) at += commands_of[t];
    total += commands_of[t];
  }
  for (uint t = begin; t < end; ++t) {
    const TileCommands tile = tiles[shader * all + t];
    const uint waves = waves_in(tile.waves, kind);
    uint wave = shaders[shader].first + tile.waves_before + (kind == kUniformLists ? 0u : tile.waves & 0xffffu);
    if (k + 1u < kCommandBuckets) wave += waves >> k + 1u << k + 1u;  // the larger ones are before
    for (uint i = 0u; i < digit(waves, k); ++i) commands[at++] = wave + (i << k);
  }
  if (thread == 0u) command_rows[row].count = total;
}
