// Texels out of blocks of 4x4, by the Khronos Data Format Specification 1.3 (chapters RGTC and BPTC). Host only.
#pragma once
#include <array>
#include <span>

#include "harness/texture.h"

namespace assay {

// The RGBA codes of 8 bits, rows of texels, between which a device's texels lie. BC7 is specified to the bit: one code.
// BC4 and BC5 interpolate between two of their codes in 8 bits or more: the code below and the one above. Channels that
// a format lacks are 0, alpha 255.
struct DecodedTexels {
  Bytes low, high;
};

using BlockTexels = std::array<std::array<uint8_t, 4>, 16>;  // rows of four
struct DecodedBlock {
  BlockTexels low, high;
};
// Of BC7 mode 6 alone and the reserved mode, which is all 0: another throws std::runtime_error.
DecodedBlock decoded_block(Format, std::span<const std::byte> block);
DecodedTexels decoded_level(const Texture&, uint32_t layer, uint32_t level);

}  // namespace assay
