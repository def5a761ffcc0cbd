// Accessors to plain arrays. Every byte range is checked here before it is read.
#include <fmt/format.h>
#include <tiny_gltf.h>
#include <limits>

#include "harness/scene/gltf.h"

namespace assay::scene::gltf {
namespace {

// A checked run of elements: the i-th begins at data + i * stride.
struct Elements {
  const uint8_t* data = nullptr;
  size_t stride = 0;
};

Elements elements(const tinygltf::Model& model, int view_index, size_t offset, size_t count, size_t element_bytes,
                  size_t stride, const std::string& place) {
  if (view_index < 0 || static_cast<size_t>(view_index) >= model.bufferViews.size()) refuse(place, "has no bufferView");
  const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(view_index)];
  const std::vector<unsigned char>& buffer = model.buffers.at(static_cast<size_t>(view.buffer)).data;
  if (stride == 0) stride = view.byteStride ? view.byteStride : element_bytes;
  if (stride < element_bytes)
    refuse(place, fmt::format("stride {} is less than its element of {} bytes", stride, element_bytes));
  if (view.byteOffset + view.byteLength > buffer.size()) refuse(place, "its bufferView ends beyond the buffer");
  if (count == 0) return {};
  // count < 2^53 and stride <= 252: no overflow in 64 bits.
  const size_t end = offset + (count - 1) * stride + element_bytes;
  if (end > view.byteLength)
    refuse(place, fmt::format("ends at byte {}, bufferViews[{}] has {}", end, view_index, view.byteLength));
  return {buffer.data() + view.byteOffset + offset, stride};
}

template <class T>
T load(const uint8_t* from) {
  T t;
  std::memcpy(&t, from, sizeof t);
  return t;
}

template <class T>
float scaled(const uint8_t* from, bool normalised) {
  const float v = static_cast<float>(load<T>(from));
  return normalised ? std::max(v / static_cast<float>(std::numeric_limits<T>::max()), -1.0f) : v;
}

float component(const uint8_t* from, int type, bool normalised, const std::string& place) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return load<float>(from);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return scaled<int8_t>(from, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return scaled<uint8_t>(from, normalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return scaled<int16_t>(from, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return scaled<uint16_t>(from, normalised);
    default:
      refuse(place, fmt::format("component type {} is not known", type));
  }
}

uint32_t index_value(const uint8_t* from, int type, const std::string& place) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<uint8_t>(from);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<uint16_t>(from);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<uint32_t>(from);
    default:
      refuse(place, fmt::format("component type {} cannot be an index", type));
  }
}

size_t component_bytes(int type, const std::string& place) {
  const int bytes = tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(type));
  if (bytes <= 0) refuse(place, fmt::format("component type {} is not known", type));
  return static_cast<size_t>(bytes);
}

// Elements are far fewer than 2^32 in any file that fits in memory; a larger count is an error, not an allocation.
void check_count(const tinygltf::Accessor& a, const std::string& place) {
  if (a.count > std::numeric_limits<uint32_t>::max() / 16)
    refuse(place, fmt::format("{} elements are too many", a.count));
}

void lay_sparse(const tinygltf::Model& model, const tinygltf::Accessor& a, int components, std::vector<float>& values,
                const std::string& place) {
  const auto count = static_cast<size_t>(a.sparse.count);
  const size_t width = component_bytes(a.componentType, place),
               index_width = component_bytes(a.sparse.indices.componentType, place);
  const size_t element = width * static_cast<size_t>(components);
  if (a.sparse.count < 0 || count > a.count) refuse(place, "its sparse count exceeds its count");
  const Elements at = elements(model, a.sparse.indices.bufferView, static_cast<size_t>(a.sparse.indices.byteOffset),
                               count, index_width, index_width, place + ".sparse.indices");
  const Elements from = elements(model, a.sparse.values.bufferView, static_cast<size_t>(a.sparse.values.byteOffset),
                                 count, element, element, place + ".sparse.values");
  for (size_t i = 0; i < count; ++i) {
    const uint32_t index = index_value(at.data + i * at.stride, a.sparse.indices.componentType, place);
    if (index >= a.count) refuse(place, fmt::format("sparse index {} is out of range, there are {}", index, a.count));
    for (size_t c = 0; c < static_cast<size_t>(components); ++c)
      values[index * static_cast<size_t>(components) + c] =
          component(from.data + i * from.stride + c * width, a.componentType, a.normalized, place);
  }
}

}  // namespace

std::vector<float> read_floats(const tinygltf::Model& model, int accessor, int components, const std::string& place) {
  const tinygltf::Accessor& a = model.accessors.at(static_cast<size_t>(accessor));
  const std::string here = fmt::format("{} (accessors[{}])", place, accessor);
  check_count(a, here);
  if (tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type)) != components)
    refuse(here, fmt::format("does not have {} components", components));
  const size_t width = component_bytes(a.componentType, here), n = static_cast<size_t>(components);
  if (a.bufferView < 0 && !a.sparse.isSparse) refuse(here, "has no bufferView");
  Elements from;
  if (a.bufferView >= 0) from = elements(model, a.bufferView, a.byteOffset, a.count, width * n, 0, here);
  std::vector<float> values(a.count * n, 0.0f);  // a sparse accessor without a view starts from zeros
  for (size_t i = 0; i < a.count && from.data; ++i)
    for (size_t c = 0; c < n; ++c)
      values[i * n + c] = component(from.data + i * from.stride + c * width, a.componentType, a.normalized, here);
  if (a.sparse.isSparse) lay_sparse(model, a, components, values, here);
  for (size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) refuse(here, fmt::format("element {} is not finite", i / n));
  return values;
}

std::vector<uint32_t> read_indices(const tinygltf::Model& model, int accessor, const std::string& place) {
  const tinygltf::Accessor& a = model.accessors.at(static_cast<size_t>(accessor));
  const std::string here = fmt::format("{} (accessors[{}])", place, accessor);
  check_count(a, here);
  if (a.type != TINYGLTF_TYPE_SCALAR) refuse(here, "is not scalar");
  if (a.sparse.isSparse) refuse(here, "sparse indices of a primitive are not supported");
  const Elements from =
      elements(model, a.bufferView, a.byteOffset, a.count, component_bytes(a.componentType, here), 0, here);
  std::vector<uint32_t> values(a.count);
  for (size_t i = 0; i < a.count; ++i) values[i] = index_value(from.data + i * from.stride, a.componentType, here);
  return values;
}

}  // namespace assay::scene::gltf
