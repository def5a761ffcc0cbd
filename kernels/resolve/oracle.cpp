#include "kernels/resolve/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/bounded.h"
#include "harness/half.h"
#include "harness/tone_curve.h"
#include "kernels/resolve/layout.h"

namespace assay::resolve {

namespace {

constexpr double u = kUnitRoundoff;
constexpr uint64_t kJudgedPixels = 1u << 16;

struct Texel {
  uint16_t red, green, blue, alpha;
};

const std::vector<double>& half_values() {
  static const std::vector<double> values = [] {
    std::vector<double> v(65536);
    for (uint32_t i = 0; i < v.size(); ++i) v[i] = half_value(static_cast<uint16_t>(i));
    return v;
  }();
  return values;
}

// Over the pixels that count.
struct Sums {
  long double luminance = 0, log2_luminance = 0, log2_magnitudes = 0;
  uint32_t counted = 0;
};

Sums sums_of(std::span<const Texel> texels) {
  const std::vector<double>& value = half_values();
  Sums s;
  for (const Texel& t : texels) {
    const double r = value[t.red], g = value[t.green], b = value[t.blue];
    if (!(value[t.alpha] > 0) || !std::isfinite(r + g + b)) continue;
    const double luminance = double{kLuminanceRed} * std::max(r, 0.0) + double{kLuminanceGreen} * std::max(g, 0.0) +
                             double{kLuminanceBlue} * std::max(b, 0.0);
    const double log = std::log2(std::max(luminance, double{kLeastLuminance}));
    s.luminance += luminance, s.log2_luminance += log, s.log2_magnitudes += std::fabs(log), ++s.counted;
  }
  return s;
}

// Additions that a value goes through: 7 and 7 in a thread's 8x8 pixels, 8 levels of a group's tree, one less than the
// blocks a thread of the last pass, its tree's 8. Adding to nothing rounds nothing.
double additions(Extent e) {
  const uint64_t blocks = pixel_count(tiles_of(e, kBlockPixels));
  const uint64_t blocks_a_thread = (blocks + 255) / 256;
  return 7 + 7 + 8 + static_cast<double>(blocks_a_thread - 1) + 8;
}

Interval around(double value, double error) {
  return {value - error * bounded::kSlack, value + error * bounded::kSlack};
}

Interval mean_of(const Interval& sum, uint32_t counted) {
  return sum / bounded::rounded(exactly(counted), counted > 1u << 24 ? 1 : 0);
}

// Vulkan's table: exp2 is within (3 + 2 |x|) ulp, an ulp being 2u at most.
Interval exp2_of(const Interval& x) {
  const auto error = [](double at) { return 2 * (3 + 2 * std::fabs(at)); };
  return {bounded::rounded(exactly(std::exp2(x.low)), error(x.low)).low,
          bounded::rounded(exactly(std::exp2(x.high)), error(x.high)).high};
}

struct Found {
  Interval sum, mean, exposure;
  uint32_t counted = 0;
};

Found found(const Case& c, std::span<const Texel> texels) {
  const auto p = c.params<ResolveParams>();
  if (p.metering == kMeterManual) return {.exposure = exactly(p.manual_exposure) * exactly(p.compensation)};
  const Sums s = sums_of(texels);
  Found f = {.counted = s.counted};
  if (p.metering == kMeterMean) {
    const auto sum = static_cast<double>(s.luminance);
    f.sum = around(sum, (3 + additions(c.extent)) * u * sum);  // 3: the weighting's products and sums
    f.mean = mean_of(f.sum, s.counted);
  } else {
    // A logarithm: the luminance's 3u, then 3 ulp of it (an ulp is 2u of the value at most), or 2^-21 between 1/2
    // and 2.
    const auto sum = static_cast<double>(s.log2_luminance), magnitudes = static_cast<double>(s.log2_magnitudes);
    const double each = 3 * u / std::log(2.0) + 0x1p-21;
    f.sum = around(sum, s.counted * each + (6 + additions(c.extent)) * u * magnitudes);
    f.mean = exp2_of(mean_of(f.sum, s.counted));
  }
  if (s.counted == 0) f.sum = exactly(0), f.mean = exactly(kMiddleGrey);
  f.exposure = exactly(kMiddleGrey) / clamped(f.mean, kLeastMean, kGreatestMean) * exactly(p.compensation);
  return f;
}

float float_at_least(double v) {
  const auto f = static_cast<float>(v);
  return double{f} < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}
float float_at_most(double v) { return -float_at_least(-v); }

// An element of the port, twice: what it may be at least and at most.
Expected expected_exposure(const Found& f) {
  Expected e = expect_all(std::vector<ExposureRecord>{
      {float_at_most(f.sum.low), f.counted, float_at_most(f.mean.low), float_at_most(f.exposure.low)}});
  e.high = expect_all(std::vector<ExposureRecord>{{float_at_least(f.sum.high), f.counted, float_at_least(f.mean.high),
                                                   float_at_least(f.exposure.high)}})
               .low;
  e.first = {0, 1};
  return e;
}

glm::uvec4 codes_of(const Texel& t, float exposure) {
  const std::vector<double>& value = half_values();
  return {code_of(value[t.red], exposure), code_of(value[t.green], exposure), code_of(value[t.blue], exposure), 255};
}

Expected expected_image(const Case& c, const Found& f, std::span<const Texel> texels) {
  const float lowest = float_at_least(f.exposure.low), highest = std::max(lowest, float_at_most(f.exposure.high));
  std::vector<glm::uvec4> low, high;
  Expected e;
  e.first = {0};
  const bool all = c.judge_all || texels.size() <= kJudgedPixels;
  const uint64_t stride = all ? 1 : texels.size() / kJudgedPixels | 1;  // odd, so that rows differ
  for (uint64_t i = 0; i < texels.size(); i += stride) {
    // The higher exposure gives the higher codes, for radiance below 0 gives 0.
    low.push_back(codes_of(texels[i], lowest)), high.push_back(codes_of(texels[i], highest));
    e.first.push_back(static_cast<uint32_t>(low.size()));
    if (!all) e.judged.push_back(i);
  }
  e.low = expect_all(low).low, e.high = expect_all(high).low;
  return e;
}

}  // namespace

Layout codes_layout() { return {"", 16, {{"red_green_blue_alpha", 0, 4, Scalar::u32}}}; }

Bytes unpack_codes(std::span<const std::byte> pixels) {
  std::vector<uint32_t> codes;
  codes.reserve(pixels.size());
  for (const std::byte b : pixels) codes.push_back(std::to_integer<uint32_t>(b));
  const auto bytes = std::as_bytes(std::span(codes));
  return {bytes.begin(), bytes.end()};
}

Answer expected(const Case& c) {
  const auto texels = c.input<Texel>("radiance");
  const Found f = found(c, texels);
  return {{"exposure", expected_exposure(f)}, {"image", expected_image(c, f, texels)}};
}

}  // namespace assay::resolve
