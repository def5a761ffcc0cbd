// Pipelines: made once for a shader, its constants and its draw state, and kept in the device.
#include <fmt/format.h>

#include <algorithm>

#include "harness/device/formats.h"
#include "harness/device/internal.h"

namespace assay::device {

namespace {

constexpr uint32_t kRowBytes = 4;  // the push constant of a repeated pass

class Module {
 public:
  // The descriptor set of every binding becomes `set`: a draw's two stages number their slots independently.
  Module(Device& d, const Shader& shader, const Reflection& reflection, uint32_t set) : device_(d) {
    std::vector<uint32_t> words(shader.words.begin(), shader.words.end());
    for (const Binding& b : reflection.bindings)
      if (b.set_word) words[b.set_word] = set;
    const VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                           .codeSize = words.size() * sizeof(uint32_t),
                                           .pCode = words.data()};
    ASSAY_VK(vkCreateShaderModule(d.handle, &info, nullptr, &handle));
    set_name(d, VK_OBJECT_TYPE_SHADER_MODULE, handle, fmt::format("{}/{}", shader.kernel, shader.file));
  }
  ~Module() { vkDestroyShaderModule(device_.handle, handle, nullptr); }
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;
  VkShaderModule handle = VK_NULL_HANDLE;

 private:
  Device& device_;
};

// The values of a module's constants; must stay where it is while the pipeline is made.
struct Specialisation {
  Specialisation(const Device& d, const Reflection& reflection, const ConstantValues& values) {
    for (const SpecialConstant& c : reflection.constants) {
      const auto it = values.find(c.name);
      if (it == values.end() && c.name != "SUBGROUP_SIZE") continue;
      entries.push_back({c.id, static_cast<uint32_t>(data.size() * 4), 4});
      data.push_back(c.name == "SUBGROUP_SIZE" ? d.physical.info.traits.subgroup_width : it->second);
    }
    info = {static_cast<uint32_t>(entries.size()), entries.data(), data.size() * 4, data.data()};
  }
  Specialisation(const Specialisation&) = delete;
  Specialisation& operator=(const Specialisation&) = delete;
  std::vector<VkSpecializationMapEntry> entries;
  std::vector<uint32_t> data;
  VkSpecializationInfo info = {};
};

VkDescriptorSetLayout make_set_layout(Device& d, const Reflection& r, VkShaderStageFlags stage) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const Binding& b : r.bindings)
    bindings.push_back({.binding = b.slot,
                        .descriptorType = descriptor_type(b.kind),
                        .descriptorCount = b.count,
                        .stageFlags = stage});
  const VkDescriptorSetLayoutCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                .bindingCount = static_cast<uint32_t>(bindings.size()),
                                                .pBindings = bindings.data()};
  VkDescriptorSetLayout set = VK_NULL_HANDLE;
  ASSAY_VK(vkCreateDescriptorSetLayout(d.handle, &info, nullptr, &set));
  return set;
}

void make_layout(Device& d, Pipeline& p, const VkPushConstantRange* push) {
  const VkPipelineLayoutCreateInfo info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                           .setLayoutCount = static_cast<uint32_t>(p.sets.size()),
                                           .pSetLayouts = p.sets.data(),
                                           .pushConstantRangeCount = push ? 1u : 0u,
                                           .pPushConstantRanges = push};
  ASSAY_VK(vkCreatePipelineLayout(d.handle, &info, nullptr, &p.layout));
}

// Where a device offers several widths, the one that Info tells is asked for.
struct WidthRequest {
  VkPipelineShaderStageRequiredSubgroupSizeCreateInfo info;
  explicit WidthRequest(const Device& d)
      : info{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO,
             .requiredSubgroupSize = d.physical.info.traits.subgroup_width} {}
};

void make_compute(Device& d, Pipeline& p, const Shader& shader, const ConstantValues& constants) {
  const Reflection& r = reflect(shader);
  p.stages = {&r};
  p.sets.push_back(make_set_layout(d, r, VK_SHADER_STAGE_COMPUTE_BIT));
  const VkPushConstantRange push = {VK_SHADER_STAGE_COMPUTE_BIT, 0, kRowBytes};
  make_layout(d, p, r.push_bytes ? &push : nullptr);
  const Module module(d, shader, r, 0);
  const Specialisation values(d, r, constants);
  const WidthRequest width(d);
  const VkComputePipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                            .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                      .pNext = d.choose_subgroup_size ? &width.info : nullptr,
                                                      .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                      .module = module.handle,
                                                      .pName = "main",
                                                      .pSpecializationInfo = &values.info},
                                            .layout = p.layout};
  ASSAY_VK(vkCreateComputePipelines(d.handle, d.pipeline_cache, 1, &info, nullptr, &p.handle));
}

