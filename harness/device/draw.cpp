// A Draw pass: one rendering scope, targets, then calls in order.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "harness/device/formats.h"
#include "harness/device/internal.h"

namespace assay::device {

namespace {

struct Target {
  VkImageView view = VK_NULL_HANDLE;
  bool clear = false;
  VkClearValue value = {};
};

struct Call {
  const Pipeline* pipeline = nullptr;
  BoundSet vertex, fragment;
  uint64_t first = 0;
  uint32_t count = 0;
  VkBuffer count_buffer = VK_NULL_HANDLE;
};

struct Job {
  VkExtent2D extent = {};
  std::vector<Target> colours;
  std::optional<Target> depth;
  VkBuffer indices = VK_NULL_HANDLE, commands = VK_NULL_HANDLE;
  std::vector<Call> calls;
  std::vector<Owned> keep;
};

VkRenderingAttachmentInfo attachment(const Target& t) {
  return {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
          .imageView = t.view,
          .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
          .loadOp = t.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD,
          .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
          .clearValue = t.value};
}

void encode_indirect(Recorder& r, const Job& job, const Call& call) {
  constexpr uint32_t kStride = sizeof(DrawCommand);
  const uint64_t offset = call.first * kStride;
  if (call.count_buffer) {
    vkCmdDrawIndexedIndirectCount(r.commands, job.commands, offset, call.count_buffer, 0, call.count, kStride);
    return;
  }
  const uint32_t most = r.device.multi_draw_indirect ? r.device.physical.properties.limits.maxDrawIndirectCount : 1;
  for (uint32_t done = 0; done < call.count; done += std::min(most, call.count - done))
    vkCmdDrawIndexedIndirect(r.commands, job.commands, offset + uint64_t{done} * kStride,
                             std::min(most, call.count - done), kStride);
}

void encode_call(Recorder& r, const Job& job, const Call& call) {
  r.bind(VK_PIPELINE_BIND_POINT_GRAPHICS, *call.pipeline);
  bind_set(r, VK_PIPELINE_BIND_POINT_GRAPHICS, *call.pipeline, 0, call.vertex);
  bind_set(r, VK_PIPELINE_BIND_POINT_GRAPHICS, *call.pipeline, 1, call.fragment);
  if (job.commands) return encode_indirect(r, job, call);
  const auto first = static_cast<uint32_t>(call.first);
  if (job.indices)
    vkCmdDrawIndexed(r.commands, call.count, 1, first, 0, 0);
  else
    vkCmdDraw(r.commands, call.count, 1, first, 0);
}

void encode(Recorder& r, const Job& job) {
  std::vector<VkRenderingAttachmentInfo> colours;
  for (const Target& t : job.colours) colours.push_back(attachment(t));
  VkRenderingAttachmentInfo depth = {};
  if (job.depth) depth = attachment(*job.depth);
  const VkRenderingInfo info = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                .renderArea = {{0, 0}, job.extent},
                                .layerCount = 1,
                                .colorAttachmentCount = static_cast<uint32_t>(colours.size()),
                                .pColorAttachments = colours.data(),
                                .pDepthAttachment = job.depth ? &depth : nullptr};
  const VkViewport viewport = {0, 0, static_cast<float>(job.extent.width), static_cast<float>(job.extent.height), 0, 1};
  vkCmdBeginRendering(r.commands, &info);
  vkCmdSetViewport(r.commands, 0, 1, &viewport);
  vkCmdSetScissor(r.commands, 0, 1, &info.renderArea);
  if (job.indices) vkCmdBindIndexBuffer(r.commands, job.indices, 0, VK_INDEX_TYPE_UINT32);
  for (const Call& call : job.calls) encode_call(r, job, call);
  vkCmdEndRendering(r.commands);
}

// The target's image, all targets being of one extent.
Target target_of(const Lowering& l, Job& job, const std::string& port, std::vector<Use>& uses, bool reads) {
  const Owned& r = resource_of(l, port);
  if (r->kind != PortKind::image) throw std::logic_error(fmt::format("{}: target {} is no image", l.label, port));
  const VkExtent2D extent = {r->extent.width, r->extent.height};
  if (!job.keep.empty() && (extent.width != job.extent.width || extent.height != job.extent.height))
    throw std::logic_error(fmt::format("{}: target {} is {}x{}, another {}x{}", l.label, port, extent.width,
                                       extent.height, job.extent.width, job.extent.height));
  job.extent = extent;
  job.keep.push_back(r);
  uses.push_back({.port = port,
                  .resource = r.get(),
                  .bytes = bound_bytes(*r),
                  .reads = reads,
                  .writes = true,
                  .scope = kAttachment});
  return {.view = view_of(*r, format_of(l, port))};
}

void lower_targets(const Lowering& l, const Draw& pass, Job& job, DrawState& state, std::vector<Use>& uses) {
  for (const ColourTarget& c : pass.colours) {
    Target t = target_of(l, job, c.port, uses, !c.clear || c.blend != Blend::none);
    t.clear = c.clear.has_value();
    if (c.clear) std::memcpy(&t.value.color, &*c.clear, sizeof t.value.color);
    job.colours.push_back(t);
    state.colours.emplace_back(format_of(l, c.port), c.blend);
  }
  if (!pass.depth) return;
  Target t = target_of(l, job, pass.depth->port, uses, true);
  t.clear = pass.depth->clear.has_value();
  t.value.depthStencil = {pass.depth->clear.value_or(0), 0};
  if (!pass.depth->write && !t.clear) uses.back().writes = false;
  job.depth = t;
  state.depth = pass.depth;
  state.depth_format = format_of(l, pass.depth->port);
}

void lower_call(const Lowering& l, const Draw& pass, const DrawCall& c, Job& job, DrawState state,
                std::vector<Use>& uses) {
  const uint64_t first = c.first ? c.first(l.input) : 0, count = c.count ? c.count(l.input) : 0;
  if (count == 0) return;
  if (count > UINT32_MAX || first > UINT32_MAX)
    throw std::logic_error(fmt::format("{}: a draw of {} from {}", l.label, count, first));
  Call call = {.first = first, .count = static_cast<uint32_t>(count)};
  state.cull = c.cull;
  const Shader &vertex = shader_of(l, c.vertex), &fragment = shader_of(l, c.fragment);
  call.pipeline = &draw_pipeline(l.device, vertex, fragment, l.constants, state);
  call.vertex = bound_set(l, vertex, *call.pipeline->stages[0], kGraphics, uses);
  call.fragment = bound_set(l, fragment, *call.pipeline->stages[1], kGraphics, uses);
  if (!pass.commands.empty())
    use_buffer(uses, pass.commands, *resource_of(l, pass.commands), first * sizeof(DrawCommand),
               count * sizeof(DrawCommand), kIndirect);
  if (!c.count_port.empty()) {
    if (!l.device.draw_indirect_count) throw Error(fmt::format("{}: this device has no draw_indirect_count", l.label));
    const Owned& r = resource_of(l, c.count_port);
    use_buffer(uses, c.count_port, *r, 0, sizeof(uint32_t), kIndirect);
    call.count_buffer = r->buffer;
    job.keep.push_back(r);
  }
  job.calls.push_back(std::move(call));
}

void lower_buffers(const Lowering& l, const Draw& pass, Job& job, std::vector<Use>& uses) {
  if (!pass.commands.empty() && pass.indices.empty())
    throw std::logic_error(fmt::format("{}: draw commands are indexed, and the draw names no index port", l.label));
  if (!pass.indices.empty()) {
    const Owned& r = resource_of(l, pass.indices);
    use_buffer(uses, pass.indices, *r, 0, r->payload, kGraphics);
    job.indices = r->buffer;
    job.keep.push_back(r);
  }
  if (pass.commands.empty()) return;
  const Owned& r = resource_of(l, pass.commands);
  job.commands = r->buffer;
  job.keep.push_back(r);
}

// One entry a resource, port and scope: calls of a draw mostly bind the same.
void merge(std::vector<Use>& uses) {
  std::vector<Use> merged;
  for (const Use& u : uses) {
    const auto same = std::ranges::find_if(merged, [&](const Use& m) {
      return m.port == u.port && m.resource == u.resource && m.scope == u.scope && m.offset == u.offset &&
             m.bytes == u.bytes;
    });
    if (same == merged.end()) {
      merged.push_back(u);
      continue;
    }
    same->reads |= u.reads;
    same->writes |= u.writes;
  }
  uses = std::move(merged);
}

// One that neither clears nor draws may lack what it would bind.
bool has_work(const Lowering& l, const Draw& pass) {
  return std::ranges::any_of(pass.colours, [](const ColourTarget& c) { return c.clear.has_value(); }) ||
         (pass.depth && pass.depth->clear) ||
         std::ranges::any_of(pass.calls, [&](const DrawCall& c) { return c.count && c.count(l.input) > 0; });
}

}  // namespace

std::optional<Command> lower_draw(const Lowering& l, const Draw& pass) {
  if (!has_work(l, pass)) return std::nullopt;
  Job job;
  DrawState state;
  Command c = {.kind = Command::Kind::draw, .label = l.label + " draw"};
  lower_targets(l, pass, job, state, c.uses);
  if (job.keep.empty()) throw std::logic_error(fmt::format("{}: a draw without targets", l.label));
  lower_buffers(l, pass, job, c.uses);
  for (const DrawCall& call : pass.calls) lower_call(l, pass, call, job, state, c.uses);
  if (!pass.calls.empty()) c.label = l.label + " " + pass.calls[0].fragment;
  merge(c.uses);
  const auto shared = std::make_shared<const Job>(std::move(job));
  c.encode = [shared](Recorder& r) { encode(r, *shared); };
  return c;
}

}  // namespace assay::device
