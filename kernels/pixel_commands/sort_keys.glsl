// A key a pixel: shader, tile, material; all ones where it is in no list. The sort starts at bit 0.
#include "kernels/pixel_commands/sort.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/slots.glsl"

layout(local_size_x = kThreads) in;
WRITES(3, uint, sort_keys);
WRITES(4, uint, sorted);
WRITES(5, uint, sort_shift);

void main() {
  const uint pixel = spread_group() * kThreads + gl_LocalInvocationID.x;
  if (pixel < 2u) sort_shift[pixel] = 0u;
  if (pixel >= pairs()) return;
  const uvec2 at = uvec2(pixel % params.width, pixel / params.width);
  const uint surface = surface_of_pixel(at);
  const uint key = surface == kNoSurface ? kUnlisted : key_of(surface);
  const uint materials = min(params.materials, kMaxMaterials);
  const uint tile = shader_of(key) * tile_count(extent()) + tile_of_pixel(at, params.width);
  sort_keys[pixel] = key == kUnlisted ? 0xffffffffu : tile * materials + material_of(key);
  sorted[pixel] = key == kUnlisted ? kEntryInvalid : entry_of(at, copies_of_pixel(at));
}
