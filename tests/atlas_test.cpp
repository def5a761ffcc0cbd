// The atlas that decals are packed into, and what the kernel reads of it.
#include "harness/image/atlas.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <filesystem>

#include "harness/block_decoder.h"
#include "harness/check/run_case.h"
#include "harness/image/block_textures.h"
#include "kernels/decal_atlas_sampling/inputs.h"
#include "tests/lowered.h"

namespace assay::tests {
namespace {

using decal_atlas_sampling::View;
using glm::dvec3;
using image::DecalAtlas;
using image::DecalPictures;
using image::PagePlace;
using image::Rgba8;

using Colour = std::array<uint8_t, 4>;

Rgba8 flat(uint32_t width, uint32_t height, Colour c) {
  Rgba8 p = {width, height, {}};
  for (uint32_t i = 0; i < width * height; ++i) p.texels.insert(p.texels.end(), c.begin(), c.end());
  return p;
}
// Corners of the colour cube: any mixture of two is far from both.
Colour loud(size_t i) {
  const auto bit = [i](uint32_t shift) { return static_cast<uint8_t>(i >> shift & 1 ? 255 : 0); };
  return {bit(0), bit(1), bit(2), 255};
}
DecalPictures loud_decal(size_t i, Extent e) {
  const Colour c = loud(i);
  return {flat(e.width, e.height, c), flat(1, 1, {static_cast<uint8_t>(i % 2 ? 255 : 0), 128, 0, 0}),
          flat(e.width, e.height, {c[0], 0, 0, 0})};
}
// Each beside others of other colours, sizes odd and even, one of a texel.
std::vector<DecalPictures> loud_decals() {
  const Extent sizes[] = {{64, 64}, {37, 21}, {16, 50}, {1, 1}, {33, 64}, {8, 8}, {5, 90}};
  std::vector<DecalPictures> all;
  for (size_t i = 0; i < 40; ++i) all.push_back(loud_decal(i * 5 % 7 + i % 2, sizes[i % std::size(sizes)]));
  return all;
}

Colour texel_of(const Texture& t, uint32_t level, uint32_t page, uint32_t x, uint32_t y) {
  uint64_t at = 0;
  for (uint32_t l = 0; l < level; ++l) at += uint64_t{t.width >> l} * (t.height >> l) * t.layers * 4;
  const uint32_t width = t.width >> level, height = t.height >> level;
  at += ((uint64_t{page} * height + y) * width + x) * 4;
  Colour c;
  std::memcpy(c.data(), t.bytes.data() + at, 4);
  return c;
}

bool are_apart(PagePlace a, Extent e, PagePlace b, Extent f) {
  return a.page != b.page || a.x + e.width <= b.x || b.x + f.width <= a.x || a.y + e.height <= b.y ||
         b.y + f.height <= a.y;
}

TEST(Atlas, RectanglesLieOnPagesAndNoneOnAnother) {
  const bool passed = rc::check("packed", [] {
    const auto count = *rc::gen::inRange<size_t>(0, 60);
    std::vector<Extent> sizes;
    for (size_t i = 0; i < count; ++i) sizes.push_back({*rc::gen::inRange(1u, 65u), *rc::gen::inRange(1u, 65u)});
    const auto places = image::pack_shelves(sizes, 64);
    RC_ASSERT(places.size() == count);
    for (size_t i = 0; i < count; ++i) {
      RC_ASSERT(places[i].x + sizes[i].width <= 64 && places[i].y + sizes[i].height <= 64);
      for (size_t j = 0; j < i; ++j) RC_ASSERT(are_apart(places[i], sizes[i], places[j], sizes[j]));
    }
  });
  EXPECT_TRUE(passed);
}

TEST(Atlas, EqualSquaresFillTheirPages) {
  const std::vector<Extent> sizes(32, Extent{16, 16});
  uint32_t pages = 0;
  for (const PagePlace& p : image::pack_shelves(sizes, 64)) pages = std::max(pages, p.page + 1);
  EXPECT_EQ(pages, 2u);
}

TEST(Atlas, RefusesWhatDoesNotFit) {
  const std::vector<Extent> wide = {{65, 3}}, empty = {{0, 3}};
  EXPECT_THROW(image::pack_shelves(wide, 64), std::runtime_error);
  EXPECT_THROW(image::pack_shelves(empty, 64), std::runtime_error);
  const std::vector<DecalPictures> unequal = {{flat(4, 4, {}), flat(5, 4, {}), flat(1, 1, {})}};
  EXPECT_THROW(image::make_atlas(unequal, 64, 3), std::runtime_error);
  EXPECT_THROW(image::make_atlas({}, 60, 4), std::runtime_error);
  EXPECT_THROW(image::make_atlas({}, 80, 4, 4), std::runtime_error);
}

// A last level's texel is red or green, never both, and the border has the colour of what it surrounds.
TEST(Atlas, NoTexelOfAnyLevelHoldsTwoDecals) {
  const auto decals = loud_decals();
  const uint32_t levels = 5;
  const DecalAtlas atlas = image::make_atlas(decals, 512, levels);
  ASSERT_EQ(atlas.rectangles.size(), decals.size());
  for (size_t i = 0; i < decals.size(); ++i) {
    const auto& r = atlas.rectangles[i];
    for (uint32_t level = 0; level < levels; ++level) {
      const double size = 512u >> level;
      const auto from_x = static_cast<uint32_t>(std::floor(r.u * size - 0.5625)),
                 from_y = static_cast<uint32_t>(std::floor(r.v * size - 0.5625));
      for (uint32_t y = from_y; y < (r.v + r.height) * size + 0.5625; ++y)
        for (uint32_t x = from_x; x < (r.u + r.width) * size + 0.5625; ++x)
          ASSERT_EQ(texel_of(atlas.textures[0], level, r.page, x, y), loud(i * 5 % 7 + i % 2))
              << "decal " << i << ", level " << level << ", texel " << x << ", " << y;
    }
  }
}

// Codes that blocks are off their decal's colour at any level, within the decal and half a texel of its border.
int worst_of_blocks(uint32_t block) {
  const auto decals = loud_decals();
  const uint32_t levels = 5;
  const DecalAtlas atlas = image::make_atlas(decals, 512, levels, block);
  const Texture blocks = image::in_blocks(atlas.textures[0], Format::bc7_srgb);
  int worst = 0;
  for (uint32_t level = 0; level < levels; ++level)
    for (uint32_t page = 0; page < blocks.layers; ++page) {
      const DecodedTexels d = decoded_level(blocks, page, level);
      for (size_t i = 0; i < decals.size(); ++i) {
        const auto& r = atlas.rectangles[i];
        if (r.page != page) continue;
        const double size = 512u >> level;
        const auto from = [size](float at) { return static_cast<uint32_t>(std::floor(at * size - 0.5625)); };
        for (uint32_t y = from(r.v); y < (r.v + r.height) * size + 0.5625; ++y)
          for (uint32_t x = from(r.u); x < (r.u + r.width) * size + 0.5625; ++x)
            for (size_t c = 0; c < 4; ++c)
              worst = std::max(worst, std::abs(std::to_integer<int>(d.low[4 * (size_t{y} * (512u >> level) + x) + c]) -
                                               loud(i * 5 % 7 + i % 2)[c]));
      }
    }
  return worst;
}

// One colour a block: off by a code where 0 meets 255. Aligned to texels alone, blocks hold two and more decals.
TEST(Atlas, NoBlockOfAnyLevelHoldsTwoDecals) {
  EXPECT_LE(worst_of_blocks(4), 1);
  EXPECT_GT(worst_of_blocks(1), 20) << "the check sees what bleeds";
}

TEST(Atlas, LevelsAreMeansOfLinearLight) {
  Rgba8 checks = {32, 32, {}};
  for (uint32_t i = 0; i < 32 * 32; ++i) {
    const auto v = static_cast<uint8_t>((i + i / 32) % 2 ? 255 : 0);
    for (const uint8_t c : {v, v, v, uint8_t{255}}) checks.texels.push_back(c);
  }
  const std::vector<DecalPictures> decals = {{checks, checks, checks}};
  const DecalAtlas atlas = image::make_atlas(decals, 64, 2);
  const auto x = static_cast<uint32_t>((atlas.rectangles[0].u + 0.25f) * 32);
  EXPECT_EQ(texel_of(atlas.textures[0], 1, 0, x, x), (Colour{188, 188, 188, 255}));
  EXPECT_EQ(texel_of(atlas.textures[1], 1, 0, x, x), (Colour{128, 128, 128, 255}));
}

TEST(Atlas, WhatIsNotCoveredColoursNothing) {
  Rgba8 half = {32, 32, {}};
  for (uint32_t i = 0; i < 32 * 32; ++i) {
    const Colour c = i % 2 ? Colour{255, 0, 0, 255} : Colour{0, 255, 0, 0};
    half.texels.insert(half.texels.end(), c.begin(), c.end());
  }
  const std::vector<DecalPictures> decals = {{half, flat(1, 1, {}), flat(1, 1, {})}};
  const DecalAtlas atlas = image::make_atlas(decals, 64, 2);
  const auto x = static_cast<uint32_t>((atlas.rectangles[0].u + 0.25f) * 32);
  EXPECT_EQ(texel_of(atlas.textures[0], 1, 0, x, x), (Colour{255, 0, 0, 128}));
}

// ---- Through the kernel

const Kernel& kernel() { return kernel_named("decal_atlas_sampling"); }

// A decal of the atlas on the wall 8 m ahead or the floor below.
DecalRecord placed(const DecalAtlas& atlas, size_t i, const dvec3& at, const dvec3& outward, double angle,
                   const dvec3& half) {
  DecalRecord d = decal_atlas_sampling::decal(at, outward, angle, half, {}, 0);
  const auto& r = atlas.rectangles[i];
  d.scale_bias = {r.width, r.height, r.u, r.v}, d.page = r.page;
  return d;
}

// An atlas as it is and in blocks, made once for many cases.
struct Pages {
  explicit Pages(DecalAtlas a) : atlas(std::move(a)) {
    Case c;
    decal_atlas_sampling::set_atlas(c, atlas.textures);
    textures = std::move(c.textures);
  }
  DecalAtlas atlas;
  std::map<std::string, std::vector<Texture>> textures;
};
void set_atlas(Case& c, const Pages& pages) {
  c.textures = pages.textures;
  auto p = c.params<decal_atlas_sampling::DecalParams>();
  p.atlas_border = static_cast<float>(pages.atlas.border);
  c.set_params(p);
}

// One decal at a time, from a texel over many pixels to the whole of it within one, level and at a slant.
View loud_view(const Pages& pages, size_t i, double half, bool on_floor) {
  View v({48, 48});
  if (on_floor)
    v.set_plane(0, 25, 48, 48, {0, -1.5, 0}, {0, 1, 0});
  else
    v.set_plane(0, 0, 48, 48, {0, 0, -8}, {0, 0, 1});
  v.decals = {on_floor ? placed(pages.atlas, i, {0.1, -1.5, -6}, {0, 1, 0}, 0.4, {half, half, 1})
                       : placed(pages.atlas, i, {0.3, 0.2, -8}, {0, 0, 1}, 0.4, {half, half, 1})};
  v.last = [&pages](Case& c) { set_atlas(c, pages); };
  return v;
}

// Of the base colour, its three codes; the corners of the cube are exact in every encoding but for a code's rounding,
// and in blocks but for a code of sRGB, whose root is 255 sqrt(1 / 255 / 12.92) codes.
uint64_t expect_own_colour(const Case& c, const std::string& variant, Colour own) {
  const Ran r = run_variant(*device(), kernel(), variant, c);
  const auto got = read<uint32_t>(*device(), r, "base_roughness");
  const auto before = c.input<uint32_t>("base_roughness");
  const int room = 1 + (variant == "block_compressed" ? 5 : 0);
  uint64_t seen = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    if (got[i] == before[i]) continue;
    ++seen;
    for (uint32_t channel = 0; channel < 3; ++channel) {
      const int code = static_cast<int>(got[i] >> 8 * channel & 255u);
      if (std::abs(code - own[channel]) > room) {
        ADD_FAILURE() << variant << ", pixel " << i << ", channel " << channel << ": " << code << " for "
                      << int{own[channel]};
        return seen;
      }
    }
  }
  return seen;
}

// But through an anisotropic sampler, whose footprint nothing holds inside.
TEST(Atlas, NothingBleedsThroughTheKernelAtAnyLevel) {
  const auto decals = loud_decals();
  const Pages pages(image::make_atlas(decals, 512, 5, 4));
  uint64_t seen = 0;
  for (const Variant& variant : kernel().variants) {
    if (variant.anisotropic || !device::missing(device::info(*device()), variant).empty()) continue;
    for (size_t i = 0; i < 7; ++i)
      for (const double half : {0.15, 0.4, 1.0, 3.0, 30.0})
        for (const bool on_floor : {false, true})
          seen +=
              expect_own_colour(loud_view(pages, i, half, on_floor).to_case(), variant.name, loud(i * 5 % 7 + i % 2));
  }
  EXPECT_GT(seen, 50000u);
}

// ---- Real decals

Rgba8 cropped(const Rgba8& p, Extent e) {
  Rgba8 c = {e.width, e.height, {}};
  for (size_t y = 0; y < e.height; ++y) {
    const auto row = std::span(p.texels).subspan(y * p.width * 4, size_t{e.width} * 4);
    c.texels.insert(c.texels.end(), row.begin(), row.end());
  }
  return c;
}

// Normal maps may be some texels larger than their colours: what lies beyond is left out.
DecalPictures load_decal(const std::filesystem::path& folder, int i) {
  const auto read = [&](const char* what) {
    return image::read_png(folder / ("decal_0" + std::to_string(i) + "_" + what + ".png"));
  };
  const Rgba8 albedo = read("albedo"), normal = read("normal");
  const Extent e = {std::min(albedo.width, normal.width), std::min(albedo.height, normal.height)};
  return {cropped(albedo, e), cropped(normal, e), flat(1, 1, {140, 0, 0, 0})};
}

TEST(Atlas, RealDecalsOnAWallAreWhatTheOracleFinds) {
  const char* data = std::getenv("ASSAY_DATA");
  const std::filesystem::path folder = std::filesystem::path(data ? data : "../shared/data") / "decals";
  if (!std::filesystem::exists(folder / "decal_00_albedo.png"))
    GTEST_SKIP() << "no decals in " << folder << "; set ASSAY_DATA to the folder that holds decals/";
  std::vector<DecalPictures> decals;
  decals.reserve(5);
  for (int i = 0; i < 5; ++i) decals.push_back(load_decal(folder, i));
  const Pages pages(image::make_atlas(decals, 1024, 6, 4));
  View v({320, 180});
  v.set_plane(0, 0, 320, 180, {0, 0, -8}, glm::normalize(dvec3(0.5, 0.2, 1)));
  for (size_t i = 0; i < 5; ++i)
    v.decals.push_back(
        placed(pages.atlas, i, {3.0 * static_cast<double>(i) - 6, 0.5, -8}, {0, 0, 1}, 0.2, {2, 2.5, 6}));
  Case c = v.to_case();
  set_atlas(c, pages);
  const check::Prepared prepared = check::prepare(kernel(), c, device::info(*device()).traits);
  for (const Variant& variant : kernel().variants) {
    if (!device::missing(device::info(*device()), variant).empty()) continue;
    device::Ports ports;
    check::Session session{device(), device_options()};
    const check::Outcome o =
        check::attempt(session, {.kernel = &kernel(), .variant = &variant}, prepared, ports, false);
    EXPECT_EQ(check::fault_of(o, variant).text, "") << variant.name;
  }
}

}  // namespace
}  // namespace assay::tests
