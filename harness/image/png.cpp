// PNG through libpng. Its errors are longjmps: the functions that can be jumped out of hold nothing to destroy.
#include <png.h>

#include <fmt/format.h>
#include <csetjmp>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "harness/image/image.h"

namespace assay::image {
namespace {

constexpr uint32_t kLargestSide = 1u << 16;
constexpr uint64_t kDeflateRatio = 1032;  // the most that deflate can shrink: a smaller file is truncated or a lie

struct Stream {
  const uint8_t* data = nullptr;  // to read
  size_t left = 0;
  std::vector<uint8_t>* out = nullptr;  // to write
  char message[128] = {};
};

[[noreturn]] void on_error(png_structp png, png_const_charp what) {
  auto* stream = static_cast<Stream*>(png_get_error_ptr(png));
  std::strncpy(stream->message, what, sizeof stream->message - 1);
  std::longjmp(png_jmpbuf(png), 1);
}
void on_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep to, size_t count) {
  auto* stream = static_cast<Stream*>(png_get_io_ptr(png));
  if (count > stream->left) png_error(png, "truncated");
  std::memcpy(to, stream->data, count);
  stream->data += count;
  stream->left -= count;
}

void write_bytes(png_structp png, png_bytep from, size_t count) {
  bool full = false;
  try {
    std::vector<uint8_t>& out = *static_cast<Stream*>(png_get_io_ptr(png))->out;
    out.insert(out.end(), from, from + count);
  } catch (const std::exception&) {
    full = true;  // no exception may cross libpng
  }
  if (full) png_error(png, "out of memory");
}
void flush(png_structp) {}

struct Reader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  explicit Reader(Stream& s) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &s, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
};
struct Writer {
  png_structp png = nullptr;
  png_infop info = nullptr;
  explicit Writer(Stream& s) {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &s, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
};

// Whatever the file holds becomes RGBA8; colour space chunks are not applied (glTF forbids it).
bool read_header(png_structp png, png_infop info, Stream& stream, Rgba8& out) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, &stream, read_bytes);
  png_set_user_limits(png, kLargestSide, kLargestSide);
  png_read_info(png, info);
  out.width = png_get_image_width(png, info);
  out.height = png_get_image_height(png, info);
  if (png_get_rowbytes(png, info) * uint64_t{out.height} / kDeflateRatio > stream.left) png_error(png, "truncated");
  png_set_expand(png);  // palette, grey below 8 bits and transparency chunks
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  return true;
}

bool read_rows(png_structp png, png_infop info, Rgba8& out) {
  if (setjmp(png_jmpbuf(png))) return false;
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != size_t{out.width} * 4) png_error(png, "its pixels are of an unknown kind");
  for (int pass = 0; pass < passes; ++pass)
    for (uint32_t y = 0; y < out.height; ++y) png_read_row(png, out.texels.data() + size_t{y} * out.width * 4, nullptr);
  png_read_end(png, info);
  return true;
}

bool write_all(png_structp png, png_infop info, Stream& stream, const Rgba8& image) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &stream, write_bytes, flush);
  png_set_IHDR(png, info, image.width, image.height, 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  for (uint32_t y = 0; y < image.height; ++y) png_write_row(png, image.texels.data() + size_t{y} * image.width * 4);
  png_write_end(png, info);
  return true;
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}", file.string(), what));
}

}  // namespace

Rgba8 decode_png(std::span<const uint8_t> bytes) {
  Stream stream = {.data = bytes.data(), .left = bytes.size()};
  Reader reader(stream);
  if (!reader.info) throw std::runtime_error("PNG: out of memory");
  Rgba8 out;
  bool ok = read_header(reader.png, reader.info, stream, out);
  if (ok) {
    out.texels.resize(size_t{out.width} * out.height * 4);
    ok = read_rows(reader.png, reader.info, out);
  }
  if (!ok) throw std::runtime_error(fmt::format("PNG: {}", stream.message));
  return out;
}

Rgba8 read_png(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) fail(file, "cannot be opened");
  const std::vector<uint8_t> bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  try {
    return decode_png(bytes);
  } catch (const std::exception& e) {
    fail(file, e.what());
  }
}

void write_png(const std::filesystem::path& file, const Rgba8& image) {
  if (image.width == 0 || image.height == 0 || image.texels.size() != size_t{image.width} * image.height * 4)
    fail(file, fmt::format("an image of {}x{} with {} bytes cannot be written", image.width, image.height,
                           image.texels.size()));
  std::vector<uint8_t> bytes;
  Stream stream = {.out = &bytes};
  Writer writer(stream);
  if (!writer.info) fail(file, "out of memory");
  if (!write_all(writer.png, writer.info, stream, image)) fail(file, stream.message);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) fail(file, "cannot be written");
}

}  // namespace assay::image
