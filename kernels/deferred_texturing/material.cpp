#include "kernels/deferred_texturing/material.h"

#include <bit>

namespace assay::deferred_texturing {

namespace {

Range3 rgb(const Range4& c) { return {c[0], c[1], c[2]}; }
Range3 of(const vec3& v) { return {double{v.x}, double{v.y}, double{v.z}}; }

// z of a normal whose x and y are stored.
Range derived_z(Range x, Range y) { return root(clamped(1.0 - (square(x) + square(y)), 0, kInfinite)); }

RangeLayer layer_of(const MaterialRecord& m, const Filter& filter, const RangeFootprint& f) {
  const Range4 surface = filter.sampled(m.metallic_roughness_texture, f);
  RangeLayer l;
  l.base = of(vec3(m.base_colour)) * rgb(filter.sampled(m.base_texture, f));
  l.roughness = double{m.roughness} * surface[1];
  l.metallic = double{m.metallic} * surface[2];
  l.height = surface[3];
  l.emissive = of(m.emissive) * rgb(filter.sampled(m.emissive_texture, f));
  const double strength = m.occlusion_strength > 0 ? std::min(m.occlusion_strength, 1.0f) : 0;  // NaN is 0
  l.occlusion = 1.0 + strength * (filter.sampled(m.occlusion_texture, f)[0] - 1.0);
  l.normal = {0.0, 0.0, 1.0};
  if (m.normal_texture == kNoTexture) return l;
  const Range4 n = filter.sampled(m.normal_texture, f);
  const Range x = 2.0 * n[0] - 1.0, y = 2.0 * n[1] - 1.0, scale = double{m.normal_scale};
  l.normal = {scale * x, scale * y, derived_z(x, y)};
  return l;
}

// Mishkinis 2013. The higher of the raised layers gets `depth`, the other what it lacks less of it; the share is
// monotone in the difference s. Each of the two numbers is off by the rounding of the raised heights and of the base,
// and the two sum to at least `depth`.
Range upper_weight(Range lower_height, Range upper_height, Range mask, double depth) {
  const Range lower = lower_height + (1.0 - mask), upper = upper_height + mask;
  const auto share = [&](double s) {
    const double lesser = std::max(depth - std::fabs(s), 0.0);
    return (s >= 0 ? depth : lesser) / (depth + lesser);
  };
  const Range s = {upper.low - lower.high, upper.high - lower.low};
  const double size =
      std::max({std::fabs(lower.low), std::fabs(lower.high), std::fabs(upper.low), std::fabs(upper.high)});
  const double off = 2 * kUlp * (2 * size + depth);
  const double error = 3 * off / depth + 3 * kUlp;
  return {share(s.low) - error, share(s.high) + error};
}

RangeLayer mixed(const RangeLayer& a, const RangeLayer& b, Range w) {
  RangeLayer m;
  m.base = mixed(a.base, b.base, w);
  m.roughness = mixed(a.roughness, b.roughness, w), m.metallic = mixed(a.metallic, b.metallic, w);
  m.normal = mixed(a.normal, b.normal, w);
  m.emissive = mixed(a.emissive, b.emissive, w);
  m.occlusion = mixed(a.occlusion, b.occlusion, w);
  return m;
}

// By their bits as integers: NaN is beyond the largest, or below zero.
double usable_depth(float depth) {
  const auto bits = [](float v) { return std::bit_cast<int32_t>(v); };
  return std::bit_cast<float>(std::clamp(bits(depth), bits(kLeastBlendDepth), bits(kLargestBlendDepth)));
}

// Lagarde 2013.
void soak(RangeLayer& l, Range wetness) {
  const Range porosity = clamped((l.roughness - 0.5) / Range(0.4f), 0, 1);
  const Range soaked = mixed(1.0, double{0.2f}, (1.0 - l.metallic) * porosity);
  l.base = mixed(1.0, soaked, wetness) * l.base;
  l.roughness = l.roughness * mixed(1.0, soaked, 0.5 * wetness);
}

// O'Neill 2014: the output permutation of PCG RXS-M-XS 32.
uint32_t hash(uint32_t x) {
  const uint32_t state = x * 747796405u + 2891336453u;
  const uint32_t word = (state >> ((state >> 28) + 4) ^ state) * 277803737u;
  return word >> 22 ^ word;
}

}  // namespace

RangeLayer shaded(std::span<const MaterialRecord> materials, uint32_t material, uint32_t surface, const Filter& filter,
                  const RangeFootprint& f) {
  const MaterialRecord& m = materials[material];
  RangeLayer l = layer_of(m, filter, f);
  const auto mask = [&] { return filter.sampled(m.mask_texture, f)[0]; };
  const auto detail = [&] { return rgb(filter.sampled(m.detail_texture, scaled(f, m.detail_scale))); };
  switch (m.shader) {
    case kShaderTwoLayer: {
      if (m.layer >= materials.size()) break;
      const RangeLayer top = layer_of(materials[m.layer], filter, f);
      l = mixed(l, top, upper_weight(l.height, top.height, mask(), usable_depth(m.blend_depth)));
      break;
    }
    case kShaderEmissiveDetail:
      l.base = l.base * detail(), l.emissive = l.emissive * detail();
      break;
    case kShaderCloth:
      l.roughness = mixed(1.0, l.roughness, detail()[0]);
      break;
    case kShaderSkin:
      l.metallic = mask();
      break;
    case kShaderWet:
      soak(l, mask());
      break;
    case kShaderFoliage: {
      const Range t = rounded((hash(surface) >> 24) / 255.0, 2.5);
      l.base = mixed(of(kFoliageTint), {1.0, 1.0, 1.0}, t) * l.base;
      break;
    }
    default:
      break;
  }
  return l;
}

}  // namespace assay::deferred_texturing
