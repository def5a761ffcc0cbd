#include "harness/texture.h"

#include <algorithm>
#include <stdexcept>

namespace assay {

namespace {

struct FormatRow {
  Format format;
  const char* name;
  uint32_t bytes, side = 1;
};
constexpr FormatRow kFormats[] = {
    {Format::r8_unorm, "r8_unorm", 1},          {Format::r8_uint, "r8_uint", 1},
    {Format::rg8_unorm, "rg8_unorm", 2},        {Format::rgba8_unorm, "rgba8_unorm", 4},
    {Format::rgba8_srgb, "rgba8_srgb", 4},      {Format::rgba8_uint, "rgba8_uint", 4},
    {Format::r16_unorm, "r16_unorm", 2},        {Format::r16_float, "r16_float", 2},
    {Format::rg16_snorm, "rg16_snorm", 4},      {Format::rg16_unorm, "rg16_unorm", 4},
    {Format::rg16_float, "rg16_float", 4},      {Format::rgba16_float, "rgba16_float", 8},
    {Format::rgba16_uint, "rgba16_uint", 8},    {Format::r32_uint, "r32_uint", 4},
    {Format::r32_float, "r32_float", 4},        {Format::rg32_uint, "rg32_uint", 8},
    {Format::rg32_float, "rg32_float", 8},      {Format::rgba32_uint, "rgba32_uint", 16},
    {Format::rgba32_float, "rgba32_float", 16}, {Format::r11g11b10_float, "r11g11b10_float", 4},
    {Format::rgb9e5_float, "rgb9e5_float", 4},  {Format::bc4_unorm, "bc4_unorm", 8, 4},
    {Format::bc5_unorm, "bc5_unorm", 16, 4},    {Format::bc7_unorm, "bc7_unorm", 16, 4},
    {Format::bc7_srgb, "bc7_srgb", 16, 4},      {Format::d32_float, "d32_float", 4},
};

const FormatRow& row_of(Format f) {
  const auto* row = std::ranges::find(kFormats, f, &FormatRow::format);
  if (row == std::end(kFormats)) throw std::logic_error("a format without a row");
  return *row;
}

}  // namespace

const char* name_of(Format f) { return row_of(f).name; }
uint32_t bytes_per_block(Format f) { return row_of(f).bytes; }
uint32_t block_side(Format f) { return row_of(f).side; }
bool is_srgb(Format f) { return f == Format::rgba8_srgb || f == Format::bc7_srgb; }

uint64_t bytes_of(Format f, uint32_t width, uint32_t height) {
  const auto [format, name, bytes, side] = row_of(f);
  return uint64_t{width / side + (width % side != 0)} * (height / side + (height % side != 0)) * bytes;
}

uint32_t width_of(const Texture& t, uint32_t level) { return std::max(1u, t.width >> level); }
uint32_t height_of(const Texture& t, uint32_t level) { return std::max(1u, t.height >> level); }

uint64_t offset_of(const Texture& t, uint32_t level, uint32_t layer) {
  uint64_t bytes = 0;
  for (uint32_t l = 0; l < level; ++l) bytes += bytes_of(t.format, width_of(t, l), height_of(t, l)) * t.layers;
  return bytes + bytes_of(t.format, width_of(t, level), height_of(t, level)) * layer;
}
uint64_t bytes_of(const Texture& t) { return offset_of(t, t.levels, 0); }

}  // namespace assay
