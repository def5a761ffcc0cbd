#version 460
// A group a tile: counts it again, as count.comp did, and writes its entries. The tiles are walked backwards, so that
// what the count read last, and the cache may still hold, is read first.
#define BACKWARDS
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/table.glsl"
#include "kernels/pixel_commands/groups.glsl"
#include "kernels/pixel_commands/scatter.glsl"

void main() {
  if (!arrange_tile(this_tile())) return;
  write_pixels(this_tile());
  write_waves(this_tile());
  write_commands(this_tile());
}
