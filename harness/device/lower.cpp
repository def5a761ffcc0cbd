// From a variant's passes and resources to commands.
#include <fmt/format.h>

#include <algorithm>

#include "harness/device/formats.h"
#include "harness/device/internal.h"

namespace assay::device {

namespace {

ConstantValues chosen_constants(const Plan& plan) {
  ConstantValues values;
  for (const Constant& c : plan.variant->constants)
    if (!c.values.empty()) values[c.name] = c.values[0];
  for (const auto& [name, value] : plan.constants) {
    if (!values.contains(name))
      throw std::logic_error(fmt::format("{}.{}: no constant '{}'", plan.kernel->name, plan.variant->name, name));
    values[name] = value;
  }
  return values;
}

void require_matching_layouts(const Plan& plan) {
  const auto errors = layout_errors(*plan.kernel, *plan.variant);
  if (errors.empty()) return;
  std::string text = errors[0];
  for (size_t i = 1; i < errors.size(); ++i) text += "; " + errors[i];
  throw std::logic_error(text);
}

// Shaders take counts from parameters: a resource smaller than its port's count would be overrun.
void require_sizes(const Lowering& l) {
  for (const Port& p : l.plan.kernel->ports) {
    const auto it = l.ports.find(p.name);
    if (it == l.ports.end() || p.kind != PortKind::buffer || !p.count || !has_port(*l.plan.variant, p)) continue;
    const uint64_t needed = p.count(l.input) * p.layout.stride;
    if (it->second->payload < needed)
      throw std::logic_error(fmt::format("{}: port {} needs {} bytes, {} has {}", l.plan.kernel->name, p.name, needed,
                                         it->second->name, it->second->payload));
  }
}

Use use_of(const Binding& b, const std::string& port, const Resource& r, uint32_t scope) {
  return {.port = port, .resource = &r, .bytes = bound_bytes(r), .reads = b.reads, .writes = b.writes, .scope = scope};
}

void bind_buffer(BoundSet& set, const Lowering& l, const Binding& b, const Resource& r) {
  uint64_t range = bound_bytes(r);
  if (b.kind == BindingKind::uniform_buffer)
    range = std::min<uint64_t>(range, l.device.physical.properties.limits.maxUniformBufferRange);
  set.slots.push_back({b.slot, descriptor_type(b.kind), set.buffers.size(), 1});
  set.buffers.push_back({r.buffer, 0, range});
}

void bind_textures(BoundSet& set, const Lowering& l, const Binding& b, const Resource& r) {
  if (b.count < r.textures.size())
    throw std::logic_error(
        fmt::format("{}: {} has {} slots, the shader {}", l.label, r.name, r.textures.size(), b.count));
  const VkSampler sampler = l.plan.variant->anisotropic ? l.device.anisotropic_sampler : l.device.sampler;
  if (!sampler) throw std::logic_error(l.label + ": the device has no anisotropic sampler");
  set.slots.push_back({b.slot, descriptor_type(b.kind), set.images.size(), b.count});
  for (uint32_t i = 0; i < b.count; ++i) {
    const Resource& t = i < r.textures.size() ? *r.textures[i] : *l.device.white;
    set.images.push_back({sampler, view_of(t, t.format), VK_IMAGE_LAYOUT_GENERAL});
  }
}

void require_groups(const Lowering& l, const Dispatch& pass, Groups g) {
  const uint32_t* most = l.device.physical.info.max_groups;
  if (g.x <= most[0] && g.y <= most[1] && g.z <= most[2]) return;
  throw Error(fmt::format("{} {}: {} x {} x {} groups; this device has {} x {} x {} at most", l.label, pass.shader, g.x,
                          g.y, g.z, most[0], most[1], most[2]));
}

struct DispatchJob {  // what one encoded dispatch needs
  const Pipeline* pipeline;
  BoundSet set;
  Groups groups;
  VkBuffer indirect = VK_NULL_HANDLE;
  uint64_t offset = 0;
  std::optional<uint32_t> row;
};

void encode_dispatch(Recorder& r, const DispatchJob& job) {
  r.bind(VK_PIPELINE_BIND_POINT_COMPUTE, *job.pipeline);
  bind_set(r, VK_PIPELINE_BIND_POINT_COMPUTE, *job.pipeline, 0, job.set);
  if (job.row)
    vkCmdPushConstants(r.commands, job.pipeline->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(uint32_t), &*job.row);
  if (job.indirect)
    vkCmdDispatchIndirect(r.commands, job.indirect, job.offset);
  else
    vkCmdDispatch(r.commands, job.groups.x, job.groups.y, job.groups.z);
}

void lower_dispatch(const Lowering& l, const Dispatch& pass, std::vector<Command>& out) {
  const Shader& s = shader_of(l, pass.shader);
  DispatchJob job = {};
  if (pass.indirect.empty()) {
    if (!pass.groups)
      throw std::logic_error(fmt::format("{} {}: neither groups nor indirect arguments", l.label, pass.shader));
    job.groups = pass.groups(l.input);
    require_groups(l, pass, job.groups);
    if (job.groups.x == 0 || job.groups.y == 0 || job.groups.z == 0) return;
  }
  const uint64_t rows = pass.repeat ? pass.repeat(l.input) : 1;
  if (rows == 0) return;
  job.pipeline = &compute_pipeline(l.device, s, l.constants);
  const Reflection& reflection = *job.pipeline->stages[0];
  std::vector<Use> uses;
  job.set = bound_set(l, s, reflection, kCompute, uses);
  for (uint32_t row = 0; row < rows; ++row) {
    Command c = {.kind = Command::Kind::dispatch, .label = l.label + " " + pass.shader, .uses = uses};
    if (pass.repeat) c.label += fmt::format(" row {}", row);
    if (reflection.push_bytes) job.row = row;
    if (!pass.indirect.empty()) {
      const Owned& args = resource_of(l, pass.indirect);
      job.indirect = args->buffer;
      job.set.keep.push_back(args);  // no shader binds it, and the command must outlive the caller's ports
      job.offset = ((pass.first_args ? pass.first_args(l.input) : 0) + row) * sizeof(DispatchArgs);
      use_buffer(c.uses, pass.indirect, *args, job.offset, sizeof(DispatchArgs), kIndirect);
    }
    const auto shared = std::make_shared<const DispatchJob>(job);
    c.encode = [shared](Recorder& r) { encode_dispatch(r, *shared); };
    out.push_back(std::move(c));
  }
}

void lower_clear(const Lowering& l, const Clear& pass, std::vector<Command>& out) {
  const Owned r = resource_of(l, pass.port);
  if (r->kind != PortKind::buffer)
    throw std::logic_error(fmt::format("{}: clears {}, which is no buffer", l.label, pass.port));
  if (r->payload == 0) return;
  Command c = {.kind = Command::Kind::clear, .label = l.label + " clear " + pass.port};
  c.uses.push_back({.port = pass.port, .resource = r.get(), .bytes = r->payload, .writes = true, .scope = kTransfer});
  const uint32_t value = pass.value;
  c.encode = [r, value](Recorder& to) { vkCmdFillBuffer(to.commands, r->buffer, 0, r->payload, value); };
  out.push_back(std::move(c));
}

}  // namespace

const Owned& resource_of(const Lowering& l, const std::string& port) {
  const auto it = l.ports.find(port);
  if (it == l.ports.end() || !it->second)
    throw std::logic_error(fmt::format("{}: nothing is bound to port {}", l.label, port));
  if (it->second->device.get() != &l.device)
    throw std::logic_error(fmt::format("{}: the resource of port {} belongs to another device", l.label, port));
  return it->second;
}

const Shader& shader_of(const Lowering& l, const std::string& file) {
  return shader(l.plan.kernel->name, file, l.plan.mutant ? l.plan.mutant->n : 0);
}

Format format_of(const Lowering& l, const std::string& port) {
  const Port& p = port_of(*l.plan.kernel, port);
  if (!p.format_in) return p.view.value_or(p.format);
  const Format f = resource_of(l, port)->format;
  if (info_of(f).sampled != info_of(p.format).sampled)
    throw std::logic_error(fmt::format("{}: texels of port {} read otherwise as {} than as {}", l.label, port,
                                       assay::name_of(f), assay::name_of(p.format)));
  return f;
}

void use_buffer(std::vector<Use>& uses, const std::string& port, const Resource& r, uint64_t offset, uint64_t bytes,
                uint32_t scope) {
  if (r.kind != PortKind::buffer) throw std::logic_error(fmt::format("port {} is no buffer", port));
  if (offset + bytes > r.payload)
    throw std::logic_error(
        fmt::format("port {}: bytes {} to {} are asked for, it has {}", port, offset, offset + bytes, r.payload));
  uses.push_back({.port = port, .resource = &r, .offset = offset, .bytes = bytes, .reads = true, .scope = scope});
}

BoundSet bound_set(const Lowering& l, const Shader& s, const Reflection& reflection, uint32_t scope,
                   std::vector<Use>& uses) {
  BoundSet set;
  for (const Binding& b : reflection.bindings) {
    const Owned& r = resource_of(l, b.name);
    const bool buffer = b.kind == BindingKind::storage_buffer || b.kind == BindingKind::uniform_buffer;
    const PortKind kind = buffer                            ? PortKind::buffer
                          : b.kind == BindingKind::textures ? PortKind::textures
                                                            : PortKind::image;
    if (r->kind != kind)
      throw std::logic_error(
          fmt::format("{} {}: port {} is bound to a resource of another kind", l.label, s.file, b.name));
    if (buffer) {
      bind_buffer(set, l, b, *r);
    } else if (kind == PortKind::textures) {
      bind_textures(set, l, b, *r);
    } else {
      set.slots.push_back({b.slot, descriptor_type(b.kind), set.images.size(), 1});
      set.images.push_back({VK_NULL_HANDLE, view_of(*r, format_of(l, b.name)), VK_IMAGE_LAYOUT_GENERAL});
    }
    set.keep.push_back(r);
    if (b.active) uses.push_back(use_of(b, b.name, *r, scope));
  }
  return set;
}

void bind_set(Recorder& r, VkPipelineBindPoint point, const Pipeline& pipeline, uint32_t index, const BoundSet& set) {
  if (set.slots.empty()) return;
  const VkDescriptorSet target = r.descriptor_set(pipeline.sets[index]);
  std::vector<VkWriteDescriptorSet> writes;
  for (const BoundSet::Slot& s : set.slots) {
    const bool buffer = s.type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER || s.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                      .dstSet = target,
                      .dstBinding = s.binding,
                      .descriptorCount = static_cast<uint32_t>(s.count),
                      .descriptorType = s.type,
                      .pImageInfo = buffer ? nullptr : &set.images[s.first],
                      .pBufferInfo = buffer ? &set.buffers[s.first] : nullptr});
  }
  vkUpdateDescriptorSets(r.device.handle, static_cast<uint32_t>(writes.size()), writes.data(), 0, nullptr);
  vkCmdBindDescriptorSets(r.commands, point, pipeline.layout, index, 1, &target, 0, nullptr);
}

std::vector<Command> lower(Device& d, const Plan& plan, const Case& c, const Ports& ports) {
  if (!plan.kernel || !plan.variant) throw std::logic_error("a plan needs a kernel and a variant");
  require_matching_layouts(plan);
  const Lowering l = {
      d, plan, c, ports, chosen_constants(plan), plan.kernel->name + "." + label_of(*plan.variant, plan.constants)};
  require_sizes(l);
  std::vector<Command> commands;
  for (const Pass& pass : plan.variant->passes) {
    std::vector<Command> more;
    if (const auto* dispatch = std::get_if<Dispatch>(&pass)) lower_dispatch(l, *dispatch, more);
    if (const auto* clear = std::get_if<Clear>(&pass)) lower_clear(l, *clear, more);
    if (const auto* draw = std::get_if<Draw>(&pass))
      if (auto command = lower_draw(l, *draw)) more.push_back(std::move(*command));
    if (more.empty()) continue;
    if (!commands.empty()) commands.push_back(barrier());
    commands.insert(commands.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return commands;
}

}  // namespace assay::device
