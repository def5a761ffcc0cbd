// Generators that starve a branch are told off; shrinking ends at the smallest case that still fails; poison is poison.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/check/cases.h"
#include "harness/check/kernel_run.h"
#include "harness/check/run_case.h"
#include "harness/check/shrink.h"

namespace assay::tests {
namespace {

using check::Coverage;

Coverage sound() { return {.trials = 1000, .wide = 300, .large = 50, .branches = {{"even", 990}, {"odd", 10}}}; }

std::vector<std::string> complaints(const Coverage& c) { return check::complaints(c, {"even", "odd"}); }

TEST(Trials, CoverageAtItsLimitsPasses) { EXPECT_TRUE(complaints(sound()).empty()); }

TEST(Trials, StarvedBranchesAreNamed) {
  Coverage c = sound();
  c.branches["odd"] = 9;
  EXPECT_EQ(complaints(c), std::vector<std::string>{"branch odd fired in 9 of 1000 trials, under 1 %"});
  c.branches.erase("odd");
  EXPECT_EQ(complaints(c).size(), 1u);
}

TEST(Trials, SmallTrialsAreNotEnough) {
  Coverage c = sound();
  c.wide = 299;
  EXPECT_EQ(complaints(c), std::vector<std::string>{"299 of 1000 trials span over 4 tiles a side, under 30 %"});
  c = sound();
  c.large = 49;
  EXPECT_EQ(complaints(c), std::vector<std::string>{"49 of 1000 trials hold over 100,000 items, under 5 %"});
}

TEST(Trials, EveryGeneratorIsSound) {
  for (const Kernel& kernel : all_kernels()) {
    Coverage coverage;
    for (uint64_t seed = 0; seed < 1000; ++seed) note(coverage, check::random_case(kernel, seed));
    EXPECT_EQ(check::complaints(coverage, kernel.inputs.branches), std::vector<std::string>{}) << kernel.name;
  }
}

TEST(Trials, FewTrialsProveNothingButUndeclaredBranchesDo) {
  Coverage c{.trials = 10, .branches = {{"even", 10}}};
  EXPECT_TRUE(complaints(c).empty());
  c.branches["sideways"] = 1;
  EXPECT_EQ(complaints(c),
            std::vector<std::string>{"the generator took branch sideways, which inputs.branches does not declare"});
}

TEST(Trials, SizesAreNoted) {
  Coverage c;
  check::note(c, {.items = uint64_t{129} * 129, .wide = true, .taken = {"odd"}});
  check::note(c, {.items = 128000, .taken = {"odd"}});
  EXPECT_EQ(c.trials, 2u);
  EXPECT_EQ(c.wide, 1u);
  EXPECT_EQ(c.large, 1u);
  EXPECT_EQ(c.branches.at("odd"), 2u);
}

check::Trial trial_of(std::vector<Port> ports, Extent extent) {
  Kernel kernel{.name = "k", .ports = std::move(ports)};
  kernel.inputs.random = [extent](Random&) { return Case{.extent = extent}; };
  return check::random_case(kernel, 77);
}

TEST(Trials, ItemsArePixelsOrTheLongestBuffer) {
  const check::Trial trial = trial_of({reads<glm::uvec4>("list", fixed(20)), writes<uint32_t>("out", pixels)}, {3, 5});
  EXPECT_EQ(trial.items, 20u);
  EXPECT_EQ(trial.input.seed, 77u);
  EXPECT_EQ(trial.input.name, "seed77");
}

TEST(Trials, OfAScreenBothSidesAreWideElseItsItemsAreMany) {
  const Port screen = reads_image("depth", Format::d32_float), list = writes<uint32_t>("out", pixels);
  EXPECT_TRUE(trial_of({screen}, {129, 129}).wide);
  EXPECT_FALSE(trial_of({screen, list}, {20000, 128}).wide);
  EXPECT_TRUE(trial_of({list}, {16385, 1}).wide);
  EXPECT_FALSE(trial_of({list}, {16384, 1}).wide);
}

Kernel list_kernel() {
  Kernel kernel{.name = "list", .ports = {reads<uint32_t>("values", pixels)}};
  kernel.inputs.smaller = [](const Case& c) {
    const auto values = c.input<uint32_t>("values");
    std::vector<Case> halves;
    if (values.size() < 2) return halves;
    for (const auto& part : {values.first(values.size() / 2), values.subspan(values.size() / 2)}) {
      Case half{.extent = {static_cast<uint32_t>(part.size()), 1}};
      half.set_input("values", part);
      halves.push_back(half);
    }
    return halves;
  };
  return kernel;
}

Case list_case() {
  Case c{.name = "long", .seed = 9, .extent = {100, 1}};
  std::vector<uint32_t> values(100, 3);
  values[61] = 7;
  c.set_input("values", values);
  return c;
}

bool holds_a_seven(const Case& c) {
  const auto values = c.input<uint32_t>("values");
  return std::find(values.begin(), values.end(), 7u) != values.end();
}

TEST(Trials, ShrinkingByTheKernelsOwnSteps) {
  const check::Shrunk shrunk = check::shrink(list_kernel(), list_case(), holds_a_seven);
  EXPECT_EQ(shrunk.input.inputs.at("values").size(), 4u);
  EXPECT_EQ(shrunk.input.seed, 9u);
  EXPECT_EQ(shrunk.input.name, "long");
}

TEST(Trials, ShrinkingByZeros) {
  Kernel kernel = list_kernel();
  kernel.inputs.smaller = {};
  const check::Shrunk shrunk = check::shrink(kernel, list_case(), holds_a_seven);
  const auto values = shrunk.input.input<uint32_t>("values");
  EXPECT_EQ(values.size(), 100u);
  EXPECT_LE(std::ranges::count_if(values, [](uint32_t v) { return v != 0; }), 2);
}

TEST(Trials, ShrinkingEndsAndOutlivesExceptions) {
  uint32_t asked = 0;
  const auto throws = [&](const Case&) -> bool {
    ++asked;
    throw std::logic_error("the oracle cannot");
  };
  const check::Shrunk shrunk = check::shrink(list_kernel(), list_case(), throws, {.attempts = 5});
  EXPECT_EQ(asked, 5u);
  EXPECT_EQ(shrunk.steps, 0u);
  EXPECT_EQ(shrunk.input.inputs, list_case().inputs);
}

TEST(Trials, ProgressOfSeveralKernelsIsOneBar) {
  std::vector<std::string> told;
  const check::Tell tell = [&](const std::string& what, uint64_t done, uint64_t of) {
    told.push_back(what + " " + std::to_string(done) + "/" + std::to_string(of));
  };
  check::part_of(tell, 1, 3)("visibility", 50, 100);
  check::part_of(tell, 0, 1)("visibility", 50, 100);
  EXPECT_EQ(told, (std::vector<std::string>{"visibility (2 of 3) 150/300", "visibility 50/100"}));
  EXPECT_FALSE(check::part_of({}, 1, 3)) << "nobody is told";
}

TEST(Trials, PoisonIsNoPlausibleValue) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    const uint32_t a = check::poison_word(seed, 0), b = check::poison_word(seed, 1);
    for (const uint32_t word : {a, b}) {
      EXPECT_TRUE(std::isnan(std::bit_cast<float>(word)));
      EXPECT_NE(word, 0xffffffffu);
    }
    for (uint32_t byte = 0; byte < 4; ++byte) EXPECT_NE(a >> (8 * byte) & 0xff, b >> (8 * byte) & 0xff);
    const Port depth = writes_image("depth", Format::d32_float), colour = writes_image("colour", Format::r32_uint);
    const uint32_t near = check::poison_of(depth, seed, 0), other = check::poison_of(depth, seed, 1);
    EXPECT_NE(near, other);
    for (const uint32_t word : {near, other}) {
      EXPECT_GE(std::bit_cast<float>(word), 0.75f);
      EXPECT_LT(std::bit_cast<float>(word), 1.0f);
    }
    EXPECT_EQ(check::poison_of(colour, seed, 1), b);
  }
}

}  // namespace
}  // namespace assay::tests
