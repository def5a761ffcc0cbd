// A thread a pixel in scan order, whatever its tile. Loop turns of an invocation: at most 1024 probes.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/global_table.glsl"

layout(local_size_x = 256) in;
const uint kFree = 0xffffffffu;

uvec2 this_pixel() {
  const uint pixel = spread_group() * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
  const uint width = max(params.width, 1u);
  return uvec2(pixel % width, pixel / width);
}

uint global_slot_of(uvec2 pixel, uint surface) {
  const uint table = tile_of_pixel(pixel, params.width) * kTilePixels;
  uint slot = surface * 2654435769u >> 22u;  // Knuth's multiplicative hash, 10 bits
  for (uint probe = 0u; probe < kTilePixels; ++probe) {
#ifdef MUTANT_28  // a slot is taken without an atomic
    const uint there = table_surfaces[table + slot];
    if (there == kFree) table_surfaces[table + slot] = surface;
#else
    const uint there = atomicCompSwap(table_surfaces[table + slot], kFree, surface);
#endif
    if (there == kFree || there == surface) break;
    slot = slot + 1u & kTilePixels - 1u;
  }
  return table + slot;
}
