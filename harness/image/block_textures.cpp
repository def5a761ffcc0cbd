#include "harness/image/block_textures.h"

#include <nvtt/nvtt.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "harness/image/bc7.h"

namespace assay::image {

namespace {

struct Layer {  // of one level
  const std::byte* texels;
  uint32_t width, height;
  uint32_t columns() const { return width / 4 + (width % 4 != 0); }
  uint32_t rows() const { return height / 4 + (height % 4 != 0); }
  const std::byte* at(uint32_t x, uint32_t y) const {
    return texels + 4 * (size_t{std::min(y, height - 1)} * width + std::min(x, width - 1));
  }
};

void put_bc7_row(const Layer& l, uint32_t row, std::byte* to) {
  for (uint32_t column = 0; column < l.columns(); ++column, to += 16) {
    BlockTexels texels;
    for (uint32_t i = 0; i < 16; ++i) std::memcpy(texels[i].data(), l.at(4 * column + i % 4, 4 * row + i / 4), 4);
    const auto block = bc7_block(texels);
    std::memcpy(to, block.data(), block.size());
  }
}
void put_bc7(const Layer& l, std::byte* to) {
  std::atomic<uint32_t> next = 0;
  const auto work = [&] {
    for (uint32_t row = next++; row < l.rows(); row = next++) put_bc7_row(l, row, to + size_t{row} * l.columns() * 16);
  };
  std::vector<std::jthread> others;
  const uint32_t most = l.rows() / 16;  // what is small is done before a thread starts
  for (uint32_t i = 1; i < std::min(std::thread::hardware_concurrency(), most); ++i) others.emplace_back(work);
  work();
}

struct Written : nvtt::OutputHandler {
  Bytes bytes;
  void beginImage(int, int, int, int, int, int) override {}
  bool writeData(const void* data, int size) override {
    const auto* from = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), from, from + size);
    return true;
  }
};

// The library takes BGRA in whole blocks.
Bytes bc5_of(const Layer& l) {
  const uint32_t width = 4 * l.columns(), height = 4 * l.rows();
  Bytes bgra;
  bgra.reserve(size_t{4} * width * height);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const std::byte* t = l.at(x, y);
      for (const std::byte code : {t[2], t[1], t[0], t[3]}) bgra.push_back(code);
    }
  nvtt::InputOptions input;
  input.setTextureLayout(nvtt::TextureType_2D, static_cast<int>(width), static_cast<int>(height));
  input.setMipmapData(bgra.data(), static_cast<int>(width), static_cast<int>(height));
  input.setMipmapGeneration(false);
  input.setGamma(1, 1);
  nvtt::CompressionOptions compression;
  compression.setFormat(nvtt::Format_BC5);
  Written written;
  nvtt::OutputOptions output;
  output.setOutputHandler(&written);
  output.setOutputHeader(false);
  nvtt::Compressor compressor;
  compressor.enableCudaAcceleration(false);
  if (!compressor.process(input, compression, output) || written.bytes.size() != size_t{l.columns()} * l.rows() * 16)
    throw std::runtime_error("libnvtt made no BC5 blocks");
  return std::move(written.bytes);
}

void put(const Layer& l, Format f, std::byte* to) {
  if (f == Format::bc7_unorm || f == Format::bc7_srgb) return put_bc7(l, to);
  const Bytes pairs = bc5_of(l);  // red's block, then green's
  const size_t kept = bytes_per_block(f);
  for (size_t at = 0; at < pairs.size(); at += 16, to += kept) std::memcpy(to, &pairs[at], kept);
}

}  // namespace

Texture in_blocks(const Texture& from, Format f) {
  if (bytes_per_block(from.format) != 4 || block_side(from.format) != 1 || block_side(f) != 4)
    throw std::logic_error(std::string("no way from ") + name_of(from.format) + " to " + name_of(f));
  Texture t = {.format = f, .width = from.width, .height = from.height, .layers = from.layers, .levels = from.levels};
  t.bytes.resize(bytes_of(t));
  for (uint32_t level = 0; level < t.levels; ++level)
    for (uint32_t layer = 0; layer < t.layers; ++layer)
      put({from.bytes.data() + offset_of(from, level, layer), width_of(t, level), height_of(t, level)}, f,
          t.bytes.data() + offset_of(t, level, layer));
  return t;
}

}  // namespace assay::image
