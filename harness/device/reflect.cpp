#include "harness/device/reflect.h"

#include <fmt/format.h>
#include <algorithm>

#include <mutex>
#include <spirv_cross/spirv_cross.hpp>
#include <unordered_map>

namespace assay::device {

namespace {

using spirv_cross::Compiler;
using spirv_cross::SPIRType;

// Where a value lies and how its repeated parts are spaced, as its parent's decorations say.
struct Place {
  std::string name;
  uint32_t offset = 0, array_stride = 0, matrix_stride = 0;
};

struct ScalarKind {
  Scalar scalar;
  uint32_t bytes;
};

// Wider and narrower scalars are told as the 32-bit words that they fill: ports know no others.
std::optional<ScalarKind> scalar_of(const SPIRType& t) {
  switch (t.basetype) {
    case SPIRType::Float:
      return ScalarKind{Scalar::f32, 4};
    case SPIRType::UInt:
      return ScalarKind{Scalar::u32, 4};
    case SPIRType::Int:
      return ScalarKind{Scalar::i32, 4};
    case SPIRType::UInt64:
    case SPIRType::Int64:
      return ScalarKind{Scalar::u32, 8};
    case SPIRType::Half:
    case SPIRType::UShort:
    case SPIRType::Short:
      return ScalarKind{Scalar::u32, 2};
    default:
      return std::nullopt;
  }
}

class Flattener {
 public:
  Flattener(const Compiler& compiler, Binding& to) : compiler_(compiler), to_(to) {}

  void value(const SPIRType& t, const Place& at) {
    if (t.array.size() > 1) return trouble(at, "is an array of arrays");
    if (t.basetype == SPIRType::Struct) return t.array.empty() ? members(t, at) : structs(t, at);
    const auto scalar = scalar_of(t);
    if (!scalar) return trouble(at, "has a type that no shared struct holds");
    const uint32_t length = t.array.empty() ? 1 : t.array[0];
    const uint32_t column = scalar->bytes * t.vecsize;
    if (t.columns > 1 && at.matrix_stride != column) return trouble(at, "is a matrix with padded or row-major columns");
    if (!t.array.empty() && at.array_stride != column * t.columns)
      return trouble(
          at, fmt::format("has an array stride of {} bytes for elements of {}", at.array_stride, column * t.columns));
    const uint32_t bytes = column * t.columns * length;
    if (bytes % 4 != 0) return trouble(at, "is not made of whole 32-bit words");
    to_.element.fields.push_back({at.name, at.offset, bytes / 4, scalar->scalar});
  }

  void members(const SPIRType& t, const Place& at) {
    for (uint32_t i = 0; i < t.member_types.size(); ++i) {
      const SPIRType& m = compiler_.get_type(t.member_types[i]);
      Place place{compiler_.get_member_name(t.self, i), at.offset + compiler_.type_struct_member_offset(t, i)};
      if (!at.name.empty()) place.name = at.name + "." + place.name;
      if (!m.array.empty()) place.array_stride = compiler_.type_struct_member_array_stride(t, i);
      const bool row_major = compiler_.has_member_decoration(t.self, i, spv::DecorationRowMajor);
      if (m.columns > 1 && !row_major) place.matrix_stride = compiler_.type_struct_member_matrix_stride(t, i);
      value(m, place);
    }
  }

