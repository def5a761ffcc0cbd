#version 460
// The shadows view: all of the shadow atlas, as large as fits from the picture's first pixel on. A thread a pixel.
#include "kernels/debug_view/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 4) uniform texture2D shadow_depth;
READS(5, ShadowView, shadow_views);

// 255 nearest to the light, 0 nothing: 32 steps a doubling, read off the float's bits.
uint depth_code(float depth) {
  const int above = max(floatBitsToInt(depth), 0) - floatBitsToInt(kLeastShownDepth);
#ifdef MUTANT_27  // doublings alone
  return uint(clamp(above >> 23 << 5, 0, 255));
#else
  return uint(clamp(above >> 18, 0, 255));
#endif
}

uint darkened(uint colour, uint code) {
  const uvec3 channels = (uvec3(colour) >> uvec3(0u, 8u, 16u) & 0xffu) * code / 255u;
  return 0xff000000u | channels.z << 16 | channels.y << 8 | channels.x;
}

// The atlas in the picture, pixels.
uvec2 shown_extent(uvec2 atlas) {
#ifdef MUTANT_28  // over the whole picture
  return uvec2(params.width, params.height);
#else
  return params.width * atlas.y <= params.height * atlas.x
             ? uvec2(params.width, params.width * atlas.y / atlas.x)
             : uvec2(params.height * atlas.x / atlas.y, params.height);
#endif
}

const uint kLighter = 0x404040u;  // channels from 128 to 255: depths darken them

uint shadow_colour(uvec2 pixel) {
  const uvec2 atlas = uvec2(params.shadow_width, params.shadow_height);
  if (atlas.x == 0u || atlas.y == 0u) return kBackgroundColour;
  const uvec2 shown = shown_extent(atlas);
  if (pixel.x >= shown.x || pixel.y >= shown.y) return kBackgroundColour;
  const uvec2 texel = pixel * atlas / shown;
  for (uint i = 0u; i < params.shadow_views; ++i) {
    const ShadowTile tile = shadow_views[i].tile;
    const uvec2 at = texel - uvec2(tile.x, tile.y);  // beyond the largest where it is before the tile
#ifdef MUTANT_29  // a tile ends a texel late
    if (at.x > tile.side || at.y > tile.side) continue;
#else
    if (at.x >= tile.side || at.y >= tile.side) continue;
#endif
#ifdef MUTANT_30  // a colour for all
    const uint colour = hashed_colour(1u) + kLighter;
#else
    const uint colour = hashed_colour(i + 1u) + kLighter;
#endif
    return blended(darkened(colour, depth_code(texelFetch(shadow_depth, ivec2(texel), 0).r)), colour, 3u);
  }
  return kBackgroundColour;
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
  image[pixel.y * params.width + pixel.x] = shadow_colour(pixel);
}
