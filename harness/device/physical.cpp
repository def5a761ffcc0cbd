// Physical devices: what they are, what they can do, and why Assay could not run on one.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "harness/device/internal.h"

namespace assay::device {

namespace {

const char* type_name(VkPhysicalDeviceType t) {
  switch (t) {
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "cpu";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual";
    default:
      return "other";
  }
}

std::string hex(const uint8_t (&bytes)[VK_UUID_SIZE]) {
  std::string s;
  for (const uint8_t b : bytes) s += fmt::format("{:02x}", b);
  return s;
}

void choose_queues(Physical& p) {
  uint32_t n = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(p.handle, &n, nullptr);
  p.families.resize(n);
  vkGetPhysicalDeviceQueueFamilyProperties(p.handle, &n, p.families.data());
  constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  const auto first = std::ranges::find_if(p.families, [](const auto& f) { return (f.queueFlags & both) == both; });
  if (first == p.families.end()) {
    p.info.missing = "no queue for both graphics and compute";
    return;
  }
  p.first.family = static_cast<uint32_t>(first - p.families.begin());
  // A family for compute alone is a queue of its own in hardware; a second queue of one family may share one.
  const auto second =
      std::ranges::find_if(p.families, [](const auto& f) { return (f.queueFlags & both) == VK_QUEUE_COMPUTE_BIT; });
  if (second != p.families.end())
    p.second = QueueChoice{static_cast<uint32_t>(second - p.families.begin()), 0};
  else if (first->queueCount > 1)
    p.second = QueueChoice{p.first.family, 1};
  p.info.second_queue = p.second.has_value();
}

void find_extensions(Physical& p) {
  uint32_t n = 0;
  ASSAY_VK(vkEnumerateDeviceExtensionProperties(p.handle, nullptr, &n, nullptr));
  std::vector<VkExtensionProperties> found(n);
  ASSAY_VK(vkEnumerateDeviceExtensionProperties(p.handle, nullptr, &n, found.data()));
  for (const char* wanted : {VK_EXT_SHADER_IMAGE_ATOMIC_INT64_EXTENSION_NAME,
                             VK_EXT_DEPTH_RANGE_UNRESTRICTED_EXTENSION_NAME})  // poison in depth images is no depth
    if (std::ranges::any_of(found, [&](const auto& e) { return std::strcmp(e.extensionName, wanted) == 0; }))
      p.extensions.push_back(wanted);
}

void set_features(Info& info, const FeatureChain& f, VkSubgroupFeatureFlags subgroup) {
  const auto set = [&](Feature feature, bool has) {
    if (has) info.features.insert(feature);
  };
  set(Feature::subgroup_ballot, subgroup & VK_SUBGROUP_FEATURE_BALLOT_BIT);
  set(Feature::subgroup_arithmetic, subgroup & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT);
  set(Feature::subgroup_shuffle, subgroup & VK_SUBGROUP_FEATURE_SHUFFLE_BIT);
  set(Feature::subgroup_clustered, subgroup & VK_SUBGROUP_FEATURE_CLUSTERED_BIT);
  set(Feature::primitive_id, f.core.features.geometryShader);  // gl_PrimitiveID in a fragment shader asks for Geometry
  set(Feature::clip_distance, f.core.features.shaderClipDistance);
  set(Feature::draw_indirect_count, f.v12.drawIndirectCount);
  set(Feature::texture_compression_bc, f.core.features.textureCompressionBC);
  set(Feature::int64, f.core.features.shaderInt64);
  set(Feature::image_int64_atomics, f.image_atomics.shaderImageInt64Atomics && f.core.features.shaderInt64);
  set(Feature::float16, f.v12.shaderFloat16 && f.v11.storageBuffer16BitAccess);
  set(Feature::descriptor_indexing, f.v12.runtimeDescriptorArray && f.v12.descriptorBindingPartiallyBound &&
                                        f.v12.shaderSampledImageArrayNonUniformIndexing);
}

std::string why_not(const Info& info, const FeatureChain& f, const VkPhysicalDeviceProperties& p,
                    VkSubgroupFeatureFlags subgroup) {
  if (!info.missing.empty()) return info.missing;
  if (p.apiVersion < VK_API_VERSION_1_3) return "Vulkan " + info.api + ", Assay needs 1.3";
  if (!f.v12.scalarBlockLayout) return "no scalar block layout";
  if (!f.v13.synchronization2) return "no synchronization2";
  if (!f.v13.dynamicRendering) return "no dynamic rendering";
  if (!f.v13.maintenance4) return "no maintenance4 (local sizes by constant)";
  if (!f.core.features.drawIndirectFirstInstance) return "no first instance in indirect draws";
  if (!f.core.features.shaderStorageImageExtendedFormats) return "no extended formats of storage images";
  if (!(subgroup & VK_SUBGROUP_FEATURE_BASIC_BIT)) return "no subgroups in compute shaders";
  return {};
}

struct Properties {
  VkPhysicalDeviceProperties2 core = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  VkPhysicalDeviceVulkan11Properties v11 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES};
  VkPhysicalDeviceVulkan12Properties v12 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
  VkPhysicalDeviceVulkan13Properties v13 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES};
};

void describe_identity(Physical& p, const Properties& q) {
  const VkPhysicalDeviceProperties& core = q.core.properties;
  p.info.name = core.deviceName;
  p.info.type = type_name(core.deviceType);
  p.info.uuid = hex(q.v11.deviceUUID);
  p.info.driver = q.v12.driverName;
  p.info.driver_info = q.v12.driverInfo;
  p.info.api = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(core.apiVersion), VK_API_VERSION_MINOR(core.apiVersion),
                           VK_API_VERSION_PATCH(core.apiVersion));
}

