#version 460
// The tile view: a thread a pixel.
#include "kernels/debug_view/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
READS(4, uint, masks);
READS(5, uint, heat_colours);

// The scene shows through the heat of the tile's features; a square in the tile's corner tells sets of equal size apart.
uint tile_colour(uvec2 pixel, uvec2 visible) {
  const uint scene = greyed(material_colour(visible));
#ifdef MUTANT_3
  const uint mask = masks[pixel.y / kTileSide * (params.width / kTileSide) + pixel.x / kTileSide];
#else
  const uint mask = masks[tile_of_pixel(pixel, params.width)];
#endif
  const uvec2 at = pixel % kTileSide;
#ifdef MUTANT_4
  const bool border = at.x == 0u && at.y == 0u;
#else
  const bool border = at.x == 0u || at.y == 0u;
#endif
  if (border) return blended(scene, 0u, 1u);
  if (mask == 0u) return blended(scene, kBackgroundColour, 1u);
#ifdef MUTANT_5
  if (all(greaterThanEqual(at, uvec2(kChipFirst))) && all(lessThanEqual(at, uvec2(kChipEnd)))) return hashed_colour(mask);
#else
  if (all(greaterThanEqual(at, uvec2(kChipFirst))) && all(lessThan(at, uvec2(kChipEnd)))) return hashed_colour(mask);
#endif
#ifdef MUTANT_6
  return blended(scene, heat_colours[bitCount(mask & 0x7fffffffu)], 1u);
#else
  return blended(scene, heat_colours[bitCount(mask)], 1u);
#endif
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
  image[pixel.y * params.width + pixel.x] = tile_colour(pixel, visible_at(pixel));
}
