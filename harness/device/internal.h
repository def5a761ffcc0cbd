// What the files of harness/device share: the device's own state, its resources, and small helpers. A device is used by
// one thread at a time.
#pragma once
#include <volk.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "harness/device/call.h"
#include "harness/device/device.h"
#include "harness/device/reflect.h"

namespace assay::device {

// ---- Instance and physical devices
// -------------------------------------------------------------------------------------

struct Messages {  // of the validation layer, which may speak from any thread
  std::mutex mutex;
  std::vector<std::string> lines;
};

class Instance {
 public:
  explicit Instance(Validation);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance handle = VK_NULL_HANDLE;  // null where no driver is installed
  bool debug_utils = false;
  Messages messages;

 private:
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

struct QueueChoice {
  uint32_t family = 0, position = 0;
};
// What a physical device can do, as Info tells it and as open() enables it.
struct Physical {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  Info info;
  QueueChoice first = {};
  std::optional<QueueChoice> second = {};
  VkPhysicalDeviceProperties properties = {};
  std::vector<VkQueueFamilyProperties> families = {};
  std::vector<std::string> extensions = {};  // optional ones that open() enables
};
std::vector<Physical> physical_devices(const Instance&);

// The features that a device has of those that Assay uses, ready for VkDeviceCreateInfo. Chained to itself: not
// movable.
struct FeatureChain {
  explicit FeatureChain(const Physical&);
  FeatureChain(const FeatureChain&) = delete;
  FeatureChain& operator=(const FeatureChain&) = delete;
  VkPhysicalDeviceFeatures2 core = {};
  VkPhysicalDeviceVulkan11Features v11 = {};
  VkPhysicalDeviceVulkan12Features v12 = {};
  VkPhysicalDeviceVulkan13Features v13 = {};
  VkPhysicalDeviceShaderImageAtomicInt64FeaturesEXT image_atomics = {};
};

// ---- The device
// --------------------------------------------------------------------------------------------------------

struct Memory {
  VkDeviceMemory handle = VK_NULL_HANDLE;
  uint64_t size = 0;
  uint32_t type = 0;
  std::byte* mapped = nullptr;  // null where the host cannot see it
};

struct DescriptorPools {  // grow as needed, all reset before each submission
  std::vector<VkDescriptorPool> pools;
  size_t in_use = 0;
};

struct Queue {
  VkQueue handle = VK_NULL_HANDLE;
  uint32_t family = 0, timestamp_bits = 0;
  VkQueueFlags flags = 0;
  VkCommandPool pool = VK_NULL_HANDLE;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  VkFence fence = VK_NULL_HANDLE;
  VkQueryPool queries = VK_NULL_HANDLE;
  uint32_t query_capacity = 0;
  DescriptorPools descriptors = {};
  uint32_t first_runs = 0;  // pipelines of this submission that a CPU's driver has yet to compile: it does at first use
};

struct Buffer {
  VkBuffer handle = VK_NULL_HANDLE;
  Memory memory = {};
};

struct Pipeline {
  VkPipeline handle = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  std::vector<VkDescriptorSetLayout> sets = {};  // one a stage
  std::vector<const Reflection*> stages = {};    // what each set binds
  mutable bool has_run = false;
};

class Device : public std::enable_shared_from_this<Device> {
 public:
  Device(std::unique_ptr<Instance>, Physical);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  std::unique_ptr<Instance> instance;
  Physical physical;
  VkDevice handle = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_types = {};
  bool unified = false;  // buffers live in memory that the host maps
  bool multi_draw_indirect = false, draw_indirect_count = false, choose_subgroup_size = false;
  std::vector<Queue> queues;
  std::vector<uint32_t> families;  // distinct ones of the queues

  std::multimap<std::pair<uint32_t, uint64_t>, Memory> free_memory;  // by type and size
  uint64_t free_bytes = 0;
  Buffer staging = {};
  std::vector<VkImage> new_images = {};                // still to be brought into their layout, by the next submission
  std::map<VkImage, VkImageAspectFlags> aspects = {};  // of those
  VkSampler sampler = VK_NULL_HANDLE, anisotropic_sampler = VK_NULL_HANDLE;  // the second null where there is none
  Owned white = {};                                                          // what unused texture slots show

  VkPipelineCache pipeline_cache = VK_NULL_HANDLE;
  size_t loaded_cache_bytes = 0;
  std::unordered_map<std::string, Pipeline> pipelines;

  bool lost = false;             // a submission failed: nothing more is submitted
  bool hung = false;             // a fence was not signalled in time: work may still run, so nothing is ever destroyed
  std::shared_ptr<Device> self;  // what the Handle holds; resources hold the device too, and may outlive the Handle