 private:
  void structs(const SPIRType& t, const Place& at) {
    for (uint32_t i = 0; i < t.array[0]; ++i)
      members(t, {fmt::format("{}[{}]", at.name, i), at.offset + i * at.array_stride, 0, 0});
  }
  void trouble(const Place& at, const std::string& what) { to_.trouble = fmt::format("member '{}' {}", at.name, what); }
  const Compiler& compiler_;
  Binding& to_;
};

void set_place(const Compiler& c, uint32_t id, Binding& b) {
  b.set = c.get_decoration(id, spv::DecorationDescriptorSet);
  b.slot = c.get_decoration(id, spv::DecorationBinding);
  c.get_binary_offset_for_decoration(id, spv::DecorationDescriptorSet, b.set_word);
}

Binding block_binding(const Compiler& c, const spirv_cross::Resource& r, BindingKind kind) {
  Binding b{.name = c.get_member_name(r.base_type_id, 0), .block = c.get_name(r.base_type_id), .kind = kind};
  set_place(c, r.id, b);
  const SPIRType& block = c.get_type(r.base_type_id);
  if (block.member_types.size() != 1) {
    b.name = b.block;
    b.trouble = "a block has one member, named after the port";
    return b;
  }
  const SPIRType& member = c.get_type(block.member_types[0]);
  if (member.basetype == SPIRType::Struct) b.element.name = c.get_name(member.self);
  Flattener flatten(c, b);
  if (kind == BindingKind::uniform_buffer) {
    b.writes = false;
    flatten.value(member, {});
    b.element.stride = member.basetype == SPIRType::Struct ? static_cast<uint32_t>(c.get_declared_struct_size(member))
                                                           : 4 * member.vecsize * member.columns;
    return b;
  }
  const spirv_cross::Bitset flags = c.get_buffer_block_flags(r.id);
  b.reads = !flags.get(spv::DecorationNonReadable);
  b.writes = !flags.get(spv::DecorationNonWritable);
  if (member.array.size() != 1) {
    b.trouble = "a storage block holds one array";
    return b;
  }
  b.element.stride = c.type_struct_member_array_stride(block, 0);
  flatten.value(c.get_type(member.parent_type), {});
  return b;
}

struct ImageFormatName {
  spv::ImageFormat format;
  const char* name;
};
constexpr ImageFormatName kImageFormats[] = {
    {spv::ImageFormatR8, "r8"},
    {spv::ImageFormatR8ui, "r8ui"},
    {spv::ImageFormatRg8, "rg8"},
    {spv::ImageFormatRgba8, "rgba8"},
    {spv::ImageFormatRgba8ui, "rgba8ui"},
    {spv::ImageFormatR16, "r16"},
    {spv::ImageFormatR16f, "r16f"},
    {spv::ImageFormatR16ui, "r16ui"},
    {spv::ImageFormatRg16Snorm, "rg16_snorm"},
    {spv::ImageFormatRg16, "rg16"},
    {spv::ImageFormatRg16f, "rg16f"},
    {spv::ImageFormatRgba16f, "rgba16f"},
    {spv::ImageFormatRgba16ui, "rgba16ui"},
    {spv::ImageFormatR32ui, "r32ui"},
    {spv::ImageFormatR32f, "r32f"},
    {spv::ImageFormatRg32ui, "rg32ui"},
    {spv::ImageFormatRg32f, "rg32f"},
    {spv::ImageFormatRgba32ui, "rgba32ui"},
    {spv::ImageFormatRgba32f, "rgba32f"},
    {spv::ImageFormatR11fG11fB10f, "r11f_g11f_b10f"},
    {spv::ImageFormatR64ui, "r64ui"},
    {spv::ImageFormatUnknown, ""},
};

std::string glsl_name(spv::ImageFormat f) {
  const auto* row = std::ranges::find(kImageFormats, f, &ImageFormatName::format);
  return row == std::end(kImageFormats) ? "SPIR-V image format " + std::to_string(static_cast<int>(f)) : row->name;
}

Binding image_binding(const Compiler& c, const spirv_cross::Resource& r, BindingKind kind) {
  Binding b{.name = c.get_name(r.id), .block = "", .kind = kind};
  set_place(c, r.id, b);
  const SPIRType& t = c.get_type(r.type_id);
  if (!t.array.empty()) b.count = t.array[0];
  const SPIRType& texel = c.get_type(t.image.type);
  b.sampled = texel.basetype == SPIRType::Float ? Scalar::f32
              : texel.basetype == SPIRType::Int ? Scalar::i32
                                                : Scalar::u32;
  if (kind == BindingKind::storage_image) {
    b.format = glsl_name(t.image.format);
    b.reads = !c.has_decoration(r.id, spv::DecorationNonReadable);
    b.writes = !c.has_decoration(r.id, spv::DecorationNonWritable);
  }
  const bool flat = t.image.dim == spv::Dim2D && !t.image.ms;
  if (kind == BindingKind::textures) {
    if (!flat || !t.image.arrayed) b.trouble = "texture ports are arrays of sampler2DArray";
  } else if (!flat || t.image.arrayed || !t.array.empty()) {
    b.trouble = "image ports are single two-dimensional images";
  }
  return b;
}

Reflection make(const Shader& shader) {
  const Compiler c(shader.words.data(), shader.words.size());
  const auto resources = c.get_shader_resources();
  const auto active = c.get_active_interface_variables();
  Reflection out;
  const auto add = [&](Binding b, const spirv_cross::Resource& r) {
    b.active = active.contains(r.id);
    out.bindings.push_back(std::move(b));
  };
  for (const auto& r : resources.storage_buffers) add(block_binding(c, r, BindingKind::storage_buffer), r);
  for (const auto& r : resources.uniform_buffers) add(block_binding(c, r, BindingKind::uniform_buffer), r);
  for (const auto& r : resources.separate_images) add(image_binding(c, r, BindingKind::image), r);
  for (const auto& r : resources.storage_images) add(image_binding(c, r, BindingKind::storage_image), r);
  for (const auto& r : resources.sampled_images) add(image_binding(c, r, BindingKind::textures), r);
  for (const auto* list : {&resources.separate_samplers, &resources.subpass_inputs, &resources.acceleration_structures})
    for (const auto& r : *list) {
      Binding b{.name = r.name, .block = ""};
      b.trouble = "is no kind of port";
      add(b, r);
    }
  for (const auto& r : resources.push_constant_buffers)
    out.push_bytes = static_cast<uint32_t>(c.get_declared_struct_size(c.get_type(r.base_type_id)));
  for (const auto& s : c.get_specialization_constants())
    if (const auto& name = c.get_name(s.id); !name.empty()) out.constants.push_back({name, s.constant_id});
  return out;
}

}  // namespace

const Reflection& reflect(const Shader& shader) {
  static std::mutex mutex;
  static std::unordered_map<const uint32_t*, Reflection> known;
  const std::lock_guard lock(mutex);
  if (const auto it = known.find(shader.words.data()); it != known.end()) return it->second;
  try {
    return known.emplace(shader.words.data(), make(shader)).first->second;
  } catch (const spirv_cross::CompilerError& e) {
    throw std::logic_error(fmt::format("{}/{}: SPIR-V cannot be read: {}", shader.kernel, shader.file, e.what()));
  }
}

}  // namespace assay::device