void describe_limits(Physical& p, const Properties& q) {
  const VkPhysicalDeviceLimits& l = q.core.properties.limits;
  p.info.traits = {q.v11.subgroupSize, l.subPixelPrecisionBits, l.subTexelPrecisionBits, l.mipmapPrecisionBits};
  p.info.subgroup_min = q.v13.minSubgroupSize;
  p.info.subgroup_max = q.v13.maxSubgroupSize;
  p.info.max_buffer_range = l.maxStorageBufferRange;
  p.info.shared_memory = l.maxComputeSharedMemorySize;
  std::copy_n(l.maxComputeWorkGroupCount, 3, p.info.max_groups);
  if (!p.families.empty() && p.families[p.first.family].timestampValidBits > 0)
    p.info.timestamp_ns = static_cast<double>(l.timestampPeriod);
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(p.handle, &memory);
  for (uint32_t i = 0; i < memory.memoryHeapCount; ++i)
    if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
      p.info.memory_bytes += memory.memoryHeaps[i].size;
}

// Forward progress between workgroups that are all resident, which look-back scans lean on, is promised by no Vulkan
// feature. NVIDIA schedules threads independently since Volta and never starves a resident workgroup; lavapipe ends a
// spinning loop after 65,535 turns. Every other device is taken not to promise it.
bool has_forward_progress(const VkPhysicalDeviceProperties& p) {
  constexpr uint32_t kNvidia = 0x10de;
  return p.vendorID == kNvidia && p.deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU;
}

void describe(Physical& p, uint32_t index) {
  p.info.index = index;
  Properties q;
  q.core.pNext = &q.v11;
  q.v11.pNext = &q.v12;
  q.v12.pNext = &q.v13;
  vkGetPhysicalDeviceProperties(p.handle, &p.properties);
  if (p.properties.apiVersion < VK_API_VERSION_1_3) {  // later structures would be left unfilled
    q.core.properties = p.properties;
    describe_identity(p, q);
    p.info.missing = "Vulkan " + p.info.api + ", Assay needs 1.3";
    return;
  }
  vkGetPhysicalDeviceProperties2(p.handle, &q.core);
  choose_queues(p);
  find_extensions(p);
  describe_identity(p, q);
  describe_limits(p, q);
  const FeatureChain features(p);
  const bool compute = q.v11.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT;
  const VkSubgroupFeatureFlags subgroup = compute ? q.v11.subgroupSupportedOperations : 0;
  set_features(p.info, features, subgroup);
  if (has_forward_progress(p.properties)) p.info.features.insert(Feature::forward_progress);
  p.info.missing = why_not(p.info, features, p.properties, subgroup);
}

}  // namespace

std::vector<Physical> physical_devices(const Instance& instance) {
  if (!instance.handle) return {};
  uint32_t n = 0;
  ASSAY_VK(vkEnumeratePhysicalDevices(instance.handle, &n, nullptr));
  std::vector<VkPhysicalDevice> handles(n);
  if (n > 0) ASSAY_VK(vkEnumeratePhysicalDevices(instance.handle, &n, handles.data()));
  std::vector<Physical> devices(n);
  for (uint32_t i = 0; i < n; ++i) {
    devices[i].handle = handles[i];
    describe(devices[i], i);
  }
  return devices;
}

// Everything that a kernel may use is enabled where it exists. Robust access is not: it would hide stray accesses from
// the guards and cost time that no engine pays.
FeatureChain::FeatureChain(const Physical& p) {
  const bool int64_images = std::ranges::count(p.extensions, VK_EXT_SHADER_IMAGE_ATOMIC_INT64_EXTENSION_NAME) > 0;
  core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  v11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
  v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  image_atomics.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_IMAGE_ATOMIC_INT64_FEATURES_EXT;
  core.pNext = &v11;
  v11.pNext = &v12;
  v12.pNext = &v13;
  v13.pNext = int64_images ? &image_atomics : nullptr;
  vkGetPhysicalDeviceFeatures2(p.handle, &core);
  core.features.robustBufferAccess = VK_FALSE;
  v13.robustImageAccess = VK_FALSE;
  v12.bufferDeviceAddressCaptureReplay = VK_FALSE;
  v12.bufferDeviceAddressMultiDevice = VK_FALSE;
  v11.protectedMemory = VK_FALSE;
}

std::string missing(const Info& info, const Variant& variant) {
  std::string why = info.missing;
  const auto add = [&](const std::string& s) { why += (why.empty() ? "" : ", ") + s; };
  for (const Feature f : variant.needs)
    if (!info.features.contains(f)) add(std::string("needs ") + name_of(f));
  const uint32_t width = info.traits.subgroup_width;
  if (width < variant.subgroup_min || width > variant.subgroup_max)
    add(fmt::format("subgroup width {} outside {}..{}", width, variant.subgroup_min, variant.subgroup_max));
  // Mesa 22.3 crashes in LLVM while it compiles any fragment shader, even a constant one, for 512-bit vectors.
  const bool draws = std::ranges::any_of(variant.passes, [](const Pass& p) { return std::holds_alternative<Draw>(p); });
  if (draws && width > 8 && info.driver == "llvmpipe") add("draws: lavapipe compiles no fragment shader for 16 lanes");
  // And of BC7 in sRGB it fetches wrong colours in every other lane; BC4, BC5 and BC7 as plain numbers are right.
  const bool has_blocks = std::ranges::count(variant.needs, Feature::texture_compression_bc) > 0;
  if (has_blocks && width > 8 && info.driver == "llvmpipe") add("blocks: lavapipe misreads sRGB ones with 16 lanes");
  return why;
}

}  // namespace assay::device
