#include "kernels/deferred_texturing/filter.h"

namespace assay::deferred_texturing {

namespace {

constexpr uint32_t kSlots = 16;
constexpr double kUnorm = 1.0 / 255;
// Texels may be filtered in their own 8 bits, truncated once a lerp, of which there are three. An sRGB texel's linear
// value needs steps of 1 / (255 * 12.92) to be told from its neighbours at all; where it is larger, it may be held as a
// half, truncated once when it is decoded and once a lerp.
constexpr double kUnormFilter = 3 * kUnorm, kSrgbFilter = 3 * kUnorm / 12.92, kSrgbRelative = 4 * 0x1p-10;
constexpr double kWidest = 8;  // texels a side that are searched; beyond, the whole layer's range is taken

double linear_of(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
// Half a code either way, on the sRGB side (the tolerance of Direct3D 11; Vulkan names none).
const std::array<Range, 256>& srgb_table() {
  static const std::array<Range, 256> table = [] {
    std::array<Range, 256> t;
    for (uint32_t c = 0; c < 256; ++c)
      t[c] = {linear_of(std::max(c - 0.5, 0.0) * kUnorm), linear_of(std::min(c + 0.5, 255.0) * kUnorm)};
    return t;
  }();
  return table;
}

uint64_t wrapped(int64_t i, uint32_t n) { return static_cast<uint64_t>((i % n + n) % n); }

// Where a bilinear function may have its extremes along an axis: the ends, and the texel centres between.
struct Stops {
  std::array<double, static_cast<size_t>(kWidest) + 3> at;
  uint32_t count = 0;
  explicit Stops(Range r) {
    at[count++] = r.low;
    for (double i = std::floor(r.low) + 1; i < r.high; ++i) at[count++] = i;
    at[count++] = r.high;
  }
};

// In texels of a level, texel centres at integers: product and shift 3u, and a step of the weights.
Range in_texels(Range coordinate, uint32_t size, uint32_t sub_texel_bits) {
  const double low = coordinate.low * size, high = coordinate.high * size;
  const double error = 3 * kUnitRoundoff * (std::max(std::fabs(low), std::fabs(high)) + 1) +
                       std::ldexp(1.0, -static_cast<int>(sub_texel_bits));
  return {low - 0.5 - error, high - 0.5 + error};
}

Range4 mixed_levels(const Range4& a, const Range4& b, double weight) {
  Range4 m;
  for (uint32_t c = 0; c < 4; ++c)
    m[c] = {a[c].low + (b[c].low - a[c].low) * weight, a[c].high + (b[c].high - a[c].high) * weight};
  return m;
}
void widen(Range4& to, const Range4& by) {
  for (uint32_t c = 0; c < 4; ++c) to[c] = hull(to[c], by[c]);
}

// Vulkan, Scale Factor Operation: rho of an axis may be anything from the larger of its two magnitudes to sqrt(2) times
// their sum. LOD Operation: log2 of the larger, to mipmapPrecisionBits; Image Level(s) Selection rounds to as many
// again.
Range level_of_detail(const RangeFootprint& f, const Texture& t, uint32_t mipmap_bits) {
  const auto texels = [](Range d, uint32_t size) {
    const bool has_zero = d.low <= 0 && d.high >= 0;
    const double a = std::fabs(d.low) * size, b = std::fabs(d.high) * size;
    return Range(has_zero ? 0 : std::min(a, b), std::max(a, b));
  };
  const Range ux = texels(f.u_dx, t.width), vx = texels(f.v_dx, t.height), uy = texels(f.u_dy, t.width),
              vy = texels(f.v_dy, t.height);
  const double least = std::max({ux.low, vx.low, uy.low, vy.low});
  const double most = std::sqrt(2.0) * std::max(ux.high + vx.high, uy.high + vy.high);
  const double step = 2 * std::ldexp(1.0, -static_cast<int>(mipmap_bits)), last = t.levels - 1;
  return {std::clamp(std::log2(least) - step, 0.0, last), std::clamp(std::log2(most) + step, 0.0, last)};
}

}  // namespace

Range Filter::Level::texel(int64_t x, int64_t y, uint32_t channel) const {
  const uint32_t code =
      std::to_integer<uint32_t>(texels[(wrapped(y, height) * width + wrapped(x, width)) * 4 + channel]);
  return is_srgb && channel < 3 ? srgb_table()[code] : Range(code * kUnorm);
}

Filter::Level Filter::level_of(const Texture& t, uint32_t layer, uint32_t level) {
  uint64_t offset = 0;
  uint32_t width = t.width, height = t.height;
  for (uint32_t l = 0; l < level; ++l) {
    offset += uint64_t{width} * height * t.layers * 4;
    width = std::max(width / 2, 1u), height = std::max(height / 2, 1u);
  }
  offset += uint64_t{width} * height * layer * 4;
  return {t.bytes.data() + offset, width, height, t.format == Format::rgba8_srgb};
}

Range4 Filter::whole(const Level& l) const {
  const auto [it, is_new] = whole_.try_emplace(l.texels);
  if (!is_new) return it->second;
  for (uint32_t c = 0; c < 4; ++c) {
    Range r = {kInfinite, -kInfinite};
    for (uint32_t y = 0; y < l.height; ++y)
      for (uint32_t x = 0; x < l.width; ++x) r = hull(r, l.texel(x, y, c));
    it->second[c] = r;
  }
  return it->second;
}

Range4 Filter::bilinear(const Level& l, Range x, Range y) const {
  if (!(x.high - x.low < kWidest) || !(y.high - y.low < kWidest)) return whole(l);
  Range4 all;
  all.fill({kInfinite, -kInfinite});
  const Stops xs(x), ys(y);
  for (uint32_t j = 0; j < ys.count; ++j)
    for (uint32_t i = 0; i < xs.count; ++i) {
      const double x0 = std::floor(xs.at[i]), y0 = std::floor(ys.at[j]), fx = xs.at[i] - x0, fy = ys.at[j] - y0;
      const auto column = static_cast<int64_t>(x0), line = static_cast<int64_t>(y0);
      Range4 lines[2];
      for (int k = 0; k < 2; ++k) {
        Range4 left, right;
        for (uint32_t c = 0; c < 4; ++c)
          left[c] = l.texel(column, line + k, c), right[c] = l.texel(column + 1, line + k, c);
        lines[k] = mixed_levels(left, right, fx);
      }
      widen(all, mixed_levels(lines[0], lines[1], fy));
    }
  return all;
}

Range4 Filter::sampled(uint32_t name, const RangeFootprint& f) const {
  const uint32_t slot = name >> 16;
  if (name == kNoTexture || slot >= kSlots) return {1.0, 1.0, 1.0, 1.0};
  static const Texture white = {.format = Format::rgba8_unorm,
                                .bytes = Bytes(4, std::byte{255})};  // NOLINT: what an unused slot holds
  const Texture& t = slot < textures_.size() ? textures_[slot] : white;
  if (t.format != Format::rgba8_unorm && t.format != Format::rgba8_srgb)
    throw std::logic_error("deferred texturing samples rgba8 textures");
  const uint32_t layer = std::min(name & 0xffffu, t.layers - 1);
  const auto of_level = [&](uint32_t level) {
    const Level l = level_of(t, layer, level);
    return bilinear(l, in_texels(f.u, l.width, device_.sub_texel_bits),
                    in_texels(f.v, l.height, device_.sub_texel_bits));
  };
  // Within a level, and from level to level, the answer is a mixture: extremes lie at the ends and at whole levels.
  const Range detail = level_of_detail(f, t, device_.mipmap_bits);
  const auto first = static_cast<uint32_t>(std::floor(detail.low)),
             last = static_cast<uint32_t>(std::ceil(detail.high));
  Range4 all, previous;
  for (uint32_t level = first; level <= last; ++level) {
    const Range4 here = of_level(level);
    if (level == first) {
      all = here;
      if (detail.low > first) all.fill({kInfinite, -kInfinite});
    } else {
      widen(all, mixed_levels(previous, here, std::max(detail.low - (level - 1), 0.0)));
      widen(all, mixed_levels(previous, here, std::min(detail.high - (level - 1), 1.0)));
    }
    previous = here;
  }
  for (uint32_t c = 0; c < 4; ++c) {
    const bool srgb = t.format == Format::rgba8_srgb && c < 3;
    const double slack = srgb ? kSrgbFilter + kSrgbRelative * all[c].high : kUnormFilter;
    all[c] = rounded({all[c].low - slack, all[c].high + slack});
  }
  return all;
}

}  // namespace assay::deferred_texturing
