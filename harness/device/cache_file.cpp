#include "harness/device/cache_file.h"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iterator>

namespace assay::device {

namespace fs = std::filesystem;

namespace {

struct Seal {
  uint64_t bytes, checksum;
};

// FNV-1a (Fowler, Noll, Vo): against accidents, not against malice.
Seal seal_of(std::span<const std::byte> bytes) {
  uint64_t hash = 0xcbf29ce484222325ull;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<uint64_t>(b)) * 0x100000001b3ull;
  return {bytes.size(), hash};
}

}  // namespace

void write_sealed(const fs::path& path, std::span<const std::byte> bytes) {
  fs::create_directories(path.parent_path());
  fs::path beside = path;
  beside += fmt::format(
      ".{}", std::chrono::steady_clock::now().time_since_epoch().count() ^ reinterpret_cast<intptr_t>(bytes.data()));
  const Seal seal = seal_of(bytes);
  std::ofstream file(beside, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&seal), sizeof seal);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  fs::rename(beside, path);
}

Bytes read_sealed(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  Seal seal = {};
  if (!file.read(reinterpret_cast<char*>(&seal), sizeof seal)) return {};
  const std::vector<char> rest{std::istreambuf_iterator<char>(file), {}};
  const std::span<const std::byte> bytes = std::as_bytes(std::span(rest));
  const Seal found = seal_of(bytes);
  if (found.bytes != seal.bytes || found.checksum != seal.checksum) return {};
  return {bytes.begin(), bytes.end()};
}

}  // namespace assay::device
