#include "kernels/deferred_texturing/fields.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace assay::deferred_texturing {

namespace {

template <class Texel, class F>
Unpack unpack(F of) {
  using Fields = decltype(of(Texel{}));
  return {layout_of<Fields>(), [of](std::span<const std::byte> texels) {
            Bytes out(texels.size() / sizeof(Texel) * sizeof(Fields));
            for (size_t i = 0; i < texels.size() / sizeof(Texel); ++i) {
              Texel t;
              std::memcpy(&t, texels.data() + i * sizeof t, sizeof t);
              const Fields f = of(t);
              std::memcpy(out.data() + i * sizeof f, &f, sizeof f);
            }
            return out;
          }};
}

float unorm8(uint32_t code) { return static_cast<float>((code & 0xffu) / 255.0); }

}  // namespace

vec4 base_roughness_of(uint32_t t) { return {unorm8(t), unorm8(t >> 8), unorm8(t >> 16), unorm8(t >> 24)}; }

vec3 normal_of(uint32_t t) {
  const auto snorm = [](uint32_t code) { return std::max(static_cast<int16_t>(code & 0xffffu) / 32767.0, -1.0); };
  glm::dvec3 n = {snorm(t), snorm(t >> 16), 0};
  n.z = 1 - std::fabs(n.x) - std::fabs(n.y);
  if (n.z < 0) {
    const double x = n.x;
    n.x = std::copysign(1 - std::fabs(n.y), x), n.y = std::copysign(1 - std::fabs(x), n.y);
  }
  return vec3(n / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z));
}

vec2 metallic_occlusion_of(uint16_t t) { return {unorm8(t), unorm8(uint32_t{t} >> 8)}; }

vec3 emissive_of(uint32_t t) {
  const auto channel = [&](uint32_t shift) {
    return static_cast<float>(std::ldexp(t >> shift & 511u, static_cast<int>(t >> 27) - 24));
  };
  return {channel(0), channel(9), channel(18)};
}

Unpack unpack_base_roughness() { return unpack<uint32_t>(base_roughness_of); }
Unpack unpack_normal() { return unpack<uint32_t>(normal_of); }
Unpack unpack_metallic_occlusion() { return unpack<uint16_t>(metallic_occlusion_of); }
Unpack unpack_emissive() { return unpack<uint32_t>(emissive_of); }

}  // namespace assay::deferred_texturing
