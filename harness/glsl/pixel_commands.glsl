// For shaders that are dispatched over pixel commands: which pixel an invocation shades. One kernel may have a shader a
// shader class, each dispatched for the rows of its slot:
//   Dispatch{.shader = "opaque.comp", .indirect = "args", .first_args = <slot * kCommandRows>,
//            .repeat = <kCommandRows, or 0 where the class is not visible>}
// The includer declares ROW(); and the ports, and says which slot the shader has:
//   READS(n, uint, entries); READS(n, uint, commands); READS(n, CommandRow, command_rows);
//   #define PIXEL_ENTRIES entries
//   #define PIXEL_COMMANDS commands
//   #define PIXEL_COMMAND_ROWS command_rows
//   #define PIXEL_SHADER_SLOT <expression>, the same in all invocations
// A shader that runs for the rows of several slots defines PIXEL_ROW, the row within the slot, beside the slot.
// The local size is set here. Sizes of the ports: harness/commands.h.
#ifndef HARNESS_GLSL_PIXEL_COMMANDS
#define HARNESS_GLSL_PIXEL_COMMANDS
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "harness/formats/pixel_commands.h"

layout(local_size_x = kCommandThreads) in;
#ifndef PIXEL_ROW
#define PIXEL_ROW row
#endif

// What may be taken for granted of this dispatch's waves. The row is a constant of the dispatch.
bool one_surface_a_wave() { return PIXEL_ROW < kCommandBuckets; }
bool one_material_a_wave() { return PIXEL_ROW != kOverflowRow; }

// The wave's own number among those of the row. Groups that a spread dispatch has too many lie past the end.
uint wave_of_row() {
  const uint group = (gl_WorkGroupID.z * gl_NumWorkGroups.y + gl_WorkGroupID.y) * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return group * kWavesPerGroup + gl_LocalInvocationID.x / kWaveSize;
}

// False where there is nothing to shade: padding, or past the end of the row. copy_bits: kCopyHorizontal, ...
bool commanded_pixel(out uvec2 pixel, out uint copy_bits) {
  pixel = uvec2(0u);
  copy_bits = 0u;
#ifdef MUTANT_9205  // the first slot's rows, whatever the slot
  const CommandRow list = PIXEL_COMMAND_ROWS[PIXEL_ROW];
#else
  const CommandRow list = PIXEL_COMMAND_ROWS[PIXEL_SHADER_SLOT * kCommandRows + PIXEL_ROW];
#endif
  const uint wave = wave_of_row();
  const uint bucket = one_material_a_wave() ? PIXEL_ROW % kCommandBuckets : 0u;
  const uint command = wave >> bucket;
#ifdef MUTANT_9201  // one command too many
  if (command > list.count) return false;
#else
  if (command >= list.count) return false;
#endif
#ifdef MUTANT_9202  // every wave of a command is its first
  const uint within = 0u;
#else
  const uint within = wave & ((1u << bucket) - 1u);
#endif
#ifdef MUTANT_9203  // the overflow taken for a list of commands
  const uint first = PIXEL_COMMANDS[list.first + command] + within;
#else
  const uint first = one_material_a_wave() ? PIXEL_COMMANDS[list.first + command] + within : list.first + wave;
#endif
  const uint entry = PIXEL_ENTRIES[first * kWaveSize + gl_LocalInvocationID.x % kWaveSize];
#ifndef MUTANT_9204  // padding is shaded
  if ((entry & kEntryInvalid) != 0u) return false;
#endif
  const uint mask = (1u << kEntryCoordinateBits) - 1u;
  pixel = uvec2(entry & mask, entry >> kEntryCoordinateBits & mask);
  copy_bits = entry >> kEntryCopyShift & kCopyBits;
  return true;
}

// Of values that are equal in a wave, as the surface is in the lists of one_surface_a_wave() and the material in those
// of one_material_a_wave(): lets the compiler keep them in scalar registers. A subgroup wider than a wave holds two.
uint equal_in_wave(uint value) { return gl_SubgroupSize <= kWaveSize ? subgroupBroadcastFirst(value) : value; }

#endif
