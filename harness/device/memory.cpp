// Device memory, kept by size class so that ten thousand trials do not allocate ten thousand times.
#include <algorithm>
#include <bit>

#include "harness/device/internal.h"

namespace assay::device {

namespace {

constexpr uint64_t kKeptBytes = 512u << 20;  // beyond this, memory given back is freed

// Four classes an octave: at most a quarter more than asked for.
uint64_t size_class(uint64_t bytes) {
  const uint64_t n = std::max<uint64_t>(bytes, 8192) - 1;
  const auto shift = static_cast<unsigned>(std::bit_width(n)) - 3;
  return ((n >> shift) + 1) << shift;
}

// The type that has all of `required`, then most of `preferred` and least of `avoided`.
uint32_t memory_type(const Device& d, uint32_t allowed, VkMemoryPropertyFlags required, VkMemoryPropertyFlags preferred,
                     VkMemoryPropertyFlags avoided) {
  int best = -1, best_score = 0;
  for (uint32_t i = 0; i < d.memory_types.memoryTypeCount; ++i) {
    const VkMemoryPropertyFlags flags = d.memory_types.memoryTypes[i].propertyFlags;
    if (!(allowed >> i & 1) || (flags & required) != required) continue;
    const int score = 64 + 2 * std::popcount(flags & preferred) - std::popcount(flags & avoided);
    if (score > best_score) best = static_cast<int>(i), best_score = score;
  }
  if (best < 0) throw Error("no memory type of this device fits the resource");
  return static_cast<uint32_t>(best);
}

VkResult allocate(Device& d, Memory& m) {
  const VkMemoryAllocateInfo info = {
      .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = m.size, .memoryTypeIndex = m.type};
  return ASSAY_ATTEMPT(vkAllocateMemory(d.handle, &info, nullptr, &m.handle));
}

void free_now(Device& d, Memory& m) noexcept {
  if (m.handle && !d.hung) vkFreeMemory(d.handle, m.handle, nullptr);  // also unmaps
  m = {};
}

}  // namespace

Memory take_memory(Device& d, const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                   VkMemoryPropertyFlags preferred, VkMemoryPropertyFlags avoided) {
  Memory m;
  m.size = size_class(needs.size);
  m.type = memory_type(d, needs.memoryTypeBits, required, preferred, avoided);
  if (const auto it = d.free_memory.find({m.type, m.size}); it != d.free_memory.end()) {
    m = it->second;
    d.free_memory.erase(it);
    d.free_bytes -= m.size;
    return m;
  }
  VkResult result = allocate(d, m);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY && !d.free_memory.empty()) {  // what is kept may be what is short
    release_free_memory(d);
    result = allocate(d, m);
  }
  require_success(result, "vkAllocateMemory(d.handle, &info, nullptr, &m.handle)", __FILE__, __LINE__);
  if (d.memory_types.memoryTypes[m.type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) {
    void* at = nullptr;
    const VkResult mapped = ASSAY_ATTEMPT(vkMapMemory(d.handle, m.handle, 0, VK_WHOLE_SIZE, 0, &at));
    if (mapped != VK_SUCCESS) free_now(d, m);
    require_success(mapped, "vkMapMemory(d.handle, m.handle, 0, VK_WHOLE_SIZE, 0, &at)", __FILE__, __LINE__);
    m.mapped = static_cast<std::byte*>(at);
  }
  return m;
}

void give_memory(Device& d, Memory& m) noexcept {
  if (!m.handle) return;
  if (d.free_bytes + m.size > kKeptBytes) return free_now(d, m);
  try {
    d.free_memory.emplace(std::pair(m.type, m.size), m);
    d.free_bytes += m.size;
    m = {};
  } catch (...) {
    free_now(d, m);
  }
}

void release_free_memory(Device& d) noexcept {
  for (auto& [key, m] : d.free_memory) free_now(d, m);
  d.free_memory.clear();
  d.free_bytes = 0;
}

const Buffer& staging(Device& d) {
  if (d.staging.memory.handle) return d.staging;
  if (!d.staging.handle) {
    const VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                     .size = kStagingBytes,
                                     .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    ASSAY_VK(vkCreateBuffer(d.handle, &info, nullptr, &d.staging.handle));
    set_name(d, VK_OBJECT_TYPE_BUFFER, d.staging.handle, "staging");
  }
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(d.handle, d.staging.handle, &needs);
  Memory m = take_memory(d, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                         VK_MEMORY_PROPERTY_HOST_CACHED_BIT, d.unified ? 0 : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  const VkResult bound = ASSAY_ATTEMPT(vkBindBufferMemory(d.handle, d.staging.handle, m.handle, 0));
  if (bound != VK_SUCCESS) give_memory(d, m);
  require_success(bound, "vkBindBufferMemory(d.handle, d.staging.handle, m.handle, 0)", __FILE__, __LINE__);
  d.staging.memory = m;
  return d.staging;
}

}  // namespace assay::device
