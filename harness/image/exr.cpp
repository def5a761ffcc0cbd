// One-part OpenEXR files of any channels.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "harness/image/image.h"

namespace assay::image {
namespace {

constexpr uint64_t kMostPixels = 1u << 28;

Imf::PixelType pixel_type(Sample s) {
  if (s == Sample::uint32) return Imf::UINT;
  return s == Sample::half ? Imf::HALF : Imf::FLOAT;
}

// The library's messages may run over lines.
[[noreturn]] void fail(const std::filesystem::path& file, std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  throw std::runtime_error(fmt::format("{}: {}", file.string(), what));
}

void check(const Layers& layers) {
  const size_t count = size_t{layers.width} * layers.height;
  if (count == 0) throw std::runtime_error("an image without pixels cannot be written");
  for (const Channel& c : layers.channels) {
    const size_t have = c.sample == Sample::uint32 ? c.integers.size() : c.values.size();
    if (have != count) throw std::runtime_error(fmt::format("channel {} has {} of {} pixels", c.name, have, count));
  }
}

// A slice over a plane of 32-bit or 16-bit values, one row after the other.
template <class T>
Imf::Slice plane(Imf::PixelType type, std::vector<T>& values, uint32_t width) {
  return Imf::Slice(type, reinterpret_cast<char*>(values.data()), sizeof(T), sizeof(T) * width);
}

void write(const std::filesystem::path& file, const Layers& layers) {
  Imf::Header header(static_cast<int>(layers.width), static_cast<int>(layers.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  std::vector<Channel> channels = layers.channels;  // slices want mutable memory
  std::vector<std::vector<half>> halves(channels.size());
  for (size_t i = 0; i < channels.size(); ++i) {
    Channel& c = channels[i];
    const Imf::PixelType type = pixel_type(c.sample);
    header.channels().insert(c.name, Imf::Channel(type));
    if (c.sample == Sample::uint32) {
      frame.insert(c.name, plane(type, c.integers, layers.width));
    } else if (c.sample == Sample::half) {
      halves[i].assign(c.values.begin(), c.values.end());  // rounds to nearest even
      frame.insert(c.name, plane(type, halves[i], layers.width));
    } else {
      frame.insert(c.name, plane(type, c.values, layers.width));
    }
  }
  Imf::OutputFile out(file.string().c_str(), header);
  out.setFrameBuffer(frame);
  out.writePixels(static_cast<int>(layers.height));
}

Layers read(const std::filesystem::path& file) {
  Imf::InputFile in(file.string().c_str());
  const Imath::Box2i window = in.header().dataWindow();
  const int64_t width = int64_t{window.max.x} - window.min.x + 1, height = int64_t{window.max.y} - window.min.y + 1;
  if (width <= 0 || height <= 0 || static_cast<uint64_t>(width) * static_cast<uint64_t>(height) > kMostPixels)
    throw std::runtime_error(fmt::format("an image of {}x{} pixels is not read", width, height));
  Layers layers = {static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
  const Imf::ChannelList& list = in.header().channels();
  for (auto it = list.begin(); it != list.end(); ++it) {
    if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
      throw std::runtime_error(fmt::format("channel {} is subsampled, which is not read", it.name()));
    const Imf::PixelType type = it.channel().type;
    layers.channels.push_back({it.name(),
                               type == Imf::UINT   ? Sample::uint32
                               : type == Imf::HALF ? Sample::half
                                                   : Sample::float32,
                               {},
                               {}});
  }
  Imf::FrameBuffer frame;
  const size_t count = size_t{layers.width} * layers.height;
  // Halves are widened by the library. A slice's base is where pixel (0, 0) would lie.
  for (Channel& c : layers.channels) {
    char* base = nullptr;
    if (c.sample == Sample::uint32)
      c.integers.resize(count), base = reinterpret_cast<char*>(c.integers.data());
    else
      c.values.resize(count), base = reinterpret_cast<char*>(c.values.data());
    base -= (int64_t{window.min.x} + int64_t{window.min.y} * width) * 4;
    frame.insert(c.name,
                 Imf::Slice(c.sample == Sample::uint32 ? Imf::UINT : Imf::FLOAT, base, 4, size_t{4} * layers.width));
  }
  in.setFrameBuffer(frame);
  in.readPixels(window.min.y, window.max.y);
  return layers;
}

}  // namespace

void write_exr(const std::filesystem::path& file, const Layers& layers) {
  try {
    check(layers);
    write(file, layers);
  } catch (const std::exception& e) {
    fail(file, e.what());
  }
}

Layers read_exr(const std::filesystem::path& file) {
  try {
    return read(file);
  } catch (const std::exception& e) {
    fail(file, e.what());
  }
}

}  // namespace assay::image
