// The checker against kernels with planted faults: each is found, told in the right words, made smaller and replayed.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <thread>

#include "harness/check/check.h"
#include "harness/check/run_case.h"
#include "tests/check_report.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

namespace fs = std::filesystem;

const Kernel& faults() { return planted("check_faults"); }

class Planted : public testing::Test {
 protected:
  Planted() {
    options_.failures = fs::temp_directory_path() /
                        ("assay-planted-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    options_.fixtures = options_.failures / "fixtures";
  }
  ~Planted() override { fs::remove_all(options_.failures); }

  check::KernelResult run(const std::string& variant, uint32_t trials = 0) {
    options_.variant = variant;
    options_.trials = trials;
    return check::check_kernel(device(), device_options(), options_, faults());
  }
  // The variant fails on the marked hard case alone, in these words, and its shrunk case still does.
  void expect_fault(const std::string& variant, const std::string& words) {
    const check::KernelResult result = run(variant);
    const check::VariantResult& v = result.variants.at(0);
    EXPECT_EQ(v.violations, 1u) << complaints_of({result});
    EXPECT_FALSE(check::passed({result}));
    ASSERT_EQ(v.failures.size(), 1u);
    EXPECT_NE(v.failures[0].text.find("check_faults " + variant + ", case marked, seed "), std::string::npos)
        << v.failures[0].text;
    EXPECT_NE(v.failures[0].text.find(words), std::string::npos) << v.failures[0].text;
    EXPECT_EQ(v.failures[0].replay, "build/assay check check_faults --variant " + variant + " --case marked");
    expect_replay(variant, v.failures[0].file, words.substr(0, words.find_first_of("0123456789")));
  }
  void expect_replay(const std::string& variant, const fs::path& file, const std::string& words) {
    const Case shrunk = check::load_case(file, faults());
    EXPECT_EQ(shrunk.extent.width, 1u);  // the one element that is marked
    options_.case_name = file.string();
    const check::KernelResult again = run(variant);
    EXPECT_EQ(again.variants.at(0).cases, 1u);
    ASSERT_EQ(again.variants.at(0).violations, 1u);
    EXPECT_NE(again.variants.at(0).failures.at(0).text.find(words), std::string::npos);
  }

  check::Options options_;
};

TEST_F(Planted, CorrectPasses) {
  const check::KernelResult result = run("correct", 20);
  EXPECT_TRUE(check::passed({result})) << complaints_of({result});
  const check::VariantResult& v = result.variants.at(0);
  EXPECT_EQ(v.cases, 3u);  // two hard ones and the typical one
  EXPECT_EQ(v.trials, 20u);
  EXPECT_GT(v.judged, 2000u);
  EXPECT_EQ(v.bounds.at(0).worst, 0);
}

TEST_F(Planted, StrayWrite) { expect_fault("stray", "stray write behind pairs: byte 0 of the guard"); }
TEST_F(Planted, UnwrittenElement) { expect_fault("unwritten", "pairs: element 7 was not written"); }
TEST_F(Planted, HalfWrittenElement) { expect_fault("half_written", "pairs: element 7 was not written"); }
TEST_F(Planted, TouchedElement) { expect_fault("touched", "list: element 102 was written"); }
TEST_F(Planted, WrongValue) {
  expect_fault("wrong_value", "ulps(pairs): element 7: expected .key 22 (0x16), got .key 23 (0x17)");
}
TEST_F(Planted, NotANumber) {
  expect_fault("not_a_number", "ulps(pairs): element 7: expected .half_value 3.5 (0x40600000), got");
}

// A target holds poison until a draw clears it or covers every pixel.
TEST_F(Planted, ATargetsPixelThatIsNeitherClearedNorDrawnIsNoticed) {
  const std::map<std::string, std::string> expected = {{"cleared", ""},
                                                       {"colour_not_cleared", "colour: element 67 was not written"},
                                                       {"depth_not_cleared", "depth: element 67 was not written"},
                                                       {"not_drawn", "colour: element 0 was not written"}};
  options_.trials = 0;
  const check::KernelResult result =
      check::check_kernel(device(), device_options(), options_, planted("check_targets"));
  EXPECT_TRUE(result.complaints.empty()) << complaints_of({result});
  ASSERT_EQ(result.variants.size(), expected.size());
  for (const check::VariantResult& v : result.variants) {
    const std::string& words = expected.at(v.name);
    EXPECT_EQ(v.violations, words.empty() ? 0u : 1u) << v.name;
    if (words.empty()) continue;
    EXPECT_NE(v.failures.at(0).text.find(words), std::string::npos) << v.failures[0].text;
  }
}

// Reflection refuses every shader and pass that could do it, so the input is exchanged under the checker's eyes.
TEST_F(Planted, AnInputThatChangedIsAViolation) {
  const Kernel& kernel = faults();
  check::Prepared prepared = check::prepare(kernel, kernel.inputs.hard.at(0).make(), device::info(*device()).traits);
  const device::Ports ports = device::make_ports(*device(), kernel, prepared.input);
  const device::Plan plan{.kernel = &kernel, .variant = &kernel.variants.at(0)};
  EXPECT_EQ(check::run_case(*device(), plan, prepared, ports, true).memory.text, "");
  prepared.input.inputs.at("values").back() = std::byte{1};
  EXPECT_EQ(check::run_case(*device(), plan, prepared, ports, true).memory.text, "input values was written");
}

TEST_F(Planted, AShaderThatMayWriteAnInputIsRefusedBeforeItRuns) {
  const check::KernelResult result = run("input_written");
  EXPECT_EQ(result.variants.at(0).cases, 0u);
  ASSERT_EQ(result.complaints.size(), 1u);
  EXPECT_NE(result.complaints[0].find("port values is read, the shader may write it"), std::string::npos)
      << result.complaints[0];
  EXPECT_FALSE(check::passed({result}));
}

TEST_F(Planted, AnotherOrderIsTheSameSet) {
  const check::KernelResult result = run("reversed", 20);
  EXPECT_TRUE(check::passed({result})) << complaints_of({result});
}

TEST_F(Planted, AnElementTwiceIsAnotherSet) {
  const check::VariantResult v = run("repeated").variants.at(0);
  ASSERT_EQ(v.violations, 1u);
  EXPECT_NE(v.failures.at(0).text.find("same_set(list): elements 0 to 99 as a set: expected 7, got 0; 1 of 100 differ"),
            std::string::npos)
      << v.failures.at(0).text;
}

TEST_F(Planted, ATrialReplaysByItsSeed) {
  const check::VariantResult v = run("wrong_value", 3).variants.at(0);
  ASSERT_EQ(v.violations, 4u);
  EXPECT_NE(v.failures.at(1).text.find("case seed1, seed 1"), std::string::npos) << v.failures.at(1).text;
  EXPECT_EQ(v.failures.at(3).replay, "build/assay check check_faults --variant wrong_value --seed 3");
  options_.seed = 3;
  const check::VariantResult again = run("wrong_value", 1).variants.at(0);
  EXPECT_EQ(again.trials, 1u);
  EXPECT_EQ(again.cases, 0u);
  ASSERT_EQ(again.violations, 1u);
  const auto first_line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
  EXPECT_EQ(first_line(again.failures[0].text), first_line(v.failures[3].text));
  EXPECT_EQ(run("wrong_value", 5).variants.at(0).trials, 5u);  // from this one on
}

TEST_F(Planted, AFixtureRunsAsAHardCase) {
  const check::VariantResult v = run("wrong_value").variants.at(0);
  fs::create_directories(options_.fixtures / "check_faults");
  fs::copy(v.failures.at(0).file, options_.fixtures / "check_faults" / "kept.case");
  const check::VariantResult all = run("wrong_value").variants.at(0);
  EXPECT_EQ(all.cases, 4u);
  EXPECT_EQ(all.violations, 2u);
  options_.case_name = "kept";
  EXPECT_EQ(run("wrong_value").variants.at(0).violations, 1u);
}

TEST_F(Planted, AVariantThatKeepsFailingIsStopped) {
  const check::VariantResult v = run("wrong_value", 40).variants.at(0);
  EXPECT_EQ(v.violations, 10u);
  EXPECT_EQ(v.failures.size(), 10u);
  EXPECT_LT(v.trials, 40u);
  EXPECT_NE(v.failures.back().text.find("10 failures: wrong_value is not run further"), std::string::npos);
}

// Of every case, the last element is undecided.
Kernel undecided_kernel(double limit) {
  Kernel kernel = faults();
  std::erase_if(kernel.variants, [](const Variant& v) { return v.name != "correct"; });
  kernel.undecided_limit = limit;
  kernel.bounds = {between({"list"}, "")};
  kernel.oracle = [](const Case& c) {
    const auto values = c.input<uint32_t>("values");
    Expected e{.low = c.inputs.at("values"), .high = c.inputs.at("values")};
    for (uint32_t i = 0; i <= values.size(); ++i) e.first.push_back(i);
    e.live = {{0, values.size()}};
    auto* last = reinterpret_cast<uint32_t*>(e.high.data()) + values.size() - 1;
    ++*last;
    return Answer{{"list", e}};
  };
  return kernel;
}

TEST_F(Planted, AnUndecidedOracleIsAComplaint) {
  const auto checked = [&](const Kernel& kernel, uint32_t trials) {
    options_.trials = trials;
    return check::check_kernel(device(), device_options(), options_, kernel);
  };
  Kernel kernel = undecided_kernel(0);
  EXPECT_EQ(
      checked(kernel, 0).complaints,
      std::vector<std::string>{"1 of 4096 elements of the typical input are undecided, 0.000244; the limit is 0"});
  kernel.typical = {};
  EXPECT_TRUE(check::passed({checked(kernel, 29)})) << "so few trials are not judged";
  const check::KernelResult judged = checked(kernel, 30);
  ASSERT_EQ(judged.complaints.size(), 1u) << complaints_of({judged});
  EXPECT_TRUE(judged.complaints[0].starts_with("30 of ")) << judged.complaints[0];
  const check::KernelResult lenient = checked(undecided_kernel(1), 200);
  EXPECT_TRUE(check::passed({lenient})) << complaints_of({lenient});
  EXPECT_EQ(lenient.variants.at(0).undecided, 203u);  // one a case and trial
  EXPECT_EQ(lenient.variants.at(0).hard_undecided, 2u);
  options_.variant = "correct";
  EXPECT_TRUE(check::passed({checked(undecided_kernel(0), 200)})) << "the limit is of all variants together";
}

// A few trials with all that is undecided say little of the share; many do.
TEST_F(Planted, TheUndecidedShareIsJudgedByItsStandardError) {
  Kernel kernel = undecided_kernel(0);
  kernel.typical = {};
  kernel.oracle = [every = kernel.oracle](const Case& c) {
    Answer answer = every(c);
    if (c.input<uint32_t>("values").size() % 16 != 3) answer.at("list").high = answer.at("list").low;
    return answer;
  };
  const auto checked = [&](uint32_t trials) {
    options_.trials = trials;
    return check::check_kernel(device(), device_options(), options_, kernel);
  };
  const check::KernelResult few = checked(60), many = checked(1000);
  EXPECT_GT(few.variants.at(0).undecided - few.variants.at(0).hard_undecided, 0u);
  EXPECT_TRUE(check::passed({few})) << complaints_of({few});
  EXPECT_EQ(many.complaints.size(), 1u) << complaints_of({many});
}

TEST_F(Planted, TheTypicalInputIsACaseOfItsOwn) {
  options_.case_name = "typical";
  const check::KernelResult result = run("correct", 50);
  EXPECT_TRUE(check::passed({result})) << complaints_of({result});
  EXPECT_EQ(result.variants.at(0).cases, 1u);
  EXPECT_EQ(result.variants.at(0).trials, 0u);
  EXPECT_EQ(result.variants.at(0).judged, 2u * 64 * 64);
}

TEST_F(Planted, AnOracleThatSaysNothingIsAComplaint) {
  Kernel kernel = faults();
  kernel.oracle = [](const Case&) { return Answer{}; };
  options_.variant = "correct";
  const check::KernelResult result = check::check_kernel(device(), device_options(), options_, kernel);
  EXPECT_EQ(result.complaints,
            std::vector<std::string>{
                "check_faults correct, case marked: check_faults: the oracle says nothing of ulps(pairs)"});
}

TEST_F(Planted, AVariantThatCannotRunIsSkippedWithItsReason) {
  Kernel kernel = faults();
  kernel.variants.resize(2);
  kernel.variants[0].subgroup_min = 100;
  kernel.variants[1].subgroup_min = 100;
  const check::KernelResult result = check::check_kernel(device(), device_options(), options_, kernel);
  EXPECT_NE(result.variants.at(0).skipped, "");
  EXPECT_EQ(result.variants.at(0).cases, 0u);
  EXPECT_EQ(result.complaints, std::vector<std::string>{"no variant can run on this device"});
}

TEST_F(Planted, MutantsAreToldApart) {
  Kernel kernel = faults();
  kernel.variants.resize(1);
  const auto results = check::mutate_kernel(device(), device_options(), kernel, 3);
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[0].killed_by, "marked");
  EXPECT_EQ(results[1].killed_by, "marked");
  EXPECT_EQ(results[1].named, "unmarked");
  EXPECT_EQ(results[2].killed_by, "");
  EXPECT_EQ(results[3].killed_by, "marked");
}

