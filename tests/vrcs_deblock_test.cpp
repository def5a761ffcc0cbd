// What the deblocker is for: a ramp shaded at any one rate comes out as the ramp.
#include <gtest/gtest.h>

#include <array>

#include "harness/formats/vrcs.h"
#include "harness/half.h"
#include "kernels/vrcs_deblock/inputs.h"
#include "tests/lowered.h"

namespace assay::tests {
namespace {

using vrcs_deblock::Texel;

// Whole numbers that halves hold, and so are their means.
Texel ramp(uint x, uint y, int across, int down) {
  return vrcs_deblock::grey(400 + across * static_cast<int>(x) + down * static_cast<int>(y));
}

void expect_ramp(const std::string& variant, uint rate, uint frame, int across, int down) {
  const Extent e = {71, 53};
  const auto at = [=](uint x, uint y) { return ramp(x, y, across, down); };
  const auto picture = vrcs_deblock::at_rate(vrcs_deblock::painted(e, at), rate, frame);
  const Case c = vrcs_deblock::case_of(picture);
  const Ran r = run_variant(*device(), kernel_named("vrcs_deblock"), variant, c);
  const char* port = variant == "in_place" ? "radiance_in_place" : "deblocked_radiance";
  const auto got = values<Texel>(device::read(*device(), *r.ports.at(port)));
  const auto copied = c.input<Texel>("radiance");
  uint64_t wrong = 0, copies = 0;
  for (uint y = 1; y + 1 < e.height; ++y)  // at the border a duplicate may lack a neighbour
    for (uint x = 1; x + 1 < e.width; ++x) {
      wrong += got[picture.place(x, y)] != at(x, y);
      copies += copied[picture.place(x, y)] != at(x, y);
    }
  EXPECT_EQ(wrong, 0u) << variant << " rate " << rate << " frame " << frame << " ramp " << across << ", " << down;
  EXPECT_EQ(copies != 0, (rate / 4 != 0 && across != 0) || (rate % 4 != 0 && down != 0)) << rate;
}

TEST(VrcsDeblock, RampsAreMended) {
  for (const std::string variant : {"ping_pong", "in_place", "guarded", "guarded_by_triangle"})
    for (const uint rate : {kRate1x1, kRate1x2, kRate2x1, kRate2x2})
      for (const uint frame : {0u, 1u})
        for (const auto& [across, down] : {std::array{3, 0}, {0, -5}, {4, 7}})
          expect_ramp(variant, rate, frame, across, down);
}

}  // namespace
}  // namespace assay::tests