 private:
  void create();
};

void name_object(const Device&, VkObjectType, uint64_t object, const std::string& name);
template <class T>
void set_name(const Device& d, VkObjectType type, T object, const std::string& name) {
  name_object(d, type, reinterpret_cast<uint64_t>(object), name);
}
void load_pipeline_cache(Device&);
void save_pipeline_cache(Device&) noexcept;

// ---- Memory
// ------------------------------------------------------------------------------------------------------------

Memory take_memory(Device&, const VkMemoryRequirements&, VkMemoryPropertyFlags required,
                   VkMemoryPropertyFlags preferred, VkMemoryPropertyFlags avoided);
void give_memory(Device&, Memory&) noexcept;
void release_free_memory(Device&) noexcept;
constexpr uint64_t kStagingBytes = 32u << 20;
const Buffer& staging(Device&);

// ---- Resources
// ---------------------------------------------------------------------------------------------------------

class Resource {
 public:
  Resource(std::shared_ptr<Device>, std::string name, PortKind);
  ~Resource();
  Resource(const Resource&) = delete;
  Resource& operator=(const Resource&) = delete;

  std::shared_ptr<Device> device;
  std::string name;
  PortKind kind;
  uint64_t payload = 0;
  // A buffer.
  VkBuffer buffer = VK_NULL_HANDLE;
  Memory memory = {};
  // An image, or one texture of an array.
  VkImage image = VK_NULL_HANDLE;
  Format format = Format::r32_uint;
  std::optional<Format> second = {};
  Extent extent = {};
  uint32_t layers = 1, levels = 1;
  std::map<Format, VkImageView> views = {};
  // An array of textures.
  std::vector<Owned> textures = {};
};

uint64_t bound_bytes(const Resource&);         // of a buffer: the payload and the guard
VkImageView view_of(const Resource&, Format);  // throws std::logic_error where it has no such view
Owned make_texture(Device&, const std::string& name, const Texture&);

// ---- Submission
// --------------------------------------------------------------------------------------------------------

class Recorder {
 public:
  Recorder(Device& d, Queue& q) : device(d), queue(q), commands(q.commands) {}
  VkDescriptorSet descriptor_set(VkDescriptorSetLayout);  // valid until the next submission to this queue
  void bind(VkPipelineBindPoint, const Pipeline&);
  Device& device;
  Queue& queue;
  VkCommandBuffer commands;
};

void begin(Device&, Queue&);            // the queue's command buffer, empty, new images transitioned
void submit_and_wait(Device&, Queue&);  // ends it; waits as long as device.h says
void full_barrier(VkCommandBuffer, bool to_host = false);
void submit_once(Device&, const std::function<void(VkCommandBuffer)>& record);

// ---- What is tried rather than believed
// ------------------------------------------------------------------------------------------

bool works_anisotropically(Device&);  // its anisotropic sampler reads the level of the footprint's width

// ---- Pipelines
// -----------------------------------------------------------------------------------------------------------

using ConstantValues = std::map<std::string, uint32_t>;
void destroy_pipeline(Device&, const Pipeline&) noexcept;  // or what there is of it
const Pipeline& compute_pipeline(Device&, const Shader&, const ConstantValues&);
struct DrawState {
  std::vector<std::pair<Format, Blend>> colours;
  std::optional<DepthTarget> depth;  // only how it compares and writes
  Format depth_format = Format::d32_float;
  Cull cull = Cull::none;
};
const Pipeline& draw_pipeline(Device&, const Shader& vertex, const Shader& fragment, const ConstantValues&,
                              const DrawState&);

// ---- Lowering
// ------------------------------------------------------------------------------------------------------------

// A shader stage's descriptors, written when the command is encoded.
struct BoundSet {
  struct Slot {
    uint32_t binding = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    size_t first = 0, count = 1;  // in `buffers` or `images`
  };
  std::vector<Slot> slots;
  std::vector<VkDescriptorBufferInfo> buffers;
  std::vector<VkDescriptorImageInfo> images;
  std::vector<Owned> keep;  // so that the resources outlive the command
};
void bind_set(Recorder&, VkPipelineBindPoint, const Pipeline&, uint32_t set, const BoundSet&);
VkDescriptorType descriptor_type(BindingKind);

struct Lowering {  // what lowering a pass needs to know
  Device& device;
  const Plan& plan;
  const Case& input;
  const Ports& ports;
  ConstantValues constants;
  std::string label;  // "kernel.variant[...]"
};
const Owned& resource_of(const Lowering&, const std::string& port);
BoundSet bound_set(const Lowering&, const Shader&, const Reflection&, uint32_t scope, std::vector<Use>& uses);
const Shader& shader_of(const Lowering&, const std::string& file);
Format format_of(const Lowering&, const std::string& port);  // the one that shaders and targets see
void use_buffer(std::vector<Use>&, const std::string& port, const Resource&, uint64_t offset, uint64_t bytes,
                uint32_t scope);
std::optional<Command> lower_draw(const Lowering&, const Draw&);

}  // namespace assay::device
