// Images on disk: PNG through libpng, multi-layer OpenEXR. Errors throw std::runtime_error: file, what.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace assay::image {

struct Rgba8 {  // sRGB, rows top to bottom
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> texels;  // 4 bytes each
};
void write_png(const std::filesystem::path&, const Rgba8&);
Rgba8 read_png(const std::filesystem::path&);
Rgba8 decode_png(std::span<const uint8_t>);

enum class Sample { half, float32, uint32 };
// One channel of a one-part EXR, with a dotted name such as "radiance.R"; values are stored as `sample`.
struct Channel {
  std::string name;
  Sample sample = Sample::float32;
  std::vector<float> values;       // half and float32
  std::vector<uint32_t> integers;  // uint32
};
struct Layers {
  uint32_t width = 0, height = 0;
  std::vector<Channel> channels;
};
void write_exr(const std::filesystem::path&, const Layers&);  // ZIP
Layers read_exr(const std::filesystem::path&);

struct LegendRow {
  uint8_t r, g, b;
  std::string text;  // ASCII
};
// The image with a strip of colour swatches and text below it, in as many columns as fit.
Rgba8 with_legend(const Rgba8&, const std::string& title, std::span<const LegendRow>);

}  // namespace assay::image
