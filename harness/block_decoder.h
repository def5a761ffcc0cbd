// Texels out of blocks of 4x4, by the Khronos Data Format Specification 1.3 (chapters RGTC and BPTC). Host only.
#pragma once
#include <array>
#include <span>

#include "harness/texture.h"

namespace assay {

// The RGBA codes of 8 bits between which a device's texels lie. BC7 is specified to the bit: one code. What BC4 and BC5
// interpolate has a formula, but no precision (Giesen, "GPU BCn decoding", 2021, found a decoder a vendor): in 8 bits,
// the least that there is, each of its two products is off by less than a code, so the sum by less than two. Channels
// that a format lacks are 0, alpha 255.
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
