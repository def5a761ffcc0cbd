// Blocks of 4x4 texels: what the device makes of them against the decoder, and what the encoders lose.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "harness/block_decoder.h"
#include "harness/image/bc7.h"
#include "harness/image/block_textures.h"
#include "harness/image/image.h"
#include "harness/oracle.h"
#include "tests/lowered.h"
#include "tests/planted/device_texels/layout.h"

namespace assay::tests {
namespace {

using device_texels::TexelParams;

constexpr Format kBlockFormats[] = {Format::bc4_unorm, Format::bc5_unorm, Format::bc7_unorm, Format::bc7_srgb};

// Any bits are a block of BC4 and BC5; of BC7 those that name mode 6.
Texture random_blocks(Format f, uint32_t width, uint32_t height, uint32_t layers, uint32_t levels) {
  Texture t = {.format = f, .width = width, .height = height, .layers = layers, .levels = levels};
  Pcg32 rng(width * 100 + height);
  t.bytes.resize(bytes_of(t));
  for (std::byte& b : t.bytes) b = static_cast<std::byte>(rng.next());
  if (f == Format::bc7_unorm || f == Format::bc7_srgb)
    for (size_t at = 0; at < t.bytes.size(); at += 16) t.bytes[at] = (t.bytes[at] & std::byte{0x80}) | std::byte{0x40};
  return t;
}

struct Read {
  std::vector<glm::vec4> fetched, sampled;
};
Read read_level(const Texture& t, uint32_t layer, uint32_t level) {
  Case c = {.name = "texels", .extent = {width_of(t, level), height_of(t, level)}};
  c.set_params(TexelParams{c.extent.width, c.extent.height, layer, level});
  c.textures["textures"] = {t};
  const Ran r = run_variant(*device(), planted("device_texels"), "read", c);
  return {read<glm::vec4>(*device(), r, "fetched"), read<glm::vec4>(*device(), r, "sampled")};
}

double linear_of(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

// BC7's code to the bit, an sRGB one as the code that it is nearest to. BC4's and BC5's between the codes.
void expect_texel(const Texture& t, const DecodedTexels& d, size_t i, const glm::vec4& got) {
  for (int channel = 0; channel < 4; ++channel) {
    const size_t at = 4 * i + static_cast<size_t>(channel);
    double low = std::to_integer<int>(d.low[at]) / 255.0, high = std::to_integer<int>(d.high[at]) / 255.0;
    if (is_srgb(t.format) && channel < 3) {  // half a code, as the oracles allow of any sRGB texel
      low = linear_of(std::max(low - 0.5 / 255, 0.0)), high = linear_of(std::min(high + 0.5 / 255, 1.0));
      ASSERT_TRUE(got[channel] >= low && got[channel] <= high)
          << "texel " << i << ", channel " << channel << ": " << got[channel] << " for " << low << " to " << high;
      continue;
    }
    const double rounding = 3 * kUnitRoundoff;  // of the code over 255
    ASSERT_TRUE(got[channel] >= low * (1 - rounding) && got[channel] <= high * (1 + rounding))
        << name_of(t.format) << ", texel " << i << ", channel " << channel << ": " << 255 * double{got[channel]}
        << " for " << 255 * low << " to " << 255 * high;
  }
}

// At a texel's centre: within a step of the weights an axis, and three roundings to 8 bits.
void expect_sampled(const Read& got) {
  const double room = 3.0 / 255 + 2 * std::ldexp(1.0, -static_cast<int>(device::info(*device()).traits.sub_texel_bits));
  for (size_t i = 0; i < got.sampled.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      ASSERT_NEAR(got.sampled[i][channel], got.fetched[i][channel], room) << "texel " << i;
}

// Sizes below a block, and that end within one.
TEST(Blocks, TheDeviceDecodesThemAsTheOracleDoes) {
  const auto missing = device::missing(device::info(*device()), planted("device_texels").variants[0]);
  if (!missing.empty()) GTEST_SKIP() << missing;
  for (const Format f : kBlockFormats)
    for (const Extent e : {Extent{64, 32}, Extent{30, 26}, Extent{5, 3}, Extent{1, 1}, Extent{2, 17}}) {
      const auto levels = static_cast<uint32_t>(std::bit_width(std::max(e.width, e.height)));
      const Texture t = random_blocks(f, e.width, e.height, 2, levels);
      for (uint32_t level = 0; level < levels; ++level)
        for (uint32_t layer = 0; layer < 2; ++layer) {
          SCOPED_TRACE(fmt::format("{} {}x{}, level {}, layer {}", name_of(f), e.width, e.height, level, layer));
          const DecodedTexels d = decoded_level(t, layer, level);
          const Read got = read_level(t, layer, level);
          for (size_t i = 0; i < got.fetched.size(); ++i) expect_texel(t, d, i, got.fetched[i]);
          if (!is_srgb(f)) expect_sampled(got);
        }
    }
}

TEST(Blocks, ComeBackFromTheDeviceAsTheyWere) {
  if (!device::info(*device()).features.contains(Feature::texture_compression_bc)) GTEST_SKIP() << "no BC textures";
  for (const Format f : kBlockFormats) {
    const Texture all[] = {random_blocks(f, 30, 26, 3, 5), random_blocks(f, 4096, 4096, 1, 13)};
    const auto textures = device::make_textures(*device(), "textures", all, 2);
    Bytes expected = all[0].bytes;
    expected.insert(expected.end(), all[1].bytes.begin(), all[1].bytes.end());
    EXPECT_TRUE(device::read(*device(), *textures) == expected) << name_of(f);
  }
}

TEST(Blocks, HoldTheBytesOfWholeBlocks) {
  EXPECT_EQ(bytes_of({.format = Format::bc7_srgb, .width = 8, .height = 8, .levels = 4}), 16u * (4 + 1 + 1 + 1));
  EXPECT_EQ(bytes_of({.format = Format::bc4_unorm, .width = 5, .height = 9, .layers = 3}), 8u * 2 * 3 * 3);
  EXPECT_EQ(bytes_of(Format::rg8_unorm, 5, 9), 90u);
}

// ---- The encoders

BlockTexels decoded(const std::array<std::byte, 16>& block) { return decoded_block(Format::bc7_unorm, block).low; }
BlockTexels single(std::array<uint8_t, 4> colour) {
  BlockTexels t;
  t.fill(colour);
  return t;
}
int off(const BlockTexels& a, const BlockTexels& b) {
  int most = 0;
  for (size_t i = 0; i < 16; ++i)
    for (size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]));
  return most;
}

TEST(Blocks, OfOneColourAreExactButWhereZeroMeets255) {
  const bool passed = rc::check("single", [] {
    const auto code = [] { return static_cast<uint8_t>(*rc::gen::inRange(0, 256)); };
    const std::array<uint8_t, 4> c = {code(), code(), code(), *rc::gen::element<uint8_t>(0, 255, code())};
    const bool meets = std::ranges::count(c, 0) > 0 && std::ranges::count(c, 255) > 0;
    RC_ASSERT(off(decoded(image::bc7_block(single(c))), single(c)) <= (meets ? 1 : 0));
  });
  EXPECT_TRUE(passed);
  for (int v = 0; v < 256; ++v) {
    const auto code = static_cast<uint8_t>(v);
    EXPECT_EQ(off(decoded(image::bc7_block(single({code, code, code, code}))), single({code, code, code, code})), 0);
  }
  const BlockTexels black = single({0, 0, 0, 255});
  EXPECT_EQ(decoded(image::bc7_block(black))[7][3], 255) << "what is opaque stays so";
}

// Two colours of one parity are ends of a line; the halves are told apart wherever the first texel is.
TEST(Blocks, OfTwoColoursHoldBoth) {
  for (const bool is_first : {false, true}) {
    BlockTexels t = single({255, 1, 101, 255});
    for (size_t i = 0; i < 16; ++i)
      if (is_first == (i < 5)) t[i] = {1, 255, 11, 255};
    EXPECT_EQ(off(decoded(image::bc7_block(t)), t), 0);
  }
}

double squared_error(const BlockTexels& a, const BlockTexels& b) {
  double sum = 0;
  for (size_t i = 0; i < 16; ++i)
    for (size_t c = 0; c < 4; ++c) sum += (c == 3 ? 3 : 1) * std::pow(a[i][c] - b[i][c], 2);
  return sum;
}
// Rounding the mean to codes costs half a code a channel, alpha's counted three times, and its lowest bits a code.
TEST(Blocks, OfNoiseAreNoWorseThanTheirMean) {
  const bool passed = rc::check("noise", [] {
    BlockTexels t;
    for (auto& texel : t)
      for (uint8_t& c : texel) c = static_cast<uint8_t>(*rc::gen::inRange(0, 256));
    std::array<uint8_t, 4> mean = {};
    for (size_t c = 0; c < 4; ++c) {
      double sum = 0;
      for (const auto& texel : t) sum += texel[c];
      mean[c] = static_cast<uint8_t>(std::lround(sum / 16));
    }
    RC_ASSERT(squared_error(decoded(image::bc7_block(t)), t) <= squared_error(single(mean), t) + 16 * 6);
  });
  EXPECT_TRUE(passed);
}

// ---- What pictures lose

using Texels = std::function<std::array<double, 4>(double u, double v)>;  // 0..1
Texture drawn(uint32_t side, const Texels& at) {
  Texture t = {.format = Format::rgba8_unorm, .width = side, .height = side};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x)
      for (const double v : at((x + 0.5) / side, (y + 0.5) / side))
        t.bytes.push_back(static_cast<std::byte>(std::lround(255 * std::clamp(v, 0.0, 1.0))));
  return t;
}
Texture picture(const image::Rgba8& p) {
  Texture t = {.format = Format::rgba8_unorm, .width = p.width, .height = p.height};
  const auto bytes = std::as_bytes(std::span(p.texels));
  t.bytes.assign(bytes.begin(), bytes.end());
  return t;
}

// Over the channels that a format has; the nearer of the codes that a device may find counts for none.
double psnr(const Texture& source, Format f) {
  const DecodedTexels d = decoded_level(image::in_blocks(source, f), 0, 0);
  const size_t channels = f == Format::bc4_unorm ? 1 : f == Format::bc5_unorm ? 2 : 4;
  double sum = 0, count = 0;
  for (size_t i = 0; i < source.bytes.size(); ++i) {
    if (i % 4 >= channels) continue;
    const double middle = (std::to_integer<int>(d.low[i]) + std::to_integer<int>(d.high[i])) / 2.0;
    sum += std::pow(middle - std::to_integer<int>(source.bytes[i]), 2), ++count;
  }
  return sum > 0 ? 10 * std::log10(255 * 255 * count / sum) : 99;
}
void expect_psnr(const std::string& what, const Texture& t, Format f, double at_least) {
  const double db = psnr(t, f);
  fmt::print("{:<24} {:<9} {:5.1f} dB\n", what, name_of(f), db);
  EXPECT_GE(db, at_least) << what;
}

// Goals of 2 dB under what was measured (README of decal_atlas_sampling), so that a worse encoder is seen.
TEST(Blocks, OfProceduralPicturesLoseLittle) {
  const Texture smooth = drawn(256, [](double u, double v) -> std::array<double, 4> {
    return {u, v, 0.5 + 0.4 * std::sin(6 * u) * v, 1};
  });
  const Texture disc = drawn(256, [](double u, double v) -> std::array<double, 4> {
    return {0.6 + 0.3 * u, 0.2, 0.1 + 0.2 * v, 3 - 6 * std::hypot(u - 0.5, v - 0.5)};
  });
  const Texture checks = drawn(256, [](double u, double v) -> std::array<double, 4> {
    const bool odd = (static_cast<int>(u * 37) + static_cast<int>(v * 37)) % 2 != 0;
    return {odd ? 0.9 : 0.1, odd ? 0.2 : 0.7, 0.3, 1};
  });
  const Texture bumps = drawn(256, [](double u, double v) -> std::array<double, 4> {
    return {0.5 + 0.3 * std::sin(20 * u) * std::cos(9 * v), 0.5 + 0.3 * std::cos(13 * u + 20 * v), 1, 1};
  });
  expect_psnr("smooth", smooth, Format::bc7_srgb, 50);
  expect_psnr("disc", disc, Format::bc7_srgb, 51.9);
  expect_psnr("checks", checks, Format::bc7_srgb, 53.8);
  expect_psnr("bumps", bumps, Format::bc5_unorm, 47.5);
  expect_psnr("bumps", bumps, Format::bc4_unorm, 49);
}

TEST(Blocks, OfRealDecalsLoseLittle) {
  const char* data = std::getenv("ASSAY_DATA");
  const std::filesystem::path folder = std::filesystem::path(data ? data : "../shared/data") / "decals";
  if (!std::filesystem::exists(folder / "decal_00_albedo.png"))
    GTEST_SKIP() << "no decals in " << folder << "; set ASSAY_DATA to the folder that holds decals/";
  constexpr double kColours[] = {33.7, 35.4, 32.7, 39, 31}, kNormals[] = {45.3, 44.7, 42.9, 46.2, 44.9};
  for (size_t i = 0; i < 5; ++i) {
    const std::string name = fmt::format("decal_{:02}", i);
    expect_psnr(name, picture(image::read_png(folder / (name + "_albedo.png"))), Format::bc7_srgb, kColours[i]);
    expect_psnr(name, picture(image::read_png(folder / (name + "_normal.png"))), Format::bc5_unorm, kNormals[i]);
  }
}

}  // namespace
}  // namespace assay::tests
