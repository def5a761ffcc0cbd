// The logical device: queues, features, names.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "harness/device/internal.h"

namespace assay::device {

namespace {

void create_queue(Device& d, const QueueChoice& choice) {
  Queue& q = d.queues.emplace_back();
  q.family = choice.family;
  q.flags = d.physical.families[q.family].queueFlags;
  q.timestamp_bits = d.physical.families[q.family].timestampValidBits;
  vkGetDeviceQueue(d.handle, q.family, choice.position, &q.handle);
  const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                        .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                        .queueFamilyIndex = q.family};
  ASSAY_VK(vkCreateCommandPool(d.handle, &pool, nullptr, &q.pool));
  const VkCommandBufferAllocateInfo buffers = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                               .commandPool = q.pool,
                                               .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                               .commandBufferCount = 1};
  ASSAY_VK(vkAllocateCommandBuffers(d.handle, &buffers, &q.commands));
  const VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  ASSAY_VK(vkCreateFence(d.handle, &fence, nullptr, &q.fence));
}

// The anisotropic one lengthens a sample's footprint up to 16 times; 0: none. The other serves every variant that does
// not ask, for what anisotropy does is free, and wrong on lavapipe (works_anisotropically).
VkSampler create_sampler(const Device& d, float anisotropy) {
  const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                    .magFilter = VK_FILTER_LINEAR,
                                    .minFilter = VK_FILTER_LINEAR,
                                    .mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR,
                                    .addressModeU = VK_SAMPLER_ADDRESS_MODE_REPEAT,
                                    .addressModeV = VK_SAMPLER_ADDRESS_MODE_REPEAT,
                                    .addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT,
                                    .anisotropyEnable = anisotropy > 0,
                                    .maxAnisotropy = anisotropy,
                                    .maxLod = VK_LOD_CLAMP_NONE};
  VkSampler sampler = VK_NULL_HANDLE;
  ASSAY_VK(vkCreateSampler(d.handle, &info, nullptr, &sampler));
  return sampler;
}
void create_samplers(Device& d, const VkPhysicalDeviceFeatures& features) {
  d.sampler = create_sampler(d, 0);
  if (features.samplerAnisotropy)
    d.anisotropic_sampler = create_sampler(d, std::min(16.0f, d.physical.properties.limits.maxSamplerAnisotropy));
}

void destroy_queue(Device& d, Queue& q) {
  for (const VkDescriptorPool pool : q.descriptors.pools) vkDestroyDescriptorPool(d.handle, pool, nullptr);
  vkDestroyQueryPool(d.handle, q.queries, nullptr);
  vkDestroyFence(d.handle, q.fence, nullptr);
  vkDestroyCommandPool(d.handle, q.pool, nullptr);
}

VkDevice create_device(const Physical& p) {
  const FeatureChain features(p);
  const float priorities[] = {1, 1};
  std::vector<VkDeviceQueueCreateInfo> queues = {{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                                  .queueFamilyIndex = p.first.family,
                                                  .queueCount = 1,
                                                  .pQueuePriorities = priorities}};
  if (p.second && p.second->family == p.first.family) queues[0].queueCount = 2;
  if (p.second && p.second->family != p.first.family) {
    queues.push_back(queues[0]);
    queues[1].queueFamilyIndex = p.second->family;
  }
  std::vector<const char*> extensions;
  for (const std::string& e : p.extensions) extensions.push_back(e.c_str());
  const VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                   .pNext = &features.core,
                                   .queueCreateInfoCount = static_cast<uint32_t>(queues.size()),
                                   .pQueueCreateInfos = queues.data(),
                                   .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
                                   .ppEnabledExtensionNames = extensions.data()};
  VkDevice device = VK_NULL_HANDLE;
  ASSAY_VK(vkCreateDevice(p.handle, &info, nullptr, &device));
  return device;
}

}  // namespace

