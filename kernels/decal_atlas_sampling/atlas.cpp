// Atlases made by code.
#include <array>
#include <cmath>

#include "kernels/decal_atlas_sampling/inputs.h"

namespace assay::decal_atlas_sampling {

namespace {

using Texel = std::array<double, 4>;  // 0..1; colours linear

double srgb_of(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
std::byte code(double v) { return static_cast<std::byte>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); }

double hashed(uint64_t seed, uint64_t i) { return Pcg32(seed, i).unit(); }

// The `which`-th of the atlas's textures at a texel of its first level.
Texel painted(const AtlasPlan& p, uint32_t which, uint32_t page, uint32_t x, uint32_t y) {
  const uint32_t column = x / p.side, row = y / p.side;
  const uint64_t cell = (uint64_t{page} * 1000 + row) * 1000 + column;
  const double u = (x % p.side + 0.5) / p.side * 2 - 1, v = (y % p.side + 0.5) / p.side * 2 - 1;
  const double r = std::sqrt(u * u + v * v);
  if (which == kAtlasNormal) {
    const double steep = 0.8 * hashed(p.seed, cell * 4 + 3) - 0.4;
    return {0.5 + 0.5 * steep * u, 0.5 + 0.5 * steep * v, 1, 1};
  }
  if (which == kAtlasRoughness) return {0.3 + 0.4 * hashed(p.seed, cell * 4 + 2) + 0.2 * u, 0, 0, 1};
  return {hashed(p.seed, cell * 4) * (0.7 + 0.3 * u), hashed(p.seed, cell * 4 + 1) * (0.7 + 0.3 * v), 0.5 + 0.4 * u * v,
          std::clamp(3 * (1 - r), 0.0, 1.0)};
}

Texel loud(const AtlasPlan& p, uint32_t which, uint32_t x, uint32_t y) {
  const bool odd = (x / p.side + y / p.side) % 2 != 0;
  if (which == kAtlasNormal) return {odd ? 0.9 : 0.1, 0.5, 1, 1};
  if (which == kAtlasRoughness) return {odd ? 1.0 : 0.0, 0, 0, 1};
  return {odd ? 1.0 : 0.0, odd ? 0.0 : 1.0, 0, 1};
}

Texel texel_at(const AtlasPlan& p, uint32_t which, uint32_t page, uint32_t x, uint32_t y) {
  switch (p.look) {
    case AtlasPlan::Look::loud:
      return loud(p, which, x, y);
    case AtlasPlan::Look::stripes:
      if (which != kAtlasAlbedo) return {0.5, 0.5, 1, 1};
      return {x / 8 % 2 != 0 ? 1.0 : 0.0, y / 8 % 2 != 0 ? 0.8 : 0.1, 0.2, 1};
    default:
      return painted(p, which, page, x, y);
  }
}

Texel of_level(uint32_t level) { return {level % 2 != 0 ? 0.9 : 0.1, 0.2 + 0.15 * level, level % 3 * 0.4, 1}; }

// Four texels to one: the mean, of colours in linear light.
std::vector<Texel> halved(const std::vector<Texel>& from, uint32_t width, uint32_t height) {
  std::vector<Texel> to(from.size() / 4);
  for (uint32_t y = 0; y < height / 2; ++y)
    for (uint32_t x = 0; x < width / 2; ++x)
      for (uint32_t c = 0; c < 4; ++c) {
        const auto at = [&](uint32_t dx, uint32_t dy) { return from[(2 * y + dy) * width + 2 * x + dx][c]; };
        to[y * (width / 2) + x][c] = (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4;
      }
  return to;
}

Texture page_of(const AtlasPlan& p, uint32_t which) {
  const bool srgb = which == kAtlasAlbedo;
  Texture t = {.format = srgb ? Format::rgba8_srgb : Format::rgba8_unorm,
               .width = p.width,
               .height = p.height,
               .layers = p.pages,
               .levels = p.levels};
  std::vector<std::vector<Texel>> pages(p.pages, std::vector<Texel>(size_t{p.width} * p.height));
  for (uint32_t page = 0; page < p.pages; ++page)
    for (uint32_t y = 0; y < p.height; ++y)
      for (uint32_t x = 0; x < p.width; ++x) pages[page][size_t{y} * p.width + x] = texel_at(p, which, page, x, y);
  for (uint32_t level = 0; level < p.levels; ++level)
    for (auto& page : pages) {
      if (level > 0) page = halved(page, p.width >> (level - 1), p.height >> (level - 1));
      for (Texel texel : page) {
        if (p.look == AtlasPlan::Look::levels && srgb) texel = of_level(level);
        for (uint32_t c = 0; c < 4; ++c) t.bytes.push_back(code(srgb && c < 3 ? srgb_of(texel[c]) : texel[c]));
      }
    }
  return t;
}

}  // namespace

std::vector<Texture> atlas_of(const AtlasPlan& p) { return {page_of(p, 0), page_of(p, 1), page_of(p, 2)}; }

}  // namespace assay::decal_atlas_sampling
