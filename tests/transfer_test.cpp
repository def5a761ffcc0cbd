// Bytes to the device and back: buffers, images of every format, textures; and inputs that do not fit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "harness/oracle.h"
#include "tests/lowered.h"
#include "tests/planted/device_copy/layout.h"

namespace assay::tests {
namespace {

constexpr Format kAllFormats[] = {
    Format::r8_unorm,     Format::r8_uint,      Format::rg8_unorm,   Format::rgba8_unorm,  Format::rgba8_srgb,
    Format::rgba8_uint,   Format::r16_unorm,    Format::r16_float,   Format::rg16_snorm,   Format::rg16_unorm,
    Format::rg16_float,   Format::rgba16_float, Format::rgba16_uint, Format::r32_uint,     Format::r32_float,
    Format::rg32_uint,    Format::rg32_float,   Format::rgba32_uint, Format::rgba32_float, Format::r11g11b10_float,
    Format::rgb9e5_float, Format::d32_float};

Bytes random_bytes(uint64_t n, uint64_t seed) {
  Pcg32 rng(seed);
  Bytes b(n);
  for (std::byte& x : b) x = static_cast<std::byte>(rng.next());
  return b;
}

TEST(Transfer, BuffersComeBackAsTheyWere) {
  for (const uint64_t bytes : {0u, 4u, 60u, 4096u, 4100u, 1u << 20}) {
    const auto buffer = device::make_buffer(*device(), "buffer", bytes);
    device::fill(*device(), *buffer, kPoison);
    for (const uint32_t w : values<uint32_t>(device::read(*device(), *buffer))) ASSERT_EQ(w, kPoison);
    const Bytes written = random_bytes(bytes, bytes);
    device::write(*device(), *buffer, written);
    EXPECT_EQ(device::read(*device(), *buffer), written);
    const auto guard = values<uint32_t>(device::read_guard(*device(), *buffer));
    EXPECT_EQ(guard, std::vector<uint32_t>(device::kGuardBytes / 4, kPoison)) << "write() leaves the guard alone";
  }
}

TEST(Transfer, ImagesOfEveryFormatComeBackAsTheyWere) {
  for (const Format f : kAllFormats)
    for (const Extent e : {Extent{1, 1}, Extent{7, 5}, Extent{64, 33}}) {
      const auto image = device::make_image(*device(), name_of(f), f, {}, e);
      Bytes written = random_bytes(pixel_count(e) * bytes_per_block(f), 1);
      if (f == Format::d32_float)  // depths lie in 0..1
        for (uint64_t i = 0; i < pixel_count(e); ++i) {
          const float depth = static_cast<float>(i) / static_cast<float>(pixel_count(e));
          std::memcpy(written.data() + 4 * i, &depth, 4);
        }
      device::write(*device(), *image, written);
      EXPECT_EQ(device::read(*device(), *image), written) << name_of(f) << " " << e.width << "x" << e.height;
      EXPECT_TRUE(device::read_guard(*device(), *image).empty());
    }
}

TEST(Transfer, ImagesAreFilledWordByWord) {
  const auto wide = device::make_image(*device(), "wide", Format::rg32_uint, {}, {3, 2});
  device::fill(*device(), *wide, kPoison);
  for (const uint32_t w : values<uint32_t>(device::read(*device(), *wide))) EXPECT_EQ(w, kPoison);
  const auto narrow = device::make_image(*device(), "narrow", Format::r8_uint, {}, {5, 1});
  device::fill(*device(), *narrow, 0x04030201);
  EXPECT_EQ(values<uint8_t>(device::read(*device(), *narrow)), (std::vector<uint8_t>{1, 2, 3, 4, 1}));
}

// Larger than the staging buffer: copied in pieces.
TEST(Transfer, LargeImagesAreCopiedInPieces) {
  const Extent e = {2049, 1500};
  const auto image = device::make_image(*device(), "large", Format::rgba32_uint, {}, e);
  const Bytes written = random_bytes(pixel_count(e) * 16, 7);
  device::write(*device(), *image, written);
  EXPECT_TRUE(device::read(*device(), *image) == written);
}

TEST(Transfer, TexturesKeepLevelsAndLayers) {
  Texture t = {.format = Format::rgba8_srgb, .width = 5, .height = 3, .layers = 3, .levels = 3};
  t.bytes = random_bytes(uint64_t{4} * 3 * (5 * 3 + 2 * 1 + 1 * 1), 3);
  const Texture one = {.format = Format::rg8_unorm, .width = 1, .height = 1, .bytes = random_bytes(2, 4)};
  const Texture all[] = {t, one};
  const auto textures = device::make_textures(*device(), "textures", all, 16);
  Bytes expected = t.bytes;
  expected.insert(expected.end(), one.bytes.begin(), one.bytes.end());
  EXPECT_EQ(device::read(*device(), *textures), expected);
  EXPECT_EQ(device::payload_bytes(*textures), expected.size());
  EXPECT_THROW(device::make_textures(*device(), "textures", all, 1), device::Error);
  t.bytes.pop_back();
  EXPECT_THROW(device::make_textures(*device(), "short", std::span(&t, 1), 16), std::logic_error);
}

TEST(Transfer, SizesThatDoNotFitAreRefused) {
  const auto buffer = device::make_buffer(*device(), "buffer", 64);
  EXPECT_THROW(device::write(*device(), *buffer, Bytes(60)), std::logic_error);
  EXPECT_THROW(device::make_image(*device(), "none", Format::r32_uint, {}, {0, 4}), device::Error);
  EXPECT_THROW(device::make_image(*device(), "pair", Format::r32_uint, Format::rg32_uint, {4, 4}), std::logic_error);
  EXPECT_THROW(device::make_buffer(*device(), "huge", uint64_t{1} << 40), device::Error);
}

using device_copy::CopyParams;
using device_copy::Pair;

Case copy_case() {
  Case c = {.name = "inputs"};
  c.set_params(CopyParams{2, 10});
  c.set_input("pairs", std::vector<Pair>(2));
  c.set_input("arguments", std::vector<DispatchArgs>(3));
  return c;
}
std::string refusal(const Case& c) {
  try {
    device::make_ports(*device(), planted("device_copy"), c);
  } catch (const std::logic_error& e) {
    return e.what();
  }
  return "";
}

TEST(Transfer, InputsAreCheckedByKernelCaseAndPort) {
  EXPECT_EQ(refusal(copy_case()), "");
  Case c = copy_case();
  c.inputs.erase("pairs");
  EXPECT_EQ(refusal(c), "device_copy: case 'inputs': port pairs: it is read, and the case has no input for it");
  c = copy_case();
  c.set_input("pairs", std::vector<Pair>(3));
  EXPECT_EQ(refusal(c), fmt::format("device_copy: case 'inputs': port pairs: {} bytes given for {}", 3 * sizeof(Pair),
                                    2 * sizeof(Pair)));
  c = copy_case();
  c.set_input("paris", std::vector<Pair>(2));
  EXPECT_NE(refusal(c).find("port paris"), std::string::npos);
  c = copy_case();
  c.parameters.pop_back();
  c.set_input("pairs", std::vector<Pair>(2));
  c.parameters = Bytes(12);
  EXPECT_NE(refusal(c), "") << "parameters of another size";
}

// Ten thousand trials, several variants each: nothing may cost a fresh allocation.
TEST(Transfer, ManySmallResourcesAreCheap) {
  const auto start = std::chrono::steady_clock::now();
  constexpr int kTimes = 2000;
  for (int i = 0; i < kTimes; ++i) {
    const auto buffer = device::make_buffer(*device(), "small", 4096 + 64 * static_cast<uint64_t>(i % 64));
    device::fill(*device(), *buffer, 1);
    ASSERT_EQ(device::read(*device(), *buffer).size(), device::payload_bytes(*buffer));
  }
  const double us =
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() / kTimes;
  RecordProperty("microseconds", std::to_string(us));
  EXPECT_LT(us, 1000) << "made, filled, read and dropped";
}

}  // namespace
}  // namespace assay::tests