#ifdef ASSAY_TESTS
constexpr int32_t kDeviceLost = -4, kOutOfDeviceMemory = -2;

TEST_F(Planted, ALostDeviceIsReplacedAndReported) {
  device::inject_failure("vkQueueSubmit2", kDeviceLost, 2);
  const check::KernelResult result = run("correct", 5);
  EXPECT_TRUE(check::passed({result})) << complaints_of({result});
  EXPECT_EQ(result.variants.at(0).flaky, 1u);
}

// Until what a hung device was left with has ended: no test may run beside it, nor the process end.
void wait_for_silence() {
  using namespace std::chrono_literals;
  for (std::clock_t before = std::clock(), after = 0;; before = after) {
    std::this_thread::sleep_for(100ms);
    after = std::clock();
    if (after - before < CLOCKS_PER_SEC / 100) return;
  }
}

TEST_F(Planted, AHangIsAViolationAndTheNextCaseRunsOnAFreshDevice) {
  using namespace std::chrono_literals;
  options_.trials = 0;
  options_.case_name = "short";  // compiles
  const check::KernelResult well = check::check_kernel(device(), device_options(), options_, planted("check_hang"));
  EXPECT_TRUE(check::passed({well})) << complaints_of({well});

  options_.case_name.clear();
  device::set_fence_wait(500ms);
  const check::KernelResult result = check::check_kernel(device(), device_options(), options_, planted("check_hang"));
  device::set_fence_wait(60s);
  wait_for_silence();
  const check::VariantResult& v = result.variants.at(0);
  EXPECT_EQ(v.cases, 2u);
  ASSERT_EQ(v.violations, 1u) << complaints_of({result});
  EXPECT_EQ(v.failures[0].text,
            "check_hang turns, case endless, seed 0: device lost, and again on a fresh one: vkWaitForFences: the work "
            "was not done after 1 s")
      << "half a second, and as much for the code of the one pipeline that the fresh device has yet to run";
  EXPECT_EQ(v.failures[0].replay, "build/assay check check_hang --variant turns --case endless");
  EXPECT_TRUE(v.failures[0].file.empty()) << "a hang is not made smaller";
}

TEST_F(Planted, OutOfMemoryIsAViolation) {
  run("correct");
  device::inject_failure("vkCreateBuffer", kOutOfDeviceMemory);
  const check::KernelResult result = run("correct");
  EXPECT_EQ(result.variants.at(0).violations, 1u);
  EXPECT_NE(complaints_of({result}).find("VK_ERROR_OUT_OF_DEVICE_MEMORY"), std::string::npos)
      << complaints_of({result});
}
#endif

}  // namespace
}  // namespace assay::tests
