#include "harness/image/image.h"

#include <gtest/gtest.h>
#include <png.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "tests/glb.h"

namespace assay::tests {
namespace {

using image::Channel;
using image::Layers;
using image::Rgba8;

struct TemporaryFile {
  std::filesystem::path path;
  explicit TemporaryFile(const std::string& name) : path(temporary(name)) {}
  ~TemporaryFile() { std::filesystem::remove(path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
}

Rgba8 gradient(uint32_t width, uint32_t height) {
  Rgba8 image = {width, height, {}};
  for (uint32_t i = 0; i < width * height * 4; ++i) image.texels.push_back(static_cast<uint8_t>(i * 37 + i / 11));
  return image;
}

template <class F>
std::string complaint(F f) {
  try {
    f();
    return "";
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
    return e.what();
  }
}

// ---- PNG -----------------------------------------------------------------------------------------------------------

TEST(Image, PngRoundTripsAnyTexels) {
  const TemporaryFile file("round.png");
  const bool passed = rc::check("PNG round trip", [&] {
    Rgba8 image = {*rc::gen::inRange(1u, 40u), *rc::gen::inRange(1u, 40u), {}};
    image.texels = *rc::gen::container<std::vector<uint8_t>>(size_t{image.width} * image.height * 4,
                                                             rc::gen::arbitrary<uint8_t>());
    image::write_png(file.path, image);
    const Rgba8 back = image::read_png(file.path);
    RC_ASSERT(back.width == image.width && back.height == image.height && back.texels == image.texels);
  });
  EXPECT_TRUE(passed);
}

// A PNG of any bit depth and colour type, written with libpng itself.
std::vector<uint8_t> encode(uint32_t width, uint32_t height, int depth, int type, const std::vector<uint8_t>& rows,
                            bool interlaced = false) {
  std::vector<uint8_t> out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &out,
      [](png_structp p, png_bytep from, size_t count) {
        auto* to = static_cast<std::vector<uint8_t>*>(png_get_io_ptr(p));
        to->insert(to->end(), from, from + count);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, width, height, depth, type, interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, 0, 0);
  if (type == PNG_COLOR_TYPE_PALETTE) {
    const png_color colours[4] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 8, 7}};
    const png_byte alpha[2] = {255, 64};
    png_set_PLTE(png, info, colours, 4);
    png_set_tRNS(png, info, alpha, 2, nullptr);
  }
  png_write_info(png, info);
  std::vector<uint8_t> bytes = rows;
  std::vector<uint8_t*> pointers;
  for (uint32_t y = 0; y < height; ++y) pointers.push_back(bytes.data() + bytes.size() / height * y);
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

TEST(Image, PngOfEveryKindBecomesRgba8) {
  using T = std::vector<uint8_t>;
  EXPECT_EQ(image::decode_png(encode(2, 1, 8, PNG_COLOR_TYPE_GRAY, {7, 250})).texels,
            (T{7, 7, 7, 255, 250, 250, 250, 255}));
  EXPECT_EQ(image::decode_png(encode(2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {7, 1, 250, 2})).texels,
            (T{7, 7, 7, 1, 250, 250, 250, 2}));
  EXPECT_EQ(image::decode_png(encode(1, 1, 8, PNG_COLOR_TYPE_RGB, {1, 2, 3})).texels, (T{1, 2, 3, 255}));
  EXPECT_EQ(image::decode_png(encode(8, 1, 1, PNG_COLOR_TYPE_GRAY, {0x80})).texels[0], 255);
  EXPECT_EQ(image::decode_png(encode(4, 1, 2, PNG_COLOR_TYPE_PALETTE, {0x1b})).texels,
            (T{255, 0, 0, 255, 0, 255, 0, 64, 0, 0, 255, 255, 9, 8, 7, 255}));
  // 16 bits are rounded to 8, not cut: 0x00ff / 257 = 0.99.
  EXPECT_EQ(image::decode_png(encode(1, 1, 16, PNG_COLOR_TYPE_RGB, {0x12, 0x12, 0x00, 0xff, 0xff, 0xff})).texels,
            (T{0x12, 0x01, 0xff, 255}));
  const Rgba8 wanted = gradient(9, 7);
  EXPECT_EQ(image::decode_png(encode(9, 7, 8, PNG_COLOR_TYPE_RGBA, wanted.texels, true)).texels, wanted.texels);
}

TEST(Image, BrokenPngIsOneLine) {
  const TemporaryFile file("broken.png");
  image::write_png(file.path, gradient(9, 5));
  const std::string whole = read_file(file.path);
  const auto decode = [](const std::string& bytes) {
    return complaint([&] { image::decode_png({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}); });
  };
  EXPECT_EQ(decode(whole), "");
  for (size_t size = 0; size < whole.size(); ++size) EXPECT_NE(decode(whole.substr(0, size)), "") << size;
  for (size_t i = 0; i < whole.size(); ++i)
    for (const int bit : {1, 128}) {
      std::string bytes = whole;
      bytes[i] = static_cast<char>(bytes[i] ^ bit);
      decode(bytes);
    }
  EXPECT_EQ(complaint([] { image::read_png("no/such.png"); }), "no/such.png: cannot be opened");
  EXPECT_NE(complaint([] { image::write_png("no/such/folder.png", gradient(1, 1)); }).find("no/such/folder.png"),
            std::string::npos);
  EXPECT_NE(complaint([] { image::write_png("unwritten.png", {3, 3, {}}); }), "");
}

// ---- OpenEXR -------------------------------------------------------------------------------------------------------

Layers layers_of(uint32_t width, uint32_t height) {
  Layers layers = {width,
                   height,
                   {{"depth", image::Sample::float32, {}, {}},
                    {"radiance.B", image::Sample::half, {}, {}},
                    {"radiance.G", image::Sample::half, {}, {}},
                    {"radiance.R", image::Sample::half, {}, {}},
                    {"visibility.triangle", image::Sample::uint32, {}, {}}}};
  for (uint32_t i = 0; i < width * height; ++i) {
    layers.channels[0].values.push_back(1e-7f * static_cast<float>(i) + 0.1f);
    for (size_t c = 1; c < 4; ++c)
      layers.channels[c].values.push_back(static_cast<float>(c) * 0.25f * static_cast<float>(i % 64));
    layers.channels[4].integers.push_back(0xffffffffu - i);
  }
  return layers;
}

TEST(Image, ExrRoundTripsEverySampleAndDottedNames) {
  const TemporaryFile file("round.exr");
  const Layers layers = layers_of(33, 17);
  image::write_exr(file.path, layers);
  const Layers back = image::read_exr(file.path);
  EXPECT_EQ(back.width, 33u);
  EXPECT_EQ(back.height, 17u);
  ASSERT_EQ(back.channels.size(), layers.channels.size());
  for (size_t c = 0; c < layers.channels.size(); ++c) {  // both sorted by name
    EXPECT_EQ(back.channels[c].name, layers.channels[c].name);
    EXPECT_EQ(back.channels[c].sample, layers.channels[c].sample);
    EXPECT_EQ(back.channels[c].values, layers.channels[c].values);
    EXPECT_EQ(back.channels[c].integers, layers.channels[c].integers);
  }
}

TEST(Image, ExrKeepsEveryFloatBitForBit) {
  const TemporaryFile file("bits.exr");
  const bool passed = rc::check("EXR round trip", [&] {
    const auto bits = *rc::gen::nonEmpty(rc::gen::container<std::vector<uint32_t>>(rc::gen::arbitrary<uint32_t>()));
    Channel floats = {"f", image::Sample::float32, std::vector<float>(bits.size()), {}};
    std::memcpy(floats.values.data(), bits.data(), bits.size() * 4);
    image::write_exr(file.path,
                     {static_cast<uint32_t>(bits.size()), 1, {floats, {"u", image::Sample::uint32, {}, bits}}});
    const Layers back = image::read_exr(file.path);
    RC_ASSERT(std::memcmp(back.channels[0].values.data(), bits.data(), bits.size() * 4) == 0);
    RC_ASSERT(back.channels[1].integers == bits);
  });
  EXPECT_TRUE(passed);
}

TEST(Image, ExrHalvesRoundToNearest) {
  const TemporaryFile file("half.exr");
  const float inputs[] = {1 + 0.4f / 1024, 1 + 0.6f / 1024, 65504, 1e6f, std::numeric_limits<float>::infinity(),
                          5.9604645e-8f};
  Channel c = {"h", image::Sample::half, std::vector<float>(std::begin(inputs), std::end(inputs)), {}};
  image::write_exr(file.path, {6, 1, {c}});
  const std::vector<float> back = image::read_exr(file.path).channels[0].values;
  EXPECT_EQ(back, (std::vector<float>{1, 1 + 1.0f / 1024, 65504, INFINITY, INFINITY, 5.9604645e-8f}));
}

TEST(Image, BrokenExrIsOneLineWithTheFile) {
  const TemporaryFile file("broken.exr");
  image::write_exr(file.path, layers_of(20, 20));
  const std::string whole = read_file(file.path);
  for (size_t size = 0; size < whole.size(); size += size < 600 ? 7 : 61) {
    std::ofstream(file.path, std::ios::binary).write(whole.data(), static_cast<std::streamsize>(size));
    const std::string said = complaint([&] { image::read_exr(file.path); });
    EXPECT_EQ(said.rfind(file.path.string() + ": ", 0), 0u) << size << ": " << said;
  }
  for (const char* broken : {"no/such.exr", "no/such/folder.exr"}) {
    EXPECT_NE(complaint([&] { image::read_exr(broken); }).find(broken), std::string::npos);
    EXPECT_NE(complaint([&] { image::write_exr(broken, layers_of(1, 1)); }).find(broken), std::string::npos);
  }
  EXPECT_NE(complaint([&] { image::write_exr(file.path, {2, 2, {{"short", image::Sample::float32, {1}, {}}}}); }), "");
}

// ---- Legend --------------------------------------------------------------------------------------------------------

std::vector<image::LegendRow> rows_of(size_t count, const std::string& text) {
  std::vector<image::LegendRow> rows;
  for (size_t i = 0; i < count; ++i)
    rows.push_back(
        {static_cast<uint8_t>(40 * i), static_cast<uint8_t>(255 - 9 * i), 77, text + " " + std::to_string(i)});
  return rows;
}

TEST(Image, LegendKeepsThePictureAndShowsEveryColour) {
  for (const uint32_t width : {1u, 17u, 320u, 1280u}) {
    const Rgba8 picture = gradient(width, 40);
    const auto rows = rows_of(23, "a material's name");
    const Rgba8 out = image::with_legend(picture, "material", rows);
    EXPECT_EQ(out.width, width);
    EXPECT_GT(out.height, 40u);
    EXPECT_EQ(out.texels.size(), size_t{out.width} * out.height * 4);
    EXPECT_TRUE(std::equal(picture.texels.begin(), picture.texels.end(), out.texels.begin()));
    for (const image::LegendRow& row : rows) {
      bool shown = width < 20;  // narrower than a swatch's place
      for (size_t i = picture.texels.size(); i < out.texels.size() && !shown; i += 4)
        shown = out.texels[i] == row.r && out.texels[i + 1] == row.g && out.texels[i + 2] == row.b;
      EXPECT_TRUE(shown) << row.text << " at width " << width;
    }
  }
}

TEST(Image, LegendUsesColumnsAndCutsLongText) {
  const Rgba8 wide = image::with_legend(gradient(1280, 4), "t", rows_of(12, "m"));
  const Rgba8 narrow = image::with_legend(gradient(60, 4), "t", rows_of(12, "m"));
  EXPECT_LT(wide.height, narrow.height + 60);  // twice the scale, yet not twelve lines
  const Rgba8 cut = image::with_legend(gradient(60, 4), "", rows_of(1, std::string(500, 'W')));
  EXPECT_EQ(cut.width, 60u);
  const Rgba8 odd = image::with_legend(gradient(200, 4), "no\tASCII \xc3\xa4", rows_of(1, "\xff\x01"));
  EXPECT_GT(odd.height, 4u);
  EXPECT_EQ(image::with_legend(gradient(50, 4), "", {}).width, 50u);
}

}  // namespace
}  // namespace assay::tests
