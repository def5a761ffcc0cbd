// Formats of texels, and textures in the host's memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace assay {
using Bytes = std::vector<std::byte>;

// clang-format off
enum class Format {
  r8_unorm, r8_uint, rg8_unorm, rgba8_unorm, rgba8_srgb, rgba8_uint, r16_unorm, r16_float, rg16_snorm, rg16_unorm,
  rg16_float, rgba16_float, rgba16_uint, r32_uint, r32_float, rg32_uint, rg32_float, rgba32_uint, rgba32_float,
  r11g11b10_float, rgb9e5_float, bc4_unorm, bc5_unorm, bc7_unorm, bc7_srgb, d32_float,
};
// clang-format on
const char* name_of(Format);
// Of a texel; of a block in formats of blocks. A block is block_side(f) texels a side, 1 in all other formats.
uint32_t bytes_per_block(Format);
uint32_t block_side(Format);
bool is_srgb(Format);
// Rows of blocks, tightly packed; what a block has beyond the sides counts.
uint64_t bytes_of(Format, uint32_t width, uint32_t height);

// An array texture: level after level, largest first, within a level layer after layer, rows tightly packed.
struct Texture {
  Format format = Format::rgba8_srgb;
  uint32_t width = 1, height = 1, layers = 1, levels = 1;
  Bytes bytes;
};
uint32_t width_of(const Texture&, uint32_t level);
uint32_t height_of(const Texture&, uint32_t level);
uint64_t bytes_of(const Texture&);                                   // what it must hold by its sizes
uint64_t offset_of(const Texture&, uint32_t level, uint32_t layer);  // in its bytes

}  // namespace assay
