// A page as large as a game's: 8192 texels a side, in blocks. Nightly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "harness/block_decoder.h"
#include "harness/check/run_case.h"
#include "harness/image/atlas.h"
#include "harness/image/block_textures.h"
#include "kernels/decal_atlas_sampling/inputs.h"
#include "tests/lowered.h"

namespace assay::tests {
namespace {

constexpr uint32_t kSide = 8192, kLevels = 6;

// A disc that fades out over rings, its colour its own.
image::DecalPictures painted(uint32_t width, uint32_t height, Pcg32& rng) {
  image::DecalPictures d = {
      {width, height, {}}, {1, 1, {128, 128, 255, 255}}, {1, 1, {static_cast<uint8_t>(rng.below(256)), 0, 0, 255}}};
  const double hue[3] = {rng.unit(), rng.unit(), rng.unit()}, rings = rng.range(5, 40);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const double r = std::hypot(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1);
      const double ring = 0.75 + 0.25 * std::sin(rings * r);
      for (const double h : hue) d.albedo.texels.push_back(static_cast<uint8_t>(std::lround(255 * h * ring)));
      d.albedo.texels.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(3 - 3 * r, 0.0, 1.0))));
    }
  return d;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double mib(size_t bytes) { return static_cast<double>(bytes) * 0x1p-20; }

double psnr(const Texture& source, const Texture& blocks) {
  double sum = 0, count = 0;
  for (uint32_t level = 0; level < source.levels; ++level) {
    const DecodedTexels d = decoded_level(blocks, 0, level);
    const std::byte* from = source.bytes.data() + offset_of(source, level, 0);
    for (size_t i = 0; i < d.low.size(); ++i, ++count)
      sum += std::pow(std::to_integer<int>(d.low[i]) - std::to_integer<int>(from[i]), 2);
  }
  return 10 * std::log10(255 * 255 * count / sum);
}

TEST(AtlasPage, OfGamesSizeInBlocksIsWhatTheOracleFinds) {
  const Kernel& kernel = kernel_named("decal_atlas_sampling");
  const Variant& variant = variant_of(kernel, "block_compressed");
  const std::string missing = device::missing(device::info(*device()), variant);
  if (!missing.empty()) GTEST_SKIP() << missing;
  Pcg32 rng(8192);
  std::vector<image::DecalPictures> decals;
  for (uint32_t i = 0; i < 560; ++i) decals.push_back(painted(60 + rng.below(320), 60 + rng.below(320), rng));
  auto start = std::chrono::steady_clock::now();
  image::DecalAtlas atlas = image::make_atlas(decals, kSide, kLevels, 4);
  ASSERT_EQ(atlas.textures[0].layers, 1u);
  const double packed_s = seconds_since(start);
  start = std::chrono::steady_clock::now();
  const Texture albedo = image::in_blocks(atlas.textures[0], Format::bc7_srgb);
  const double bc7_s = seconds_since(start);
  EXPECT_EQ(albedo.bytes.size(), uint64_t{kSide} * kSide * 1365 / 1024);
  const double db = psnr(atlas.textures[0], albedo);
  start = std::chrono::steady_clock::now();
  const Texture normal = image::in_blocks(atlas.textures[1], Format::bc5_unorm),
                roughness = image::in_blocks(atlas.textures[2], Format::bc4_unorm);
  fmt::print(
      "560 decals packed in {:.1f} s; BC7 {:.1f} MiB in {:.1f} s, {:.2f} us a block, {:.1f} dB; BC5 and BC4 "
      "{:.1f} MiB in {:.1f} s\n",
      packed_s, mib(albedo.bytes.size()), bc7_s, bc7_s / mib(albedo.bytes.size()) / 0x1p16 * 1e6, db,
      mib(normal.bytes.size() + roughness.bytes.size()), seconds_since(start));
  EXPECT_GE(db, 30);

  decal_atlas_sampling::View v({320, 180});
  v.set_plane(0, 0, 320, 180, {0, 0, -8}, glm::normalize(glm::dvec3(0.5, 0.2, 1)));
  for (uint32_t i = 0; i < 24; ++i) {
    const auto& r = atlas.rectangles[i * 23];
    auto d = decal_atlas_sampling::decal({i % 8 * 2.0 - 7, i / 8 * 3.0 - 3, -8}, {0, 0, 1}, 0.2, {1, 1.5, 6}, {}, 0);
    d.scale_bias = {r.width, r.height, r.u, r.v}, d.page = r.page;
    v.decals.push_back(d);
  }
  Case c = v.to_case();
  c.textures["atlas_blocks"] = {albedo, normal, roughness};  // the variant reads no other
  auto p = c.params<decal_atlas_sampling::DecalParams>();
  p.atlas_border = static_cast<float>(atlas.border);
  c.set_params(p);
  const check::Prepared prepared = check::prepare(kernel, c, device::info(*device()).traits);
  device::Ports ports;
  check::Session session{device(), device_options()};
  const check::Outcome o = check::attempt(session, {.kernel = &kernel, .variant = &variant}, prepared, ports, false);
  EXPECT_EQ(check::fault_of(o, variant).text, "");
}

}  // namespace
}  // namespace assay::tests
