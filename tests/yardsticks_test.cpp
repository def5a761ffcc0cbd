// What the yardsticks say of the device that the tests run on.
#include "harness/report/yardsticks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/run.h"

namespace assay::tests {
namespace {

// kernels/visibility allows cuts 2/255 of filtering, sRGB or not.
TEST(Yardsticks, TheDeviceFiltersAsExactlyAsOraclesAllow) {
  const report::FilterFigure filter = report::measure_filter(*device());
  RecordProperty("linear", fmt::format("{:.3f}/255", filter.linear));
  RecordProperty("alpha of sRGB", fmt::format("{:.3f}/255", filter.srgb_alpha));
  fmt::print("filtering errors: linear textures {:.3f}/255, alpha of sRGB textures {:.3f}/255\n", filter.linear,
             filter.srgb_alpha);
  EXPECT_LE(filter.linear, 2.0);
  EXPECT_LE(filter.srgb_alpha, 2.0);
}

}  // namespace
}  // namespace assay::tests
