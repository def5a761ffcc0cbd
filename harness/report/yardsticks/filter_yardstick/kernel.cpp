// How exactly the device filters 8-bit textures: the alpha of sRGB ones, and linear ones. Oracles of cut holes and
// sampled colours allow for it; here is what of it the device uses. Places lie on 1/256 of a texel, which weights of 8
// bits hold exactly, so that what is left is the filter's arithmetic.
#include "harness/kernel.h"

#include "harness/oracle.h"

namespace assay::filter_yardstick {

namespace {

constexpr uint32_t kSide = 16;  // texels

Bytes random_texels(Pcg32& rng) {
  Bytes bytes(size_t{4} * kSide * kSide);
  for (std::byte& b : bytes)
    b = std::byte{static_cast<uint8_t>(rng.below(2) ? 255 * rng.below(2) : rng.below(256))};  // half of them extremes
  return bytes;
}

Case scattered(Extent extent) {
  Pcg32 rng(1);
  Case c{.name = "scattered", .extent = extent};
  const Bytes bytes = random_texels(rng);
  for (const Format format : {Format::rgba8_srgb, Format::rgba8_unorm})
    c.textures["textures"].push_back({format, kSide, kSide, 1, 1, bytes});
  std::vector<glm::vec2> places(pixel_count(extent));
  const auto place = [&](uint32_t texel) {
    return (static_cast<float>(texel) + 0.5f + static_cast<float>(rng.below(256)) / 256) / kSide;
  };
  for (uint32_t i = 0; i < places.size(); ++i) places[i] = {place(i % kSide), place(i / kSide % kSide)};
  c.set_input("places", places);
  return c;
}

double bilinear(const Texture& t, glm::vec2 place, uint32_t channel) {
  const double x = double{place.x} * kSide - 0.5, y = double{place.y} * kSide - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  double sum = 0;
  for (const uint32_t dy : {0u, 1u})
    for (const uint32_t dx : {0u, 1u}) {
      const auto column = (static_cast<uint32_t>(left) + dx) % kSide, row = (static_cast<uint32_t>(top) + dy) % kSide;
      const double weight = (dx ? x - left : 1 - x + left) * (dy ? y - top : 1 - y + top);
      sum += weight * static_cast<double>(t.bytes[4 * (size_t{row} * kSide + column) + channel]) / 255;
    }
  return sum;
}

Answer oracle(const Case& c) {
  const auto& textures = c.textures.at("textures");
  std::vector<float> alphas;
  std::vector<glm::vec4> texels;
  for (const glm::vec2 place : c.input<glm::vec2>("places")) {
    alphas.push_back(static_cast<float>(bilinear(textures[0], place, 3)));
    glm::vec4& texel = texels.emplace_back();
    for (int i = 0; i < 4; ++i) texel[i] = static_cast<float>(bilinear(textures[1], place, static_cast<uint32_t>(i)));
  }
  return {{"alphas", expect_all(alphas)}, {"texels", expect_all(texels)}};
}

constexpr const char* kReason = "filtered in the texels' own 8 bits, truncated once an axis";

}  // namespace

Kernel describe() {
  return {
      .name = "filter_yardstick",
      .source = "bilinear filtering at level 0, Vulkan 1.3, Texel Filtering",
      .default_variant = "filter",
      .ports = {reads<glm::vec2>("places", pixels), reads_textures("textures", 2), writes<float>("alphas", pixels),
                writes<glm::vec4>("texels", pixels)},
      .variants = {{.name = "filter",
                    .passes = {Dispatch{
                        "filter.comp", [](const Case& c) { return Groups{static_cast<uint32_t>(pixels(c) / 256)}; }}}}},
      .oracle = oracle,
      .inputs = {},
      .bounds = {within("alphas", 2.0 / 255, kReason), within("texels", 2.0 / 255, kReason)},
      .cost = [](const Case& c) { return Cost{.bytes_read = 8 * pixels(c), .bytes_written = 20 * pixels(c)}; },
      .typical = scattered,
      .extents = {{256, 64}},
  };
}

}  // namespace assay::filter_yardstick
