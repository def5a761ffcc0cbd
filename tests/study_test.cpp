// The study of variable rates says what it measured: pictures whose figures are known, and planted ones.
#include "harness/study/study.h"

#include <gtest/gtest.h>

#include "harness/half.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

using namespace study;

Picture flat(Extent e) {
  return {.input_class = "flat",
          .name = "grey",
          .size = e,
          .radiance = std::vector<Texel>(pixel_count(e), {0x3400, 0x3400, 0x3400, 0x3c00})};
}
void untold(uint64_t, uint64_t) {}

TEST(Study, AFlatPictureIsSavedThreeQuartersOf) {
  const auto outcomes = try_all(*device(), flat({32, 48}), choices({"sobel_2", "first_difference_8"}), untold);
  EXPECT_EQ(outcomes.size(), 2u * 3 * 5 * 3);
  for (const Outcome& o : outcomes) {
    EXPECT_EQ(o.errors.saved, 0.75) << label_of(o.choice);
    EXPECT_EQ(o.errors.flip_copied, 0);
    EXPECT_EQ(o.errors.square_deblocked, 0);
  }
}

// Columns by turns: half rates down save half and cost nothing, all other sharing costs all of it.
TEST(Study, StripesAreSavedHalfOf) {
  Picture p = flat({32, 32});
  for (size_t i = 0; i < p.radiance.size(); i += 2) p.radiance[i] = {0, 0, 0, 0x3c00};
  for (const Outcome& o : try_all(*device(), p, choices({"second_difference_2"}), untold)) {
    if (o.motion != 0) continue;
    EXPECT_EQ(o.errors.saved, 0.5) << label_of(o.choice);
    EXPECT_EQ(o.errors.flip_deblocked, 0);
  }
}

TEST(Study, TheDeblockerMendsARamp) {
  Picture p = flat({64, 64});
  for (size_t i = 0; i < p.radiance.size(); ++i) {
    const uint16_t h = nearest_half(0.1 + static_cast<double>(i % 64) / 256);
    p.radiance[i] = {h, h, h, 0x3c00};
  }
  Chain chain = make_chain(*device(), p);
  const Shaded s = shade(chain, {"second_difference_8", 0.05f});
  EXPECT_EQ(s.saved, 0.75);
  for (size_t i = 0; i < p.radiance.size(); ++i) {
    if (i % 64 == 0 || i % 64 == 63 || i < 64 || i >= size_t{63} * 64)
      continue;  // copies at the sides may lack a neighbour
    EXPECT_NEAR(half_value(s.deblocked[i][0]), half_value(p.radiance[i][0]), half_step(0.3)) << i;
  }
  EXPECT_NE(s.copied, p.radiance);
}

Outcome planted(const std::string& input_class, const std::string& estimator, double saved, double flip,
                size_t motion = 0) {
  return {input_class, "", motion, {estimator, 0.01f}, {.saved = saved, .flip_deblocked = flip}};
}

TEST(Study, TheFrontIsWhatNothingBeats) {
  const auto rows = rows_of({planted("a", "good", 0.5, 0.01), planted("a", "worse", 0.5, 0.02),
                             planted("a", "dear", 0.2, 0.001), planted("b", "worse", 0.5, 0.02)});
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_TRUE(rows[0].in_front);
  EXPECT_FALSE(rows[1].in_front);
  EXPECT_TRUE(rows[2].in_front);
  EXPECT_TRUE(rows[3].in_front) << "another class";
}

TEST(Study, TheBestPassesInEveryClassAndMotion) {
  std::vector<Outcome> outcomes = {planted("a", "careful", 0.3, 0.01), planted("b", "careful", 0.3, 0.01),
                                   planted("a", "bold", 0.9, 0.01), planted("b", "bold", 0.9, 0.02, 2)};
  EXPECT_EQ(best_of(rows_of(outcomes))->estimator, "bold") << "0.02 passes";
  outcomes.back().errors.flip_deblocked = 0.0201;
  EXPECT_EQ(best_of(rows_of(outcomes))->estimator, "careful");
  for (Outcome& o : outcomes) o.errors.flip_deblocked = NAN;
  EXPECT_FALSE(best_of(rows_of(outcomes)));
}

}  // namespace
}  // namespace assay::tests
