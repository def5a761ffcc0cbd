#include "kernels/resolve/curve.h"

#include <cmath>
#include <limits>

#include "kernels/resolve/layout.h"

namespace assay::resolve {
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

}  // namespace assay::resolve
