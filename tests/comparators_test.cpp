// Each comparator accepts what it must and, above all, rejects what it must.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/check/judge.h"

namespace assay::tests {
namespace {

using check::judge;
using check::Verdict;

struct Sample {  // an integer and a float side by side
  uint32_t key;
  float value;
};
const Layout kSample{"Sample", 8, {{"key", 0, 1, Scalar::u32}, {"value", 4, 1, Scalar::f32}}};
const Layout kWord = layout_of<uint32_t>();
const Layout kFloat = layout_of<float>();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr uint32_t kPoison = 0x7fd12345u;

template <class T>
Bytes bytes_of(const std::vector<T>& values) {
  const auto b = std::as_bytes(std::span(values));
  return {b.begin(), b.end()};
}
template <class T>
Verdict compare(const Bound& bound, const Layout& layout, const std::vector<T>& want, const std::vector<T>& got) {
  return judge(bound, {layout}, {.low = bytes_of(want)}, {bytes_of(got)});
}
Verdict compare_floats(const Bound& bound, float want, float got) {
  return compare<float>(bound, kFloat, {want}, {got});
}
template <class T>
uint64_t between_violations(const Layout& layout, const std::vector<T>& low, const std::vector<T>& high,
                            std::vector<uint32_t> first, const std::vector<T>& got) {
  return judge(between({"p"}, ""), {layout}, {bytes_of(low), bytes_of(high), std::move(first)}, {bytes_of(got)})
      .violations;
}

TEST(Comparators, ExactWantsEqualBytesAndNamesTheMember) {
  const std::vector<Sample> want = {{1, 2.0f}, {3, 0.0f}};
  EXPECT_EQ(compare(exact("p", ""), kSample, want, want).violations, 0u);
  const Verdict v = compare(exact("p", ""), kSample, want, {{1, 2.0f}, {3, -0.0f}});
  EXPECT_EQ(v.violations, 1u);
  EXPECT_EQ(v.worst, 1);
  EXPECT_EQ(v.element, 1u);
  EXPECT_EQ(v.first, "element 1: expected .value 0 (0x00000000), got .value -0 (0x80000000)");
}

TEST(Comparators, ExactComparesSmallTexelsAsBytes) {
  Port image = writes_image("p", Format::r8_uint);
  const std::vector<uint8_t> want = {1, 2, 3};
  EXPECT_EQ(compare(exact("p", ""), check::layout_of_port(image), want, want).violations, 0u);
  const Verdict v = compare(exact("p", ""), check::layout_of_port(image), want, {1, 2, 4});
  EXPECT_EQ(v.first, "element 2: expected 0x03, got 0x04");
  EXPECT_THROW(compare(ulps("p", 1, ""), check::layout_of_port(image), want, want), std::logic_error);
}

TEST(Comparators, UlpsCountRepresentableFloats) {
  const std::vector<float> one = {1.0f};
  const float next = std::nextafter(1.0f, 2.0f), after = std::nextafter(next, 2.0f);
  EXPECT_EQ(compare(ulps("p", 1, ""), kFloat, one, {next}).violations, 0u);
  const Verdict v = compare(ulps("p", 1, ""), kFloat, one, {after});
  EXPECT_EQ(v.violations, 1u);
  EXPECT_EQ(v.worst, 2);
  EXPECT_EQ(compare_floats(ulps("p", 1, ""), 0.0f, -0.0f).violations, 0u);
}

TEST(Comparators, UlpsHoldIntegersExactly) {
  const std::vector<Sample> want = {{5, 1.0f}};
  EXPECT_EQ(compare(ulps("p", 100, ""), kSample, want, {{5, 1.0f}}).violations, 0u);
  EXPECT_EQ(compare(ulps("p", 100, ""), kSample, want, {{6, 1.0f}}).violations, 1u);
}

TEST(Comparators, WithinIsAbsolute) {
  EXPECT_EQ(compare_floats(within("p", 0.5, ""), 1.0f, 1.5f).violations, 0u);
  EXPECT_EQ(compare_floats(within("p", 0.5, ""), 1.0f, std::nextafter(1.5f, 2.0f)).violations, 1u);
  EXPECT_EQ(compare(within("p", 100.0, ""), kSample, std::vector<Sample>{{5, 1.0f}}, {{6, 1.0f}}).violations, 1u);
}

TEST(Comparators, NanNeverPasses) {
  constexpr double kAnything = std::numeric_limits<double>::max();
  for (const float want : {1.0f, kNan, kInf}) {
    EXPECT_EQ(compare_floats(ulps("p", kAnything, ""), want, kNan).violations, 1u) << want;
    EXPECT_EQ(compare_floats(within("p", kAnything, ""), want, kNan).violations, 1u) << want;
    EXPECT_EQ(between_violations<float>(kFloat, {-kInf}, {kInf}, {0, 1}, {kNan}), 1u);
  }
  EXPECT_EQ(compare_floats(within("p", kAnything, ""), kNan, 1.0f).violations, 1u);
  EXPECT_EQ(between_violations<float>(kFloat, {kNan}, {kNan}, {0, 1}, {1.0f}), 1u);
  EXPECT_TRUE(std::isinf(compare_floats(ulps("p", 1, ""), 1.0f, kNan).worst));
}

TEST(Comparators, InfinityIsNoNeighbourOfTheLargestFloat) {
  EXPECT_EQ(compare_floats(ulps("p", 4, ""), std::numeric_limits<float>::max(), kInf).violations, 1u);
  EXPECT_EQ(compare_floats(ulps("p", 4, ""), kInf, kInf).violations, 0u);
  EXPECT_EQ(compare_floats(ulps("p", 4, ""), kInf, -kInf).violations, 1u);
}

TEST(Comparators, SameSetIgnoresOrderButNotMultiplicity) {
  const std::vector<uint32_t> want = {1, 2, 2, 3};
  EXPECT_EQ(compare(same_set("p", ""), kWord, want, {3, 2, 1, 2}).violations, 0u);
  const Verdict v = compare(same_set("p", ""), kWord, want, {3, 3, 1, 2});
  EXPECT_EQ(v.violations, 1u);
  EXPECT_EQ(v.first, "elements 0 to 3 as a set: expected 2, got 3; 1 of 4 differ");
}

TEST(Comparators, BitsAreRequiredAllowedOrForbidden) {
  const auto verdict = [](uint32_t got) {
    return judge(bits("p", ""), {kWord}, {bytes_of<uint32_t>({7, 0b0011}), bytes_of<uint32_t>({7, 0b0111})},
                 {bytes_of<uint32_t>({7, got})});
  };
  for (const uint32_t fine : {0b0011u, 0b0111u}) EXPECT_EQ(verdict(fine).violations, 0u) << fine;
  EXPECT_EQ(verdict(0b0011).judged, 64u);
  EXPECT_EQ(verdict(0b0011).undecided, 1u);
  for (const uint32_t wrong : {0b0001u, 0b0110u, 0b1011u, 0u}) EXPECT_EQ(verdict(wrong).violations, 1u) << wrong;
  const Verdict v = verdict(0b1000'0001);
  EXPECT_EQ(v.element, 1u);
  EXPECT_EQ(v.worst, 2);
}

TEST(Comparators, SameSetTakesEveryOrderAndNoChange) {
  EXPECT_TRUE(
      rc::check("a shuffled set passes, one changed element fails", [](std::vector<uint32_t> want, uint32_t at) {
        RC_PRE(!want.empty());
        std::vector<uint32_t> got = want;
        std::ranges::sort(got);
        RC_ASSERT(compare(same_set("p", ""), kWord, want, got).violations == 0);
        got[at % got.size()] ^= 1u << at % 32;
        RC_ASSERT(compare(same_set("p", ""), kWord, want, got).violations == 1);
      }));
}

TEST(Comparators, SameSetKeepsRunsApart) {
  Expected expected{.low = bytes_of<uint32_t>({1, 2, 3, 4})};
  expected.live = {{0, 2}, {3, 2}};
  const auto verdict = [&](const std::vector<uint32_t>& got) {
    return judge(same_set("p", ""), {kWord}, expected, {bytes_of(got)}).violations;
  };
  EXPECT_EQ(verdict({2, 1, kPoison, 4, 3}), 0u);
  EXPECT_EQ(verdict({1, 3, kPoison, 2, 4}), 2u);
}

TEST(Comparators, BetweenTakesAnyOneAlternativeWhole) {
  const std::vector<Sample> low = {{1, 0.0f}, {2, 5.0f}}, high = {{1, 1.0f}, {2, 6.0f}};
  EXPECT_EQ(between_violations<Sample>(kSample, low, high, {0, 2}, {{1, 0.5f}}), 0u);
  EXPECT_EQ(between_violations<Sample>(kSample, low, high, {0, 2}, {{2, 5.5f}}), 0u);
  EXPECT_EQ(between_violations<Sample>(kSample, low, high, {0, 2}, {{1, 5.5f}}), 1u);  // half of each
  EXPECT_EQ(between_violations<Sample>(kSample, low, high, {0, 2}, {{1, 1.5f}}), 1u);
}

TEST(Comparators, BetweenComparesIntegersByTheirSign) {
  const Layout sign{"", 4, {{"", 0, 1, Scalar::i32}}};
  EXPECT_EQ(between_violations<int32_t>(sign, {-2}, {1}, {0, 1}, {-1}), 0u);
  EXPECT_EQ(between_violations<uint32_t>(kWord, {0}, {1}, {0, 1}, {0xffffffffu}), 1u);
}

TEST(Comparators, BetweenCountsUndecided) {
  const auto undecided = [](const Sample& low, const Sample& high) {
    return judge(between({"p"}, ""), {kSample}, {bytes_of<Sample>({low}), bytes_of<Sample>({high}), {0, 1}},
                 {bytes_of<Sample>({low})})
        .undecided;
  };
  EXPECT_EQ(undecided({1, 0.0f}, {1, 0.0f}), 0u);
  EXPECT_EQ(undecided({1, 0.0f}, {1, 1.0f}), 0u);  // a rounding interval
  EXPECT_EQ(undecided({1, 0.0f}, {2, 0.0f}), 1u);
  const Verdict two =
      judge(between({"p"}, ""), {kWord}, {bytes_of<uint32_t>({1, 2}), bytes_of<uint32_t>({1, 2}), {0, 2}},
            {bytes_of<uint32_t>({2})});
  EXPECT_EQ(two.undecided, 1u);
  EXPECT_EQ(two.violations, 0u);
}

TEST(Comparators, BetweenJoinsPortsAndJudgesSomeElements) {
  Expected expected{bytes_of<Sample>({{7, 1.0f}}), bytes_of<Sample>({{7, 2.0f}}), {0, 1}, {1}};
  const Bound bound = between({"a", "b"}, "");
  const auto verdict = [&](uint32_t key, float value) {
    return judge(bound, {kWord, kFloat}, expected, {bytes_of<uint32_t>({99, key}), bytes_of<float>({-1, value})});
  };
  EXPECT_EQ(verdict(7, 1.5f).violations, 0u);
  EXPECT_EQ(verdict(7, 1.5f).judged, 1u);
  EXPECT_EQ(verdict(8, 1.5f).violations, 1u);
  EXPECT_EQ(verdict(7, 2.5f).worst, 0.5);
}

TEST(Comparators, UnpackedFieldsAreJudgedEachByItsType) {
  Bound bound = within("p", 1, "");
  bound.unpack = Unpack{Layout{"", 8, {{"low", 0, 1, Scalar::f32}, {"high", 4, 1, Scalar::u32}}}, [](auto packed) {
                          std::vector<Sample> out;
                          (void)packed;
                          out.push_back({0x3f800000u, 0.0f});  // low is 1, high is 0
                          return bytes_of(out);
                        }};
  const auto verdict = [&](float low, uint32_t high) {
    struct Fields {
      float low;
      uint32_t high;
    };
    return judge(bound, {kWord}, {.low = bytes_of<Fields>({{low, high}})}, {bytes_of<uint32_t>({0})}).violations;
  };
  EXPECT_EQ(verdict(1.5f, 0), 0u);
  EXPECT_EQ(verdict(2.5f, 0), 1u);
  EXPECT_EQ(verdict(1.5f, 1), 1u);
}

TEST(Comparators, AnswersThatDoNotFitAreTheOraclesFault) {
  const std::vector<uint32_t> two = {1, 2};
  EXPECT_THROW(compare(exact("p", ""), kWord, std::vector<uint32_t>{1, 2, 3}, two), std::logic_error);
  EXPECT_THROW(compare(same_set("p", ""), kWord, std::vector<uint32_t>{1}, two), std::logic_error);
  Expected beyond{.low = bytes_of(two)};
  beyond.live = {{1, 2}};
  EXPECT_THROW(judge(exact("p", ""), {kWord}, beyond, {bytes_of(two)}), std::logic_error);
  const Expected none{bytes_of(two), bytes_of(two), {0, 0, 2}};
  EXPECT_THROW(judge(between({"p"}, ""), {kWord}, none, {bytes_of(two)}), std::logic_error);
}

TEST(Comparators, MisuseFindsUnwrittenAndTouchedElements) {
  Expected all{.low = {}};
  EXPECT_EQ(check::misuse(kSample, all, bytes_of<uint32_t>({1, 2, 3, 4}), kPoison), "");
  EXPECT_EQ(check::misuse(kSample, all, bytes_of<uint32_t>({1, 2, 3, kPoison}), kPoison), "element 1 was not written");
  Expected some{.low = {}};
  some.live = {{1, 1}};
  EXPECT_EQ(check::misuse(kWord, some, bytes_of<uint32_t>({kPoison, 2, kPoison}), kPoison), "");
  EXPECT_EQ(check::misuse(kWord, some, bytes_of<uint32_t>({kPoison, 2, 3}), kPoison), "element 2 was written");
  EXPECT_EQ(check::misuse(kSample, some, bytes_of<uint32_t>({kPoison, 1, 2, 3}), kPoison), "element 0 was written");
}

}  // namespace
}  // namespace assay::tests
