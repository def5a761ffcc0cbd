// Mip chains by box filter of linear values, packed one array a size and format.
#include "harness/scene/textures.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace assay::scene {
namespace {

constexpr uint32_t kMostArrays = 16;   // sampler arrays of the shaders
constexpr uint32_t kMostLayers = 256;  // maxImageArrayLayers that every Vulkan device has

double srgb_to_linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

// Linear value of every sRGB code, and the linear values halfway between neighbouring codes: rounding is to the
// nearest code in sRGB.
struct Srgb {
  std::array<float, 256> linear;
  std::array<float, 255> halfway;
};
const Srgb& srgb() {
  static const Srgb table = [] {
    Srgb t;
    for (uint32_t i = 0; i < 256; ++i) t.linear[i] = static_cast<float>(srgb_to_linear(i / 255.0));
    for (uint32_t i = 0; i < 255; ++i) t.halfway[i] = static_cast<float>(srgb_to_linear((i + 0.5) / 255.0));
    return t;
  }();
  return table;
}

struct LinearImage {  // RGBA, alpha as stored
  uint32_t width = 0, height = 0;
  std::vector<float> texels;
};

bool is_curved(Format format, size_t component) { return format == Format::rgba8_srgb && component % 4 != 3; }

LinearImage to_linear(const Image& image, Format format) {
  LinearImage out = {image.width, image.height, std::vector<float>(image.rgba.size())};
  for (size_t i = 0; i < image.rgba.size(); ++i)
    out.texels[i] = is_curved(format, i) ? srgb().linear[image.rgba[i]] : static_cast<float>(image.rgba[i]) / 255.0f;
  return out;
}

void append_encoded(const LinearImage& image, Format format, Bytes& to) {
  for (size_t i = 0; i < image.texels.size(); ++i) {
    const float v = image.texels[i];
    const std::array<float, 255>& halfway = srgb().halfway;
    const uint32_t code =
        is_curved(format, i)
            ? static_cast<uint32_t>(std::upper_bound(halfway.begin(), halfway.end(), v) - halfway.begin())
            : static_cast<uint32_t>(std::lround(v * 255.0f));
    to.push_back(static_cast<std::byte>(code));
  }
}

// The texels of a finer row that one coarser texel covers, weighted by how much of each (odd sizes cover parts).
struct Tap {
  uint32_t texel;
  float weight;
};
std::vector<std::vector<Tap>> box_taps(uint32_t fine, uint32_t coarse) {
  std::vector<std::vector<Tap>> taps(coarse);
  const double step = static_cast<double>(fine) / coarse;
  for (uint32_t i = 0; i < coarse; ++i)
    for (uint32_t t = static_cast<uint32_t>(i * step); t < fine && t < (i + 1) * step; ++t) {
      const double covered = std::min(t + 1.0, (i + 1) * step) - std::max<double>(t, i * step);
      taps[i].push_back({t, static_cast<float>(covered / step)});
    }
  return taps;
}

LinearImage halve(const LinearImage& fine) {
  LinearImage out = {std::max(1u, fine.width / 2), std::max(1u, fine.height / 2), {}};
  const auto across = box_taps(fine.width, out.width), down = box_taps(fine.height, out.height);
  out.texels.assign(size_t{out.width} * out.height * 4, 0.0f);
  for (uint32_t y = 0; y < out.height; ++y)
    for (uint32_t x = 0; x < out.width; ++x)
      for (const Tap& v : down[y])
        for (const Tap& h : across[x])
          for (size_t c = 0; c < 4; ++c)
            out.texels[(size_t{y} * out.width + x) * 4 + c] +=
                v.weight * h.weight * fine.texels[(size_t{v.texel} * fine.width + h.texel) * 4 + c];
  return out;
}

// Levels of one image, encoded: level 0 keeps the file's bytes.
std::vector<Bytes> mip_chain(const Image& image, Format format) {
  const auto b = std::as_bytes(std::span(image.rgba));
  std::vector<Bytes> levels = {Bytes(b.begin(), b.end())};
  for (LinearImage level = to_linear(image, format); level.width > 1 || level.height > 1;) {
    level = halve(level);
    append_encoded(level, format, levels.emplace_back());
  }
  return levels;
}

}  // namespace

TextureArrays pack_textures(const Scene& scene, const std::vector<ImageUse>& uses) {
  TextureArrays out;
  std::vector<std::vector<const Image*>> members;
  for (const ImageUse& use : uses) {
    const Image& image = scene.images[use.image];
    const auto fits = [&](size_t a) {
      const Texture& t = out.textures[a];
      return t.format == use.format && t.width == image.width && t.height == image.height &&
             members[a].size() < kMostLayers;
    };
    size_t a = 0;
    while (a < members.size() && !fits(a)) ++a;
    if (a == members.size()) {
      members.emplace_back();
      out.textures.push_back({.format = use.format, .width = image.width, .height = image.height});
    }
    out.names.push_back(static_cast<uint32_t>(a << 16 | members[a].size()));
    members[a].push_back(&image);
  }
  if (members.size() > kMostArrays)
    throw std::runtime_error(
        fmt::format("{}: its images need {} array textures, one a size and colour space, and {} at most can be bound; "
                    "resize some to agree",
                    scene.name, members.size(), kMostArrays));
  for (size_t a = 0; a < members.size(); ++a) {
    Texture& texture = out.textures[a];
    texture.layers = static_cast<uint32_t>(members[a].size());
    texture.levels = static_cast<uint32_t>(std::bit_width(std::max(texture.width, texture.height)));
    std::vector<std::vector<Bytes>> chains;
    for (const Image* image : members[a]) chains.push_back(mip_chain(*image, texture.format));
    for (uint32_t level = 0; level < texture.levels; ++level)
      for (const std::vector<Bytes>& chain : chains)
        texture.bytes.insert(texture.bytes.end(), chain[level].begin(), chain[level].end());
  }
  return out;
}

}  // namespace assay::scene
