#include "harness/filter_oracle.h"

namespace assay {

namespace {

constexpr double kUnorm = 1.0 / 255;
// Texels may be filtered in their own 8 bits, truncated once a lerp, of which there are three. An sRGB texel's linear
// value needs steps of 1 / (255 * 12.92) to be told from its neighbours at all; where it is larger, it may be held as a
// half, truncated once when it is decoded and once a lerp.
constexpr double kUnormFilter = 3 * kUnorm, kSrgbFilter = 3 * kUnorm / 12.92, kSrgbRelative = 4 * 0x1p-10;
// Or the eight texels' weights are multiplied out first and each rounded to a step of the weights, as an H100 does:
// they still add up to 1, so what is off is half of 8 half steps at most, of the texels' range. Below kUnormFilter.
constexpr double kWeightSteps = 8 * 0.5 / 2;
constexpr double kWidest = 8;  // texels a side that are searched; beyond, the whole layer's range is taken
constexpr Interval kNothing = {bounded::kInfinite, -bounded::kInfinite};

double linear_of(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
// Half a code either way, on the sRGB side (the tolerance of Direct3D 11; Vulkan names none).
const std::array<Interval, 256>& srgb_table() {
  static const std::array<Interval, 256> table = [] {
    std::array<Interval, 256> t;
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
  explicit Stops(Interval r) {
    at[count++] = r.low;
    for (double i = std::floor(r.low) + 1; i < r.high; ++i) at[count++] = i;
    if (r.high > r.low) at[count++] = r.high;
  }
};

// In texels of a level, texel centres at integers: product and shift 3u, and a step of the weights.
Interval in_texels(Interval coordinate, uint32_t size, uint32_t sub_texel_bits) {
  const double low = coordinate.low * size, high = coordinate.high * size;
  const double error = 3 * kUnitRoundoff * (std::max(std::fabs(low), std::fabs(high)) + 1) +
                       std::ldexp(1.0, -static_cast<int>(sub_texel_bits));
  return {low - 0.5 - error, high - 0.5 + error};
}

Intervals4 weighed(const Intervals4& a, const Intervals4& b, double weight) {
  Intervals4 m;
  for (uint32_t c = 0; c < 4; ++c)
    m[c] = {a[c].low + (b[c].low - a[c].low) * weight, a[c].high + (b[c].high - a[c].high) * weight};
  return m;
}
void widen(Intervals4& to, const Intervals4& by) {
  for (uint32_t c = 0; c < 4; ++c) to[c] = hull(to[c], by[c]);
}
Intervals4 nothing() {
  Intervals4 n;
  n.fill(kNothing);
  return n;
}

}  // namespace

TextureFilter::TextureFilter(const Texture& t, const DeviceTraits& d) : texture_(&t), device_(d) {
  if (t.format != Format::rgba8_unorm && t.format != Format::rgba8_srgb && block_side(t.format) == 1)
    throw std::logic_error(std::string("the oracle filters no ") + name_of(t.format));
}

Interval TextureFilter::on_levels(double low, double high) const {
  const double step = 2 * std::ldexp(1.0, -static_cast<int>(device_.mipmap_bits)), last = texture_->levels - 1;
  return {std::clamp(low - step, 0.0, last), std::clamp(high + step, 0.0, last)};
}

Interval TextureFilter::level_of(const TexelDerivatives& d) const {
  const Interval ux = absolute(d.u_dx), vx = absolute(d.v_dx), uy = absolute(d.u_dy), vy = absolute(d.v_dy);
  return on_levels(std::log2(std::max({ux.low, vx.low, uy.low, vy.low})),
                   std::log2(std::sqrt(2.0) * std::max(ux.high + vx.high, uy.high + vy.high)));
}
Interval TextureFilter::level_of(Interval level) const { return on_levels(level.low, level.high); }

Interval TextureFilter::Level::texel(int64_t x, int64_t y, uint32_t channel) const {
  const uint64_t at = (wrapped(y, height) * width + wrapped(x, width)) * 4 + channel;
  const auto least = std::to_integer<uint32_t>(low[at]), most = std::to_integer<uint32_t>(high[at]);
  if (is_srgb && channel < 3) return hull(srgb_table()[least], srgb_table()[most]);
  return {least * kUnorm, most * kUnorm};
}

TextureFilter::Level TextureFilter::level(uint32_t wanted, uint32_t n) const {
  const uint32_t layer = std::min(wanted, texture_->layers - 1);
  Level l = {nullptr, nullptr, width_of(*texture_, n), height_of(*texture_, n), is_srgb(texture_->format)};
  if (block_side(texture_->format) == 1) {
    l.low = l.high = texture_->bytes.data() + offset_of(*texture_, n, layer);
    return l;
  }
  const auto [it, is_new] = decoded_.try_emplace({layer, n});
  if (is_new) it->second = decoded_level(*texture_, layer, n);
  l.low = it->second.low.data(), l.high = it->second.high.data();
  return l;
}

Intervals4 TextureFilter::whole(const Level& l) const {
  const auto [it, is_new] = whole_.try_emplace(l.low);
  if (!is_new) return it->second;
  for (uint32_t c = 0; c < 4; ++c) {
    Interval r = kNothing;
    for (uint32_t y = 0; y < l.height; ++y)
      for (uint32_t x = 0; x < l.width; ++x) r = hull(r, l.texel(x, y, c));
    it->second[c] = r;
  }
  return it->second;
}

TextureFilter::Filtered TextureFilter::bilinear(const Level& l, Interval x, Interval y) const {
  if (!(x.high - x.low < kWidest) || !(y.high - y.low < kWidest)) return {whole(l), whole(l)};
  Filtered all = {nothing(), nothing()};
  const Stops xs(x), ys(y);
  for (uint32_t j = 0; j < ys.count; ++j)
    for (uint32_t i = 0; i < xs.count; ++i) {
      const double x0 = std::floor(xs.at[i]), y0 = std::floor(ys.at[j]);
      const auto column = static_cast<int64_t>(x0), line = static_cast<int64_t>(y0);
      Intervals4 lines[2];
      for (int k = 0; k < 2; ++k) {
        Intervals4 left, right;
        for (uint32_t c = 0; c < 4; ++c)
          left[c] = l.texel(column, line + k, c), right[c] = l.texel(column + 1, line + k, c);
        widen(all.texels, left), widen(all.texels, right);
        lines[k] = weighed(left, right, xs.at[i] - x0);
      }
      widen(all.value, weighed(lines[0], lines[1], ys.at[j] - y0));
    }
  return all;
}

// Within a level, and from level to level, the answer is a mixture: extremes lie at the ends and at whole levels.
Intervals4 TextureFilter::sampled(uint32_t layer, Interval u, Interval v, Interval detail) const {
  const auto of_level = [&](uint32_t n) {
    const Level l = level(layer, n);
    return bilinear(l, in_texels(u, l.width, device_.sub_texel_bits), in_texels(v, l.height, device_.sub_texel_bits));
  };
  const auto first = static_cast<uint32_t>(std::floor(detail.low)),
             last = static_cast<uint32_t>(std::ceil(detail.high));
  Intervals4 all, previous, texels = nothing();
  for (uint32_t n = first; n <= last; ++n) {
    const auto [here, of_here] = of_level(n);
    widen(texels, of_here);
    if (n == first) {
      all = detail.low > first ? nothing() : here;
    } else {
      widen(all, weighed(previous, here, std::max(detail.low - (n - 1), 0.0)));
      widen(all, weighed(previous, here, std::min(detail.high - (n - 1), 1.0)));
    }
    previous = here;
  }
  for (uint32_t c = 0; c < 4; ++c) {
    const double weights =
        std::ldexp(kWeightSteps, -static_cast<int>(device_.sub_texel_bits)) * (texels[c].high - texels[c].low);
    const double slack = is_srgb(texture_->format) && c < 3
                             ? std::max(kSrgbFilter, weights) + kSrgbRelative * all[c].high
                             : kUnormFilter;
    all[c] = bounded::rounded({all[c].low - slack, all[c].high + slack}, 1);
  }
  return all;
}

}  // namespace assay
