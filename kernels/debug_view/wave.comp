#version 460
// The wave view: dispatched over the pixel commands of every visible shader, as texturing is, so that it shows what
// shares a wave there. Pixels in no list stay dimmed.
#include "harness/glsl/ports.glsl"
layout(push_constant) uniform row_block { uint list_row; };
#define PIXEL_SHADER_SLOT (list_row / kCommandRows)
#define PIXEL_ROW (list_row % kCommandRows)
#define PIXEL_ENTRIES entries
#define PIXEL_COMMANDS commands
#define PIXEL_COMMAND_ROWS command_rows
#include "harness/formats/pixel_commands.h"
READS(4, uint, entries);
READS(5, uint, commands);
READS(6, CommandRow, command_rows);
#include "harness/glsl/pixel_commands.glsl"
#include "kernels/debug_view/common.glsl"

void main() {
  uvec2 pixel;
  uint copy_bits;
  if (!commanded_pixel(pixel, copy_bits)) return;
#ifndef MUTANT_17  // columns beyond the right edge are painted
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
#else
  if (pixel.y >= params.height) return;
#endif
#if defined(MUTANT_18)  // the waves of all rows share their colours
  const uint colour = hashed_colour(wave_of_row());
#elif defined(MUTANT_19)  // a colour a workgroup
  const uint colour = hashed_colour(mixed(list_row + 1u) ^ gl_WorkGroupID.x);
#else
  const uint colour = hashed_colour(mixed(list_row + 1u) ^ wave_of_row());
#endif
  image[pixel.y * params.width + pixel.x] = colour;
}
