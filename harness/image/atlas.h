// Decals' pictures into the pages of an atlas, with borders and mips that let no two of them mix.
#pragma once
#include <span>
#include <vector>

#include "harness/image/image.h"
#include "harness/kernel.h"

namespace assay::image {

struct PagePlace {
  uint32_t page = 0, x = 0, y = 0;  // left top, texels
  auto operator<=>(const PagePlace&) const = default;
};
// Rectangles onto square pages, none over another; as few pages as first fit makes of them, the highest first on
// shelves (Coffman, Garey, Johnson, Tarjan 1980). Places are in the order of the sizes. A rectangle larger than a page,
// or empty: std::runtime_error.
std::vector<PagePlace> pack_shelves(std::span<const Extent> sizes, uint32_t page_side);

// A decal's pictures, all of one size, or a single texel for all of it.
struct DecalPictures {
  Rgba8 albedo;     // sRGB, alpha is coverage
  Rgba8 normal;     // x and y in red and green
  Rgba8 roughness;  // red
};

// UV of the page: a decal's own texels, which its border surrounds.
struct AtlasRectangle {
  uint32_t page = 0;
  float u = 0, v = 0, width = 0, height = 0;
};
struct DecalAtlas {
  std::vector<Texture> textures;  // albedo (rgba8_srgb), normal, roughness (rgba8_unorm): layers are pages
  std::vector<AtlasRectangle> rectangles;
  uint32_t border = 0;  // texels of the first level around each
};

// Pages of `side` texels with `levels` mips. A decal's cell begins and ends at texels of the last level, so that none
// at any level holds two decals; or at `block` of them a side, so that none of the blocks of as many texels does. Side
// is a multiple of it, block 2^(levels - 1). Around the decal its outermost texels are repeated over 9/16 of one or
// more: what a linear filter reads at any level from within the decal, half a texel away and a sixteenth for its
// weights' steps, is its own. Colours of coarser levels are means of linear light by coverage, so that what cannot be
// seen colours nothing; the rest are plain means. Pictures of unequal size, and what pack_shelves refuses:
// std::runtime_error.
DecalAtlas make_atlas(std::span<const DecalPictures> decals, uint32_t side, uint32_t levels, uint32_t block = 1);

}  // namespace assay::image
