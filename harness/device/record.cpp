// Recording, submitting and waiting.
#include <fmt/format.h>

#include <ctime>

#include "harness/device/internal.h"

namespace assay::device {

namespace {

uint64_t fence_wait_ns = 60'000'000'000;

struct StageAccess {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 reads = 0, writes = 0;
};

StageAccess stages_of(uint32_t scopes, VkQueueFlags queue) {
  if (scopes == kAll)
    return {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT,
            VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_HOST_READ_BIT,
            VK_ACCESS_2_MEMORY_WRITE_BIT | VK_ACCESS_2_HOST_WRITE_BIT};
  const bool graphics = queue & VK_QUEUE_GRAPHICS_BIT;
  StageAccess s;
  const auto add = [&](uint32_t scope, VkPipelineStageFlags2 stages, VkAccessFlags2 reads, VkAccessFlags2 writes) {
    if (!(scopes & scope)) return;
    s.stages |= stages;
    s.reads |= reads;
    s.writes |= writes;
  };
  constexpr VkAccessFlags2 shader_reads = VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT;
  add(kCompute, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, shader_reads, VK_ACCESS_2_SHADER_WRITE_BIT);
  add(kIndirect, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, 0);
  add(kTransfer, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
  add(kHost, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT, VK_ACCESS_2_HOST_WRITE_BIT);
  if (!graphics) return s;
  add(kGraphics,
      VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
          VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT,
      shader_reads | VK_ACCESS_2_INDEX_READ_BIT, VK_ACCESS_2_SHADER_WRITE_BIT);
  add(kAttachment,
      VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT |
          VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
      VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
      VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT);
  return s;
}

void memory_barrier(VkCommandBuffer c, const StageAccess& from, const StageAccess& to) {
  const VkMemoryBarrier2 barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                    .srcStageMask = from.stages,
                                    .srcAccessMask = from.writes,
                                    .dstStageMask = to.stages,
                                    .dstAccessMask = to.reads | to.writes};
  const VkDependencyInfo info = {
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(c, &info);
}

// Every image stays in the general layout from here on.
void bring_new_images(Device& d, VkCommandBuffer c) {
  if (d.new_images.empty()) return;
  std::vector<VkImageMemoryBarrier2> barriers;
  for (const VkImage image : d.new_images)
    barriers.push_back(
        {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
         .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
         .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
         .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
         .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
         .newLayout = VK_IMAGE_LAYOUT_GENERAL,
         .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
         .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
         .image = image,
         .subresourceRange = {d.aspects.at(image), 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS}});
  const VkDependencyInfo info = {.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                 .imageMemoryBarrierCount = static_cast<uint32_t>(barriers.size()),
                                 .pImageMemoryBarriers = barriers.data()};
  vkCmdPipelineBarrier2(c, &info);
}

void grow_queries(Device& d, Queue& q, uint32_t needed) {
  if (needed <= q.query_capacity) return;
  uint32_t capacity = 64;
  while (capacity < needed) capacity *= 2;
  const VkQueryPoolCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO, .queryType = VK_QUERY_TYPE_TIMESTAMP, .queryCount = capacity};
  VkQueryPool pool = VK_NULL_HANDLE;
  ASSAY_VK(vkCreateQueryPool(d.handle, &info, nullptr, &pool));
  vkDestroyQueryPool(d.handle, q.queries, nullptr);
  q.queries = pool;
  q.query_capacity = capacity;
}

std::vector<Stamp> stamps(Device& d, Queue& q, std::span<const Command> commands, uint32_t n) {
  if (n == 0) return {};
  std::vector<uint64_t> ticks(n);
  ASSAY_VK(vkGetQueryPoolResults(d.handle, q.queries, 0, n, n * sizeof(uint64_t), ticks.data(), sizeof(uint64_t),
                                 VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
  const uint64_t mask = q.timestamp_bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << q.timestamp_bits) - 1;
  std::vector<Stamp> out;
  for (const Command& c : commands)
    if (c.kind == Command::Kind::timestamp)
      out.push_back(
          {c.label, static_cast<double>((ticks[out.size()] - ticks[0]) & mask) * d.physical.info.timestamp_ns});
  return out;
}

double process_cpu_ns() {
  timespec t = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

void encode(Recorder& r, const Command& c, uint32_t& stamp) {
  switch (c.kind) {
    case Command::Kind::barrier:
      memory_barrier(r.commands, stages_of(c.from, r.queue.flags), stages_of(c.to, r.queue.flags));
      return;
    case Command::Kind::timestamp:
      if (r.queue.timestamp_bits == 0) return;
      vkCmdWriteTimestamp2(r.commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, r.queue.queries, stamp++);
      // lavapipe writes it at the next barrier: without one here a dispatch that needs none would count as before it.
      if (r.device.physical.info.type == "cpu")
        memory_barrier(r.commands, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0, 0},
                       {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0, 0});
      return;
    default:
      break;
  }
  const bool labelled = r.device.instance->debug_utils;
  const VkDebugUtilsLabelEXT label = {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pLabelName = c.label.c_str()};
  if (labelled) vkCmdBeginDebugUtilsLabelEXT(r.commands, &label);
  c.encode(r);
  if (labelled) vkCmdEndDebugUtilsLabelEXT(r.commands);
}

}  // namespace

void full_barrier(VkCommandBuffer c, bool to_host) {
  const StageAccess device = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                              VK_ACCESS_2_MEMORY_WRITE_BIT};
  const StageAccess host = {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT, 0};
  memory_barrier(c, device, to_host ? host : device);
}

VkDescriptorSet Recorder::descriptor_set(VkDescriptorSetLayout layout) {
  DescriptorPools& p = queue.descriptors;
  while (true) {
    if (p.in_use == p.pools.size()) {
      constexpr uint32_t kSets = 256;
      const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 12 * kSets},
                                            {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2 * kSets},
                                            {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 8 * kSets},
                                            {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 8 * kSets},
                                            {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 16 * kSets}};
      const VkDescriptorPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                               .maxSets = kSets,
                                               .poolSizeCount = 5,
                                               .pPoolSizes = sizes};
      ASSAY_VK(vkCreateDescriptorPool(device.handle, &info, nullptr, &p.pools.emplace_back()));
    }
    const VkDescriptorSetAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                              .descriptorPool = p.pools[p.in_use],
                                              .descriptorSetCount = 1,
                                              .pSetLayouts = &layout};
    VkDescriptorSet set = VK_NULL_HANDLE;
    const VkResult result = ASSAY_ATTEMPT(vkAllocateDescriptorSets(device.handle, &info, &set));
    if (result == VK_SUCCESS) return set;
    if (result != VK_ERROR_OUT_OF_POOL_MEMORY && result != VK_ERROR_FRAGMENTED_POOL)
      require_success(result, "vkAllocateDescriptorSets(device.handle, &info, &set)", __FILE__, __LINE__);
    ++p.in_use;
  }
}

