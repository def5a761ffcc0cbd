// Textures in blocks of 4x4 texels.
#pragma once
#include "harness/texture.h"

namespace assay::image {

// Every level and layer of an rgba8 texture; a block that reaches over the sides repeats the last row and column there.
// BC7 by bc7.h, on all threads; BC5 of red and green by libnvtt; BC4 is BC5's half. An sRGB format keeps sRGB codes.
Texture in_blocks(const Texture&, Format);

}  // namespace assay::image
