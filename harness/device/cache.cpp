// What the driver compiled, kept from run to run: one file a driver, in the user's cache folder.
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>

#include "harness/device/cache_file.h"
#include "harness/device/internal.h"

namespace assay::device {

namespace {

std::filesystem::path cache_path(const Physical& p) {
  const char* xdg = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if ((!xdg || !*xdg) && (!home || !*home)) return {};
  const std::filesystem::path folder =
      xdg && *xdg ? std::filesystem::path(xdg) : std::filesystem::path(home) / ".cache";
  std::string key;
  for (const uint8_t b : p.properties.pipelineCacheUUID) key += fmt::format("{:02x}", b);
  return folder / "assay" / (key + ".pipelines");
}

// Drivers must refuse another's cache themselves, but it is better not shown to them.
bool fits(const Bytes& data, const VkPhysicalDeviceProperties& p) {
  VkPipelineCacheHeaderVersionOne header;
  if (data.size() < sizeof header) return false;
  std::memcpy(&header, data.data(), sizeof header);
  return header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && header.vendorID == p.vendorID &&
         header.deviceID == p.deviceID && std::memcmp(header.pipelineCacheUUID, p.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

}  // namespace

void load_pipeline_cache(Device& d) {
  const auto path = cache_path(d.physical);
  Bytes data = path.empty() ? Bytes{} : read_sealed(path);
  if (!fits(data, d.physical.properties)) data.clear();
  d.loaded_cache_bytes = data.size();
  const VkPipelineCacheCreateInfo info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO,
                                          .initialDataSize = data.size(),
                                          .pInitialData = data.data()};
  ASSAY_VK(vkCreatePipelineCache(d.handle, &info, nullptr, &d.pipeline_cache));
}

// Failing to write costs only time in the next run. Some drivers (lavapipe) keep nothing behind the header.
void save_pipeline_cache(Device& d) noexcept {
  try {
    size_t size = 0;
    if (vkGetPipelineCacheData(d.handle, d.pipeline_cache, &size, nullptr) != VK_SUCCESS) return;
    const auto path = cache_path(d.physical);
    if (size <= d.loaded_cache_bytes || path.empty()) return;
    Bytes data(size);
    if (vkGetPipelineCacheData(d.handle, d.pipeline_cache, &size, data.data()) != VK_SUCCESS) return;
    data.resize(size);
    write_sealed(path, data);
  } catch (...) {
  }
}

}  // namespace assay::device
