#version 460
// The primary view: the tiles of which all is shaded, those of which a pixel of each 2x2 is, and in the others which
// pixels. A thread a pixel.
#include "kernels/debug_view/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 4) uniform utexture2D copy_bits;
READS(5, uint, vrcs_tiles);
READS(6, uint, vrcs_colours);

uint colour_place(uvec2 pixel) {
#ifdef MUTANT_24  // partial tiles are not counted in a row
  const uint across = params.width / kVrcsTileSide;
#else
  const uint across = (params.width + kVrcsTileSide - 1u) / kVrcsTileSide;
#endif
  const uint word = vrcs_tiles[pixel.y / kVrcsTileSide * across + pixel.x / kVrcsTileSide];
#ifdef MUTANT_25  // the longest list that is stored is taken for none
  if ((word & kVrcsTile1x1) != 0u || (word & kVrcsTileCount) >= kVrcsTileEntries) return kColourTileWhole;
#else
  if ((word & kVrcsTile1x1) != 0u || (word & kVrcsTileCount) > kVrcsTileEntries) return kColourTileWhole;
#endif
  if ((word & kVrcsTile2x2) != 0u) return kColourTile2x2;
#ifdef MUTANT_26  // whoever is copied by nobody is a duplicate
  const bool duplicate = texelFetch(copy_bits, ivec2(pixel), 0).r == 0u;
#else
  const bool duplicate = (texelFetch(copy_bits, ivec2(pixel), 0).r & kCopyDuplicate) != 0u;
#endif
  return duplicate ? kColourDuplicate : kColourPrimary;
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
  const uvec2 visible = visible_at(pixel);
  image[pixel.y * params.width + pixel.x] =
      is_nothing(visible) ? kBackgroundColour
                          : blended(vrcs_colours[colour_place(pixel)], greyed(material_colour(visible)), 3u);
}
