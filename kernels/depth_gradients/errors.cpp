// How far what is stored is off the plane's exact gradient, by kinds of surface.
#include <algorithm>

#include "harness/half.h"
#include "kernels/depth_gradients/inputs.h"
#include "kernels/depth_gradients/oracle.h"

namespace assay::depth_gradients {

namespace {

constexpr Extent kExtent = {256, 256};

// A position moves by w (across - ray * gradient) a pixel, across about 2 / width long: an error of the gradient as a
// share of the longer of both, along the worse axis.
double share(const dvec2& got, const dvec2& want) {
  const dvec2 off = glm::abs(got - want), scale = glm::abs(want) + 2.0 / kExtent.width;
  return std::max(off.x / scale.x, off.y / scale.y);
}

std::vector<Figure> figures(const Variant&, const Case& c, const std::map<std::string, Bytes>& written) {
  std::vector<double> shares;
  for (uint64_t i = 0; i < pixels(c); ++i) {
    const auto want = exact_gradient(c, i);
    std::array<uint16_t, 2> halves;
    std::memcpy(&halves, &written.at("gradients")[i * 4], sizeof halves);
    if (want) shares.push_back(share({half_value(halves[0]), half_value(halves[1])}, *want));
  }
  std::ranges::sort(shares);
  const auto quantile = [&](double q) {
    return shares.empty() ? 0 : shares[static_cast<size_t>(q * static_cast<double>(shares.size() - 1))];
  };
  return {{"median, share", quantile(0.5)}, {"p99, share", quantile(0.99)}, {"greatest, share", quantile(1)}};
}

// Planes in squares of `side` pixels, each by two triangles, at depths from 2 m to 50 m.
Case squares(uint32_t side, double w_low, double w_high, double steep) {
  Picture p(kExtent);
  p.add_surface();
  Pcg32 rng(11);
  for (uint32_t y = 0; y < kExtent.height; y += side)
    for (uint32_t x = 0; x < kExtent.width; x += side) {
      const Plane plane = {{x + 0.5 * side, y + 0.5 * side},
                           w_low * std::pow(w_high / w_low, rng.unit()),
                           dvec2(rng.range(-1, 1), rng.range(-1, 1)) * steep};
      const dvec2 low(x, y), high(x + side, y + side);
      const uint32_t first = p.add_triangle(plane, {low, dvec2(low.x, high.y), dvec2(high.x, low.y)}),
                     second = p.add_triangle(plane, {high, dvec2(low.x, high.y), dvec2(high.x, low.y)});
      for (uint32_t j = 0; j < side; ++j)
        for (uint32_t i = 0; i < side; ++i) p.show(x + i, y + j, i + j + 1 < side ? first : second, plane);
    }
  return p.to_case();
}
Case floor_to_the_horizon() {
  Picture p(kExtent);
  p.add_surface();
  const Plane floor = {{128, 256}, 1.5, {0, 1 / 128.0}};
  const uint32_t triangle = p.add_triangle(floor, {dvec2(-9000, 129), dvec2(9000, 129), dvec2(128, 900)});
  for (uint32_t y = 129; y < kExtent.height; ++y)
    for (uint32_t x = 0; x < kExtent.width; ++x) p.show(x, y, triangle, floor);
  return p.to_case();
}

}  // namespace

ErrorTable error_table() {
  return {.classes = {{"walls", "planes of 64 pixels, gentle", [] { return squares(64, 2, 50, 0.003); }},
                      {"pieces", "planes of 8 pixels, a step in depth at each side",
                       [] { return squares(8, 2, 50, 0.01); }},
                      {"grains", "planes of 2 pixels", [] { return squares(2, 2, 50, 0.05); }},
                      {"floor", "from under the eye to the horizon", floor_to_the_horizon},
                      {"far", "planes of 64 pixels at 1e5 to 1e6 m", [] { return squares(64, 1e5, 1e6, 0.003); }}},
          .figures = figures};
}

}  // namespace assay::depth_gradients