VkCompareOp compare_op(Compare c) {
  switch (c) {
    case Compare::always:
      return VK_COMPARE_OP_ALWAYS;
    case Compare::less:
      return VK_COMPARE_OP_LESS;
    case Compare::greater:
      return VK_COMPARE_OP_GREATER;
    case Compare::greater_equal:
      return VK_COMPARE_OP_GREATER_OR_EQUAL;
    case Compare::equal:
      return VK_COMPARE_OP_EQUAL;
  }
  throw std::logic_error("a comparison without a Vulkan name");
}

VkPipelineColorBlendAttachmentState blend_state(Blend b) {
  VkPipelineColorBlendAttachmentState s = {.blendEnable = b != Blend::none};
  s.colorWriteMask =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  s.srcColorBlendFactor = b == Blend::over ? VK_BLEND_FACTOR_SRC_ALPHA : VK_BLEND_FACTOR_ONE;
  s.dstColorBlendFactor = b == Blend::over ? VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA : VK_BLEND_FACTOR_ONE;
  s.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  s.dstAlphaBlendFactor = s.dstColorBlendFactor;
  return s;
}

// The fixed-function state of a draw; its parts point at each other, so it stays where it is.
struct FixedFunction {
  VkPipelineVertexInputStateCreateInfo vertices = {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
      .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
  VkPipelineViewportStateCreateInfo viewport = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
  VkPipelineRasterizationStateCreateInfo raster = {.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
                                                   .polygonMode = VK_POLYGON_MODE_FILL,
                                                   .lineWidth = 1};
  VkPipelineMultisampleStateCreateInfo samples = {.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
                                                  .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
  VkPipelineDepthStencilStateCreateInfo depth = {.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  std::vector<VkPipelineColorBlendAttachmentState> targets;
  VkPipelineColorBlendStateCreateInfo blend = {.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  VkDynamicState dynamic_states[2] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic = {.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                              .dynamicStateCount = 2};
  std::vector<VkFormat> formats;
  VkPipelineRenderingCreateInfo rendering = {.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};

  explicit FixedFunction(const DrawState& s) {
    raster.cullMode = s.cull == Cull::none   ? VK_CULL_MODE_NONE
                      : s.cull == Cull::back ? VK_CULL_MODE_BACK_BIT
                                             : VK_CULL_MODE_FRONT_BIT;
    // Vulkan's signed area carries a minus for framebuffers whose y points down, so COUNTER_CLOCKWISE is what the eye
    // sees on the picture. The clip rows have turned y over once, the picture is upright, and a triangle that is
    // counter-clockwise in glTF's world, seen from its front, is so on the picture.
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    if (s.depth) {
      depth.depthTestEnable = VK_TRUE;
      depth.depthWriteEnable = s.depth->write;
      depth.depthCompareOp = compare_op(s.depth->compare);
      rendering.depthAttachmentFormat = info_of(s.depth_format).vulkan;
    }
    for (const auto& target : s.colours) {
      formats.push_back(info_of(target.first).vulkan);
      targets.push_back(blend_state(target.second));
    }
    blend.attachmentCount = rendering.colorAttachmentCount = static_cast<uint32_t>(formats.size());
    blend.pAttachments = targets.data();
    rendering.pColorAttachmentFormats = formats.data();
    dynamic.pDynamicStates = dynamic_states;
  }
  FixedFunction(const FixedFunction&) = delete;
  FixedFunction& operator=(const FixedFunction&) = delete;
};

void make_draw(Device& d, Pipeline& p, const Shader& vertex, const Shader& fragment, const ConstantValues& constants,
               const DrawState& state) {
  const Reflection &v = reflect(vertex), &f = reflect(fragment);
  p.stages = {&v, &f};
  p.sets.push_back(make_set_layout(d, v, VK_SHADER_STAGE_VERTEX_BIT));
  p.sets.push_back(make_set_layout(d, f, VK_SHADER_STAGE_FRAGMENT_BIT));
  make_layout(d, p, nullptr);
  const Module vertex_module(d, vertex, v, 0), fragment_module(d, fragment, f, 1);
  const Specialisation vertex_values(d, v, constants), fragment_values(d, f, constants);
  const VkPipelineShaderStageCreateInfo stages[] = {{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                     .stage = VK_SHADER_STAGE_VERTEX_BIT,
                                                     .module = vertex_module.handle,
                                                     .pName = "main",
                                                     .pSpecializationInfo = &vertex_values.info},
                                                    {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                     .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
                                                     .module = fragment_module.handle,
                                                     .pName = "main",
                                                     .pSpecializationInfo = &fragment_values.info}};
  const FixedFunction fixed(state);
  const VkGraphicsPipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                             .pNext = &fixed.rendering,
                                             .stageCount = 2,
                                             .pStages = stages,
                                             .pVertexInputState = &fixed.vertices,
                                             .pInputAssemblyState = &fixed.assembly,
                                             .pViewportState = &fixed.viewport,
                                             .pRasterizationState = &fixed.raster,
                                             .pMultisampleState = &fixed.samples,
                                             .pDepthStencilState = &fixed.depth,
                                             .pColorBlendState = &fixed.blend,
                                             .pDynamicState = &fixed.dynamic,
                                             .layout = p.layout};
  ASSAY_VK(vkCreateGraphicsPipelines(d.handle, d.pipeline_cache, 1, &info, nullptr, &p.handle));
}

std::string key_of(const Shader& s, const ConstantValues& constants) {
  std::string key = fmt::format("{}/{}#{}", s.kernel, s.file, s.mutant);
  for (const SpecialConstant& c : reflect(s).constants)
    if (const auto it = constants.find(c.name); it != constants.end()) key += fmt::format(" {}={}", c.name, it->second);
  return key;
}

std::string key_of(const DrawState& s) {
  std::string key = fmt::format(" cull{}", static_cast<int>(s.cull));
  for (const auto& [format, blend] : s.colours) key += fmt::format(" {}:{}", name_of(format), static_cast<int>(blend));
  if (s.depth)
    key += fmt::format(" {}:{}:{}", name_of(s.depth_format), static_cast<int>(s.depth->compare), s.depth->write);
  return key;
}

// The pipeline of this key, made by `make` where there is none. One half made is given back.
template <class Make>
const Pipeline& cached(Device& d, const std::string& key, Make make) {
  if (const auto it = d.pipelines.find(key); it != d.pipelines.end()) return it->second;
  Pipeline p;
  try {
    make(p);
    set_name(d, VK_OBJECT_TYPE_PIPELINE, p.handle, key);
  } catch (...) {
    destroy_pipeline(d, p);
    throw;
  }
  return d.pipelines.emplace(key, std::move(p)).first->second;
}

}  // namespace

void destroy_pipeline(Device& d, const Pipeline& p) noexcept {
  vkDestroyPipeline(d.handle, p.handle, nullptr);
  vkDestroyPipelineLayout(d.handle, p.layout, nullptr);
  for (const VkDescriptorSetLayout set : p.sets) vkDestroyDescriptorSetLayout(d.handle, set, nullptr);
}

VkDescriptorType descriptor_type(BindingKind k) {
  switch (k) {
    case BindingKind::storage_buffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingKind::uniform_buffer:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingKind::image:
      return VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    case BindingKind::storage_image:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case BindingKind::textures:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case BindingKind::other:
      break;
  }
  throw std::logic_error("a binding that is no kind of port");
}

const Pipeline& compute_pipeline(Device& d, const Shader& shader, const ConstantValues& constants) {
  return cached(d, key_of(shader, constants), [&](Pipeline& p) { make_compute(d, p, shader, constants); });
}

const Pipeline& draw_pipeline(Device& d, const Shader& vertex, const Shader& fragment, const ConstantValues& constants,
                              const DrawState& state) {
  const std::string key = key_of(vertex, constants) + " + " + key_of(fragment, constants) + key_of(state);
  return cached(d, key, [&](Pipeline& p) { make_draw(d, p, vertex, fragment, constants, state); });
}

}  // namespace assay::device
