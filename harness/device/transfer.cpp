// Moving bytes between host and resources: straight into mapped memory where there is some, else through the staging
// buffer, a piece at a time.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "harness/device/formats.h"
#include "harness/device/internal.h"

namespace assay::device {

namespace {

enum class Way { to_device, to_host };

// Rows of texels or blocks of one layer of one level, as they lie in the payload and in the staging buffer.
struct Piece {
  uint64_t at = 0, bytes = 0, staged_at = 0;
  VkBufferImageCopy copy = {};
};

std::vector<Piece> pieces_of(const Resource& r) {
  const uint32_t side = block_side(r.format);
  std::vector<Piece> pieces;
  uint64_t at = 0;
  for (uint32_t level = 0; level < r.levels; ++level) {
    const uint32_t width = std::max(1u, r.extent.width >> level), height = std::max(1u, r.extent.height >> level);
    const uint64_t row = bytes_of(r.format, width, side);
    // Texels, whole blocks of them; at least 16 rows: sides end at 65,536, texels and blocks at 16 bytes.
    const uint32_t most = static_cast<uint32_t>(kStagingBytes / row) * side;
    for (uint32_t layer = 0; layer < r.layers; ++layer)
      for (uint32_t y = 0; y < height; y += most) {
        const uint32_t rows = std::min(most, height - y);
        Piece p{.at = at, .bytes = bytes_of(r.format, width, rows)};
        p.copy.imageSubresource = {aspect_of(r.format), level, layer, 1};
        p.copy.imageOffset = {0, static_cast<int32_t>(y), 0};
        p.copy.imageExtent = {width, rows, 1};
        pieces.push_back(p);
        at += p.bytes;
      }
  }
  return pieces;
}

void copy_pieces(Device& d, const Resource& r, std::span<const Piece> pieces, Way way) {
  std::vector<VkBufferImageCopy> copies;
  for (const Piece& p : pieces) copies.push_back(p.copy);
  const auto n = static_cast<uint32_t>(copies.size());
  submit_once(d, [&](VkCommandBuffer c) {
    if (way == Way::to_device)
      vkCmdCopyBufferToImage(c, d.staging.handle, r.image, VK_IMAGE_LAYOUT_GENERAL, n, copies.data());
    else
      vkCmdCopyImageToBuffer(c, r.image, VK_IMAGE_LAYOUT_GENERAL, d.staging.handle, n, copies.data());
  });
}

// Copies an image's whole payload; `host` is read or written.
void copy_image(Device& d, const Resource& r, std::byte* host, Way way) {
  std::byte* staged = staging(d).memory.mapped;
  std::vector<Piece> pieces = pieces_of(r);
  for (size_t i = 0; i < pieces.size();) {
    const size_t first = i;
    for (uint64_t end = 0; i < pieces.size() && end + pieces[i].bytes <= kStagingBytes; ++i) {
      pieces[i].copy.bufferOffset = pieces[i].staged_at = end;
      end = (end + pieces[i].bytes + 15) / 16 * 16;  // offsets are whole texels and words
    }
    const std::span<const Piece> batch(pieces.data() + first, i - first);
    if (way == Way::to_device)
      for (const Piece& p : batch) std::memcpy(staged + p.staged_at, host + p.at, p.bytes);
    copy_pieces(d, r, batch, way);
    if (way == Way::to_host)
      for (const Piece& p : batch) std::memcpy(host + p.at, staged + p.staged_at, p.bytes);
  }
}

// Copies bytes [at, at + bytes) of a buffer.
void copy_buffer(Device& d, const Resource& r, uint64_t at, std::byte* host, uint64_t bytes, Way way) {
  if (bytes == 0) return;
  if (r.memory.mapped) {
    if (way == Way::to_device)
      std::memcpy(r.memory.mapped + at, host, bytes);
    else
      std::memcpy(host, r.memory.mapped + at, bytes);
    return;
  }
  std::byte* staged = staging(d).memory.mapped;
  for (uint64_t done = 0; done < bytes;) {
    const uint64_t n = std::min(bytes - done, kStagingBytes);
    if (way == Way::to_device) std::memcpy(staged, host + done, n);
    submit_once(d, [&](VkCommandBuffer c) {
      const VkBufferCopy to_device = {0, at + done, n}, to_host = {at + done, 0, n};
      if (way == Way::to_device)
        vkCmdCopyBuffer(c, d.staging.handle, r.buffer, 1, &to_device);
      else
        vkCmdCopyBuffer(c, r.buffer, d.staging.handle, 1, &to_host);
    });
    if (way == Way::to_host) std::memcpy(host + done, staged, n);
    done += n;
  }
}

Bytes words(uint32_t word, uint64_t bytes) {
  Bytes b(bytes);
  for (uint64_t i = 0; i < bytes; i += 4) std::memcpy(b.data() + i, &word, std::min<uint64_t>(4, bytes - i));
  return b;
}

}  // namespace

void write(Device& d, Resource& r, std::span<const std::byte> bytes) {
  if (bytes.size() != r.payload || !r.textures.empty())
    throw std::logic_error(fmt::format("{} holds {} bytes, {} written", r.name, r.payload, bytes.size()));
  auto* host = const_cast<std::byte*>(bytes.data());  // only read, on the way to the device
  if (r.kind == PortKind::buffer) return copy_buffer(d, r, 0, host, bytes.size(), Way::to_device);
  copy_image(d, r, host, Way::to_device);
}

void fill(Device& d, Resource& r, uint32_t word) {
  if (!r.textures.empty()) throw std::logic_error(r.name + ": textures are not filled");
  if (r.kind != PortKind::buffer) return write(d, r, words(word, r.payload));
  const uint64_t bytes = bound_bytes(r);
  if (!r.memory.mapped) return submit_once(d, [&](VkCommandBuffer c) { vkCmdFillBuffer(c, r.buffer, 0, bytes, word); });
  auto* at = reinterpret_cast<uint32_t*>(r.memory.mapped);
  std::fill_n(at, bytes / 4, word);
}

Bytes read(Device& d, const Resource& r) {
  Bytes bytes(r.payload);
  uint64_t at = 0;
  for (const Owned& t : r.textures) {
    if (t == d.white) continue;
    copy_image(d, *t, bytes.data() + at, Way::to_host);
    at += t->payload;
  }
  if (!r.textures.empty()) return bytes;
  if (r.kind == PortKind::buffer)
    copy_buffer(d, r, 0, bytes.data(), r.payload, Way::to_host);
  else if (r.image)
    copy_image(d, r, bytes.data(), Way::to_host);
  return bytes;
}

Bytes read_guard(Device& d, const Resource& r) {
  if (r.kind != PortKind::buffer) return {};
  Bytes bytes(bound_bytes(r) - r.payload);
  copy_buffer(d, r, r.payload, bytes.data(), bytes.size(), Way::to_host);
  return bytes;
}

}  // namespace assay::device