void Recorder::bind(VkPipelineBindPoint point, const Pipeline& pipeline) {
  vkCmdBindPipeline(commands, point, pipeline.handle);
  if (!pipeline.has_run && device.physical.info.type == "cpu") ++queue.first_runs;
  pipeline.has_run = true;
}

void begin(Device& d, Queue& q) {
  if (d.lost) throw Lost("the device was lost by earlier work; open a fresh one");
  q.first_runs = 0;
  for (const VkDescriptorPool pool : q.descriptors.pools) ASSAY_VK(vkResetDescriptorPool(d.handle, pool, 0));
  q.descriptors.in_use = 0;
  const VkCommandBufferBeginInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                         .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  ASSAY_VK(vkResetCommandBuffer(q.commands, 0));  // an exception may have left it half recorded
  ASSAY_VK(vkBeginCommandBuffer(q.commands, &info));
  bring_new_images(d, q.commands);
  full_barrier(q.commands);
}

namespace {

void wait(Device& d, Queue& q) {
  const uint64_t most_ns = fence_wait_ns * (1 + uint64_t{q.first_runs});
  const VkResult waited = ASSAY_ATTEMPT(vkWaitForFences(d.handle, 1, &q.fence, VK_TRUE, most_ns));
  if (waited == VK_TIMEOUT) {
    d.hung = true;
    throw Lost(fmt::format("vkWaitForFences: the work was not done after {:g} s", static_cast<double>(most_ns) * 1e-9));
  }
  require_success(waited, "vkWaitForFences(d.handle, 1, &q.fence, VK_TRUE, most_ns)", __FILE__, __LINE__);
  ASSAY_VK(vkResetFences(d.handle, 1, &q.fence));
}

}  // namespace

#ifdef ASSAY_TESTS
void set_fence_wait(std::chrono::nanoseconds wait) { fence_wait_ns = static_cast<uint64_t>(wait.count()); }
#endif

void submit_and_wait(Device& d, Queue& q) {
  full_barrier(q.commands, true);
  ASSAY_VK(vkEndCommandBuffer(q.commands));
  const VkCommandBufferSubmitInfo commands = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                              .commandBuffer = q.commands};
  const VkSubmitInfo2 submit = {
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2, .commandBufferInfoCount = 1, .pCommandBufferInfos = &commands};
  d.lost = true;  // until all of this has gone well
  try {
    ASSAY_VK(vkQueueSubmit2(q.handle, 1, &submit, q.fence));
    wait(d, q);
  } catch (...) {
    if (!d.hung) vkDeviceWaitIdle(d.handle);  // what was submitted may still use what the caller is about to free
    throw;
  }
  d.lost = false;
  d.new_images.clear();
}

void submit_once(Device& d, const std::function<void(VkCommandBuffer)>& record) {
  begin(d, d.queues[0]);
  record(d.queues[0].commands);
  submit_and_wait(d, d.queues[0]);
}

Command barrier(uint32_t from, uint32_t to) {
  return {.kind = Command::Kind::barrier, .label = "barrier", .from = from, .to = to};
}
Command timestamp(std::string label) { return {.kind = Command::Kind::timestamp, .label = std::move(label)}; }

Timing run(Device& d, std::span<const Command> commands, uint32_t queue) {
  if (queue >= d.queues.size()) throw std::logic_error(fmt::format("this device has no queue {}", queue));
  Queue& q = d.queues[queue];
  uint32_t queries = 0;
  for (const Command& c : commands) queries += c.kind == Command::Kind::timestamp && q.timestamp_bits > 0;
  grow_queries(d, q, queries);
  begin(d, q);
  if (queries > 0) vkCmdResetQueryPool(q.commands, q.queries, 0, queries);
  Recorder recorder(d, q);
  uint32_t stamp = 0;
  for (const Command& c : commands) encode(recorder, c, stamp);
  Timing timing;
  const auto start = std::chrono::steady_clock::now();
  const double cpu = process_cpu_ns();
  submit_and_wait(d, q);
  timing.cpu_ns = process_cpu_ns() - cpu;
  timing.wall_ns = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  timing.stamps = stamps(d, q, commands, queries);
  return timing;
}

}  // namespace assay::device
