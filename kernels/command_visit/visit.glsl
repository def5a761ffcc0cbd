// What any shader does that is dispatched over pixel commands: find its pixel, here to say that it came, by which row and
// with which copy bits. A shader a slot, as there is one a shader class. The outputs are cleared before.
#include "harness/glsl/ports.glsl"
#include "kernels/command_visit/layout.h"

READS(0, uint, entries);
READS(1, uint, commands);
READS(2, CommandRow, command_rows);
UPDATES(3, uint, visits);
UPDATES(4, uint, visitors);
PARAMS(VisitParams);
ROW();
#define PIXEL_ENTRIES entries
#define PIXEL_COMMANDS commands
#define PIXEL_COMMAND_ROWS command_rows
#define PIXEL_SHADER_SLOT SLOT
#include "harness/glsl/pixel_commands.glsl"

READS(5, uint, surfaces);
#ifdef EARLY_OUT
#include "kernels/command_visit/early_out.glsl"
#else
bool to_run(uint surface) { return true; }
bool is_uniform() { return one_surface_a_wave(); }
#endif

void main() {
  uvec2 pixel;
  uint copy_bits;
  if (!commanded_pixel(pixel, copy_bits)) return;
#ifdef MUTANT_4  // the last row is left out
  if (pixel.x >= params.width || pixel.y + 1u >= params.height) return;
#else
  if (pixel.x >= params.width || pixel.y >= params.height) return;
#endif
  const uint at = pixel.y * params.width + pixel.x;
  uint surface = surfaces[at];
  if (!to_run(surface)) return;
#ifdef MUTANT_3  // one pixel's surface for the wave, whatever the list
  surface = equal_in_wave(surface);
#else
  if (is_uniform()) surface = equal_in_wave(surface);
#endif
#ifdef MUTANT_5  // every visit is the first slot's
  atomicAdd(visits[at], 1u);
#else
  atomicAdd(visits[at], 1u << 8u * SLOT);
#endif
  const uint promises = uint(one_surface_a_wave()) << 24u | uint(one_material_a_wave()) << 25u | (surface & 15u) << 26u;
#ifdef MUTANT_6  // copy bits are dropped
  copy_bits = 0u;
#endif
  atomicMax(visitors[at], kVisited | row | copy_bits << 8u | SLOT << 16u | promises);
}
