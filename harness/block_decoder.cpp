#include "harness/block_decoder.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace assay {

namespace {

// Little-endian, the first bit the lowest.
struct Bits {
  std::span<const std::byte> bytes;
  uint32_t at = 0;
  uint32_t take(uint32_t count) {
    uint32_t value = 0;
    for (uint32_t i = 0; i < count; ++i, ++at) value |= (std::to_integer<uint32_t>(bytes[at / 8]) >> at % 8 & 1) << i;
    return value;
  }
};

// ---- RGTC: two codes of 8 bits and three bits a texel

// As a fraction of the denominator, times 255: six or four codes between the two, or also 0 and 1.
struct Fraction {
  uint32_t numerator, denominator;
};
Fraction ramp(uint32_t first, uint32_t second, uint32_t index) {
  if (index == 0) return {first, 1};
  if (index == 1) return {second, 1};
  if (first > second) return {(8 - index) * first + (index - 1) * second, 7};
  if (index < 6) return {(6 - index) * first + (index - 1) * second, 5};
  return {index == 6 ? 0u : 255u, 1};
}

void decode_channel(std::span<const std::byte> half, uint32_t channel, DecodedBlock& to) {
  Bits bits{half};
  const uint32_t first = bits.take(8), second = bits.take(8);
  for (size_t i = 0; i < 16; ++i) {
    const auto [numerator, denominator] = ramp(first, second, bits.take(3));
    const uint32_t below = numerator / denominator, above = (numerator + denominator - 1) / denominator;
    const bool is_between = denominator > 1;  // a sum of two products, each off by less than a code
    to.low[i][channel] = static_cast<uint8_t>(is_between && below > 0 ? below - 1 : below);
    to.high[i][channel] = static_cast<uint8_t>(is_between && above < 255 ? above + 1 : above);
  }
}

// ---- BPTC, mode 6: one subset, two ends of 7 bits a channel and a shared lowest bit each, four bits a texel

constexpr uint32_t kWeights[] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};  // of 64

BlockTexels decoded_mode_6(Bits bits) {
  std::array<std::array<uint32_t, 4>, 2> ends = {};
  for (uint32_t channel = 0; channel < 4; ++channel)
    for (auto& end : ends) end[channel] = bits.take(7) << 1;
  for (auto& end : ends) {
    const uint32_t lowest = bits.take(1);
    for (uint32_t& code : end) code |= lowest;
  }
  BlockTexels texels;
  for (size_t i = 0; i < 16; ++i) {
    const uint32_t weight = kWeights[bits.take(i == 0 ? 3 : 4)];  // the first texel's highest bit is 0
    for (uint32_t c = 0; c < 4; ++c)
      texels[i][c] = static_cast<uint8_t>(((64 - weight) * ends[0][c] + weight * ends[1][c] + 32) >> 6);
  }
  return texels;
}

BlockTexels decoded_bptc(std::span<const std::byte> block) {
  Bits bits{block};
  uint32_t mode = 0;
  while (mode < 8 && bits.take(1) == 0) ++mode;
  if (mode == 8) return {};
  if (mode != 6)
    throw std::runtime_error("a BC7 block of mode " + std::to_string(mode) + "; the oracle decodes mode 6 alone");
  return decoded_mode_6(bits);
}

}  // namespace

DecodedBlock decoded_block(Format f, std::span<const std::byte> block) {
  if (block_side(f) != 4 || block.size() != bytes_per_block(f)) throw std::logic_error("not a block of 4x4");
  if (f == Format::bc7_unorm || f == Format::bc7_srgb) {
    const BlockTexels texels = decoded_bptc(block);
    return {texels, texels};
  }
  DecodedBlock d;
  d.low.fill({0, 0, 0, 255});
  d.high = d.low;
  decode_channel(block.first(8), 0, d);
  if (f == Format::bc5_unorm) decode_channel(block.subspan(8), 1, d);
  return d;
}

DecodedTexels decoded_level(const Texture& t, uint32_t layer, uint32_t level) {
  const uint32_t width = width_of(t, level), height = height_of(t, level), block = bytes_per_block(t.format);
  const std::byte* next = t.bytes.data() + offset_of(t, level, layer);
  DecodedTexels all = {Bytes(size_t{4} * width * height), Bytes(size_t{4} * width * height)};
  for (uint32_t y = 0; y < height; y += 4)
    for (uint32_t x = 0; x < width; x += 4, next += block) {
      const DecodedBlock d = decoded_block(t.format, {next, block});
      for (size_t j = 0; j < std::min(4u, height - y); ++j) {
        const size_t at = 4 * ((y + j) * width + x), bytes = size_t{4} * std::min(4u, width - x);
        std::memcpy(&all.low[at], &d.low[4 * j], bytes);
        std::memcpy(&all.high[at], &d.high[4 * j], bytes);
      }
    }
  return all;
}

}  // namespace assay
