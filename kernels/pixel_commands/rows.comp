#version 460
// One group: where each shader's waves begin, which tiles find no room padded, and what is dispatched.
// Loop turns of an invocation: the shaders, their rows, its share of one shader's tiles, at most 1024, and a wave.
#include "kernels/pixel_commands/common.glsl"

const uint kThreads = 256u;
layout(local_size_x = kThreads) in;
READS(0, TileCommands, tiles);
UPDATES(1, ShaderCommands, shaders);
UPDATES(2, CommandRow, command_rows);
WRITES(3, DispatchArgs, args);
WRITES(4, CommandStatus, status);
WRITES(5, uint, entries);
#include "kernels/pixel_commands/digits.glsl"
#include "kernels/pixel_commands/room.glsl"

shared uint row_count[kMaxShaders * kOverflowRow];
shared uint shader_count[kMaxShaders];  // commands

uint commands_before(uint shader, uint r) {
  uint before = 0u;
  for (uint s = 0u; s < shader; ++s) before += shader_count[s];
  for (uint below = 0u; below < r; ++below) before += row_count[shader * kOverflowRow + below];
  return before;
}

void main() {
  const uint thread = gl_LocalInvocationID.x;
  const uint slots = shader_slots(), all_rows = slots * kOverflowRow;
  find_room(thread);
  for (uint i = thread; i < all_rows; i += kThreads) row_count[i] = commands_of(i / kOverflowRow, i % kOverflowRow);
  barrier();
  if (thread < slots) {
    uint commands = 0u;
    for (uint r = 0u; r < kOverflowRow; ++r) commands += row_count[thread * kOverflowRow + r];
    shader_count[thread] = commands;
  }
  barrier();
  if (thread == 0u) status[0] = CommandStatus(listed, padded_waves, overflow_pixels, 0u, 0u, wanted);
#ifdef MUTANT_43  // a row a thread, and no more
  for (uint i = thread; i < min(all_rows, kThreads); i += kThreads) {
#else
  for (uint i = thread; i < all_rows; i += kThreads) {
#endif
    const uint shader = i / kOverflowRow, r = i % kOverflowRow;
    const uint row = shader * kCommandRows + r;
    args[row] = args_of(row_count[i], r % kCommandBuckets);
    command_rows[row] = CommandRow(commands_before(shader, r), 0u);  // the scatter counts as it places them
  }
  if (thread < slots) place_overflow(thread);
}
