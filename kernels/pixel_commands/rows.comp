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

shared uint row_first[kMaxShaders];

void main() {
  const uint thread = gl_LocalInvocationID.x;
  const uint slots = shader_slots();
  find_room(thread);
  uint commands = 0u;
  for (uint r = 0u; thread < slots && r < kOverflowRow; ++r) commands += commands_of(thread, r);
  if (thread < slots) row_first[thread] = commands;
  barrier();
  if (thread == 0u) status[0] = CommandStatus(listed, padded_waves, overflow_pixels, 0u, 0u, wanted);
  if (thread >= slots) return;
  uint first = 0u;
  for (uint s = 0u; s < thread; ++s) first += row_first[s];
  for (uint r = 0u; r < kOverflowRow; ++r) {
    const uint row = thread * kCommandRows + r;
    const uint count = commands_of(thread, r);
    args[row] = args_of(count, r % kCommandBuckets);
    command_rows[row] = CommandRow(first, 0u);  // the scatter counts them again as it places them
    first += count;
  }
  place_overflow(thread);
}
