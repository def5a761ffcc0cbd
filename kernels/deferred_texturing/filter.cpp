#include "kernels/deferred_texturing/filter.h"

namespace assay::deferred_texturing {

namespace {

constexpr size_t kSlots = 16;

Interval scaled(Range d, double texels) { return {d.low * texels, d.high * texels}; }

}  // namespace

Filter::Filter(std::span<const Texture> textures, const DeviceTraits& device) {
  static const Texture white = {.format = Format::rgba8_unorm,
                                .bytes = Bytes(4, std::byte{255})};  // NOLINT: what an unused slot holds
  for (size_t i = 0; i < kSlots; ++i) {
    const Texture& t = i < textures.size() ? textures[i] : white;
    slots_.push_back({double(t.width), double(t.height), TextureFilter(t, device)});
  }
}

Range4 Filter::sampled(uint32_t name, const RangeFootprint& f) const {
  const uint32_t slot = name >> 16;
  if (name == kNoTexture || slot >= slots_.size()) return {1.0, 1.0, 1.0, 1.0};
  const auto& [width, height, texture] = slots_[slot];
  const TexelDerivatives along = {scaled(f.u_dx, width), scaled(f.v_dx, height), scaled(f.u_dy, width),
                                  scaled(f.v_dy, height)};
  const Intervals4 s = texture.sampled(name & 0xffffu, f.u, f.v, texture.level_of(along));
  return {s[0], s[1], s[2], s[3]};
}

}  // namespace assay::deferred_texturing
