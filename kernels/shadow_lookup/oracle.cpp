#include "kernels/shadow_lookup/oracle.h"

#include <algorithm>

#include "harness/judged.h"
#include "harness/shadow_oracle.h"

namespace assay::shadow_lookup {

namespace {

constexpr double kDecided = 0.01;
constexpr uint64_t kJudgedReceivers = 1u << 16;

Interval share_of(const Case& c, const shadowing::Map& map, uint32_t taps, const Receiver& r) {
  const auto lights = c.input<LightRecord>("lights");
  if (r.light >= lights.size()) return exactly(1);
  const Ball position = {glm::dvec3(r.position), 0}, normal = {glm::dvec3(r.plane_normal), 0};
  return shadowing::share_of(map, taps, lights[r.light], position, normal, r.dither);
}

// The interval, twice where it is undecided.
Expected filtered_by(const Case& c, const std::vector<uint64_t>& judged, uint32_t taps) {
  const auto p = c.params<LookupParams>();
  const shadowing::Map map = {
      c.input<ShadowView>("shadow_views"), {p.atlas_width, p.atlas_height}, c.input<float>("shadow_depth")};
  const auto receivers = c.input<Receiver>("receivers");
  std::vector<float> low, high;
  Expected e = {.first = {0}, .judged = judged};
  for_each_judged(c, judged, [&](uint64_t i) {
    const Interval share = share_of(c, map, taps, receivers[i]);
    for (int n = share.high - share.low > kDecided ? 2 : 1; n > 0; --n) {
      low.push_back(std::nextafter(static_cast<float>(share.low), -1.0f));
      high.push_back(std::nextafter(static_cast<float>(share.high), 2.0f));
      if (share.low == share.high) low.back() = high.back() = static_cast<float>(share.low);
    }
    e.first.push_back(static_cast<uint32_t>(low.size()));
  });
  e.low = expect_all(low).low, e.high = expect_all(high).low;
  return e;
}

}  // namespace

Answer expected_shares(const Case& c) {
  const auto judged = judged_pixels(c, kJudgedReceivers, JudgedBorders::last);
  return {{"pcf_2x2", filtered_by(c, judged, 2)},
          {"pcf_3x3", filtered_by(c, judged, 3)},
          {"pcf_7x7", filtered_by(c, judged, 7)}};
}

}  // namespace assay::shadow_lookup
