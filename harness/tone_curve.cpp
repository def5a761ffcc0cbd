#include "harness/tone_curve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "harness/formats/exposure.h"

namespace assay {
namespace {

double decoded(double encoded) {  // IEC 61966-2-1
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// The positive root of x (2.51 x + 0.03) = y (x (2.43 x + 0.59) + 0.14).
double exposed_from(double y) {
  const double a = 2.51 - 2.43 * y, b = 0.03 - 0.59 * y, c = -0.14 * y, root = std::sqrt(b * b - 4 * a * c);
  return b > 0 ? -2 * c / (b + root) : (root - b) / (2 * a);
}

}  // namespace

std::vector<float> code_thresholds() {
  std::vector<float> thresholds(kCodes, 0.0f);
  for (uint32_t k = 1; k < kCodes; ++k) {
    const double exact = exposed_from(decoded((k - 0.5) / 255));
    const auto nearest = static_cast<float>(exact);
    thresholds[k] = double{nearest} < exact ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
  }
  return thresholds;
}

std::vector<uint32_t> bucket_codes(const std::vector<float>& thresholds) {
  std::vector<uint32_t> codes;
  for (uint32_t b = 0; b < kBuckets; ++b) {
    const auto least = std::bit_cast<float>((kFirstBucket + b) << kBucketShift);
    codes.push_back(static_cast<uint32_t>(std::ranges::upper_bound(thresholds, least) - thresholds.begin()) - 1);
  }
  return codes;
}

// Narkowicz 2015, then IEC 61966-2-1.
double displayed(double radiance, float exposure) {
  const double x = static_cast<float>(radiance * double{exposure});  // the one rounding of the shader
  if (!(x > 0)) return 0;
  if (x > 1e9) return 1;
  const double curve = std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
  return curve <= 0.0031308 ? 12.92 * curve : 1.055 * std::pow(curve, 1 / 2.4) - 0.055;
}

uint32_t code_of(double radiance, float exposure) {
  return static_cast<uint32_t>(std::floor(255 * displayed(radiance, exposure) + 0.5));
}

double radiance_of(double shown) { return exposed_from(decoded(shown)); }

}  // namespace assay