Device::Device(std::unique_ptr<Instance> i, Physical p) : instance(std::move(i)), physical(std::move(p)) {
  handle = create_device(physical);
  try {
    create();
  } catch (...) {
    for (Queue& q : queues) destroy_queue(*this, q);
    vkDestroyPipelineCache(handle, pipeline_cache, nullptr);
    vkDestroySampler(handle, sampler, nullptr);
    vkDestroySampler(handle, anisotropic_sampler, nullptr);
    vkDestroyDevice(handle, nullptr);
    throw;
  }
}

void Device::create() {
  const FeatureChain features(physical);
  multi_draw_indirect = features.core.features.multiDrawIndirect;
  draw_indirect_count = features.v12.drawIndirectCount;
  choose_subgroup_size = physical.info.subgroup_min < physical.info.subgroup_max && features.v13.subgroupSizeControl;
  vkGetPhysicalDeviceMemoryProperties(physical.handle, &memory_types);
  unified = physical.info.type == "cpu" || physical.info.type == "integrated";
  create_queue(*this, physical.first);
  if (physical.second) create_queue(*this, *physical.second);
  families = {queues[0].family};
  if (queues.size() > 1 && queues[1].family != families[0]) families.push_back(queues[1].family);
  create_samplers(*this, features.core.features);
  load_pipeline_cache(*this);
}

// Destroying what a queue still uses is undefined, and waiting for it may take forever: device and instance are left as
// they are, still pointed at so that no leak checker mistakes them for forgotten.
static void abandon(std::unique_ptr<Instance> instance) {
  static std::vector<std::unique_ptr<Instance>>& abandoned = *new std::vector<std::unique_ptr<Instance>>;
  abandoned.push_back(std::move(instance));
}

Device::~Device() {
  if (hung) {
    abandon(std::move(instance));
    return;
  }
  vkDeviceWaitIdle(handle);
  save_pipeline_cache(*this);
  for (auto& [key, pipeline] : pipelines) destroy_pipeline(*this, pipeline);
  vkDestroyPipelineCache(handle, pipeline_cache, nullptr);
  vkDestroySampler(handle, sampler, nullptr);
  vkDestroySampler(handle, anisotropic_sampler, nullptr);
  vkDestroyBuffer(handle, staging.handle, nullptr);
  give_memory(*this, staging.memory);
  release_free_memory(*this);
  for (Queue& q : queues) destroy_queue(*this, q);
  vkDestroyDevice(handle, nullptr);
}

void Close::operator()(Device* d) const {
  d->white.reset();  // it holds the device as every resource does
  const std::shared_ptr<Device> last = std::move(d->self);
}

Handle open(const Options& options) {
  auto instance = std::make_unique<Instance>(options.validation);
  std::vector<Physical> physical = physical_devices(*instance);
  std::vector<Info> infos;
  infos.reserve(physical.size());
  for (const Physical& p : physical) infos.push_back(p.info);
  Physical& chosen = physical[choose(infos, options.select)];
  if (!chosen.info.missing.empty())
    throw Error(fmt::format("Assay cannot run on device {} '{}': {}", chosen.info.index, chosen.info.name,
                            chosen.info.missing));
  const auto device = std::make_shared<Device>(std::move(instance), std::move(chosen));
  device->self = device;
  Handle handle(device.get());
  if (handle->anisotropic_sampler && works_anisotropically(*handle))
    handle->physical.info.features.insert(Feature::sampler_anisotropy);
  release_free_memory(*handle);  // what the trial took
  return handle;
}

const Info& info(const Device& d) { return d.physical.info; }
size_t loaded_cache_bytes(const Device& d) { return d.loaded_cache_bytes; }
size_t pipeline_count(const Device& d) { return d.pipelines.size(); }

std::vector<std::string> validation_messages(Device& d) {
  const std::lock_guard lock(d.instance->messages.mutex);
  return std::exchange(d.instance->messages.lines, {});
}

void name_object(const Device& d, VkObjectType type, uint64_t object, const std::string& name) {
  if (!d.instance->debug_utils) return;
  const VkDebugUtilsObjectNameInfoEXT info = {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                              .objectType = type,
                                              .objectHandle = object,
                                              .pObjectName = name.c_str()};
  ASSAY_VK(vkSetDebugUtilsObjectNameEXT(d.handle, &info));
}

}  // namespace assay::device
