// Names, offsets, sizes and scalar types of a struct shared with GLSL: what comparators, diffs and the layout test
// read.
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace assay {

enum class Scalar { u32, i32, f32 };

// One member, nested structs flattened ("light.colour"). `count` scalars of 4 bytes each, tightly packed.
struct Field {
  std::string name;
  uint32_t offset = 0;  // bytes from the start of the element
  uint32_t count = 1;
  Scalar scalar = Scalar::u32;
};

// An element of a buffer: its stride in bytes and its members in order. A bare scalar or vector has one member named
// "".
struct Layout {
  std::string name;
  uint32_t stride = 0;
  std::vector<Field> fields;
};

template <class S>
constexpr Scalar scalar_of() {
  static_assert(std::is_same_v<S, float> || std::is_same_v<S, uint32_t> || std::is_same_v<S, int32_t>,
                "shared structs hold float, uint and int, their vectors, arrays and structs");
  if constexpr (std::is_same_v<S, float>) return Scalar::f32;
  return std::is_same_v<S, int32_t> ? Scalar::i32 : Scalar::u32;
}

template <class T>
struct Components {  // of a bare scalar
  static constexpr uint32_t count = 1;
  using type = T;
};
template <glm::length_t N, class S, glm::qualifier Q>
struct Components<glm::vec<N, S, Q>> {
  static constexpr uint32_t count = N;
  using type = S;
};
template <glm::length_t C, glm::length_t R, class S, glm::qualifier Q>
struct Components<glm::mat<C, R, S, Q>> {
  static constexpr uint32_t count = C * R;
  using type = S;
};

template <class T>
concept SharedStruct = requires(const T* t) {
  shared_layout(t);
};

template <class T>
Layout layout_of() {
  if constexpr (SharedStruct<T>) {
    return shared_layout(static_cast<const T*>(nullptr));
  } else {
    using C = Components<T>;
    static_assert(sizeof(T) == 4 * C::count);
    return {"", sizeof(T), {{"", 0, C::count, scalar_of<typename C::type>()}}};
  }
}

template <class T>
void append_field(Layout& to, const std::string& name, uint32_t offset) {
  if constexpr (std::is_array_v<T>) {
    using E = std::remove_extent_t<T>;
    if constexpr (SharedStruct<E>) {
      for (uint32_t i = 0; i < std::extent_v<T>; ++i)
        append_field<E>(to, name + "[" + std::to_string(i) + "]", offset + i * static_cast<uint32_t>(sizeof(E)));
    } else {
      using C = Components<E>;
      to.fields.push_back(
          {name, offset, C::count * static_cast<uint32_t>(std::extent_v<T>), scalar_of<typename C::type>()});
    }
  } else if constexpr (SharedStruct<T>) {
    for (const Field& f : layout_of<T>().fields)
      to.fields.push_back({name + "." + f.name, offset + f.offset, f.count, f.scalar});
  } else {
    using C = Components<T>;
    to.fields.push_back({name, offset, C::count, scalar_of<typename C::type>()});
  }
}

}  // namespace assay

#define ASSAY_PARENS ()
#define ASSAY_EXPAND(...) ASSAY_EXPAND2(ASSAY_EXPAND2(ASSAY_EXPAND2(ASSAY_EXPAND2(__VA_ARGS__))))
#define ASSAY_EXPAND2(...) ASSAY_EXPAND1(ASSAY_EXPAND1(ASSAY_EXPAND1(ASSAY_EXPAND1(__VA_ARGS__))))
#define ASSAY_EXPAND1(...) __VA_ARGS__
#define ASSAY_EACH(M, T, ...) __VA_OPT__(ASSAY_EXPAND(ASSAY_EACH1(M, T, __VA_ARGS__)))
#define ASSAY_EACH1(M, T, a, ...) M(T, a) __VA_OPT__(ASSAY_EACH2 ASSAY_PARENS(M, T, __VA_ARGS__))
#define ASSAY_EACH2() ASSAY_EACH1
#define ASSAY_APPEND(T, m) ::assay::append_field<decltype(T::m)>(l, #m, offsetof(T, m));
#define ASSAY_SIZE(T, m) +sizeof(T::m)

// Lists the members of T in order, in T's own namespace. A forgotten member or hidden padding does not compile.
#define SHARED_LAYOUT(T, ...)                                                                                 \
  static_assert(std::is_trivially_copyable_v<T> && std::is_standard_layout_v<T>);                             \
  static_assert(sizeof(T) == 0 ASSAY_EACH(ASSAY_SIZE, T, __VA_ARGS__), #T ": list every member, no padding"); \
  inline ::assay::Layout shared_layout(const T*) {                                                            \
    ::assay::Layout l{#T, sizeof(T), {}};                                                                     \
    ASSAY_EACH(ASSAY_APPEND, T, __VA_ARGS__)                                                                  \
    return l;                                                                                                 \
  }                                                                                                           \
  static_assert(true)
