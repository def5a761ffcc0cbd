// Choosing a device, what is said of it, failures by injection and recovery from them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/lowered.h"
#include "tests/planted/device_copy/layout.h"

namespace assay::anisotropy_probe {
Kernel describe();  // harness/device/probes
}

namespace assay::tests {
namespace {

constexpr int32_t kOutOfDeviceMemory = -2, kInitializationFailed = -3, kDeviceLost = -4;  // of VkResult
constexpr int32_t kTimeout = 2;

template <class E>
std::string message_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const E& e) {
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << "one line: " << e.what();
    return e.what();
  }
  ADD_FAILURE() << "nothing of the expected kind was thrown";
  return "";
}
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Case copy_case() {
  Case c = {.name = "copy"};
  c.set_params(device_copy::CopyParams{3, 10});
  c.set_input("pairs", std::vector<device_copy::Pair>(3));
  c.set_input("arguments", std::vector<DispatchArgs>(3));
  return c;
}

TEST(Device, IsFoundByIndexUuidAndName) {
  for (const device::Info& i : device::list()) {
    if (!i.missing.empty()) continue;
    EXPECT_EQ(device::info(*device::open({.select = std::to_string(i.index)})).index, i.index);
    EXPECT_EQ(device::info(*device::open({.select = i.uuid})).uuid, i.uuid);
    EXPECT_EQ(device::info(*device::open({.select = i.uuid.substr(0, 8)})).uuid, i.uuid);
    EXPECT_EQ(device::info(*device::open({.select = i.name})).name, i.name);
    std::string shouted = i.name;
    std::ranges::transform(shouted, shouted.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    EXPECT_EQ(device::info(*device::open({.select = shouted})).name, i.name);
  }
}

TEST(Device, ThatIsNotThereIsRefusedWithAList) {
  const std::string name = device::list().at(0).name;
  for (const char* select : {"99", "Voodoo", "0123456789abcdef"}) {
    const std::string text = message_of<device::NoSuchDevice>([&] { device::open({.select = select}); });
    EXPECT_TRUE(contains(text, select)) << text;
    EXPECT_TRUE(contains(text, name)) << text;
  }
}

// The level of detail of a footprint 32 texels by 4: by the longer way 5, or up to half a level more; anisotropic 2,
// where that works.
float level_of_footprint(bool is_anisotropic) {
  Kernel probe = anisotropy_probe::describe();
  probe.variants[0].anisotropic = is_anisotropic;
  const Ran r = run_variant(*device(), probe, "anisotropic", probe.typical({1, 1}));
  return read<float>(*device(), r, "reds")[0] * 255 / 16;
}
TEST(Device, AnisotropyIsBelievedWhereItIsSeen) {
  const float isotropic = level_of_footprint(false);
  EXPECT_TRUE(isotropic > 4.5 && isotropic < 6) << isotropic;
  float level = -1;
  try {
    level = level_of_footprint(true);
  } catch (const std::logic_error& e) {  // it has no such sampler
    EXPECT_TRUE(contains(e.what(), "no anisotropic sampler")) << e.what();
  }
  const bool is_believed = device::info(*device()).features.contains(Feature::sampler_anisotropy);
  EXPECT_EQ(is_believed, std::abs(level - 2) <= 1) << level;
  RecordProperty("anisotropic_level", std::to_string(level));
}

TEST(Device, IsNeverTakenInSilence) {
  std::vector<device::Info> infos(3);
  for (uint32_t i = 0; i < 3; ++i) infos[i].index = i;
  infos[0] = {.index = 0, .name = "Alpha 100", .uuid = "00112233445566778899aabbccddeeff", .type = "discrete"};
  infos[1] = {.index = 1, .name = "Alpha 200", .uuid = "10112233445566778899aabbccddeeff", .type = "integrated"};
  infos[2] = {.index = 2, .name = "llvmpipe", .uuid = "20112233445566778899aabbccddeeff", .type = "cpu"};
  EXPECT_EQ(device::choose(infos, ""), 2u);
  EXPECT_EQ(device::choose(infos, "1"), 1u);
  EXPECT_EQ(device::choose(infos, "alpha 1"), 0u);
  EXPECT_EQ(device::choose(infos, "10112233-4455"), 1u);
  const std::span<const device::Info> gpus = std::span(infos).first(2), one = std::span(infos).first(1);
  for (const auto& some : {gpus, one}) {
    const std::string text = message_of<device::NoSuchDevice>([&] { device::choose(some, ""); });
    EXPECT_TRUE(contains(text, "--device")) << text;
    EXPECT_TRUE(contains(text, "Alpha 100")) << text;
  }
  const std::string ambiguous = message_of<device::NoSuchDevice>([&] { device::choose(infos, "alpha"); });
  EXPECT_TRUE(contains(ambiguous, "more than one device matches 'alpha'")) << ambiguous;
  message_of<device::NoSuchDevice>([&] { device::choose({}, ""); });
}

TEST(Device, TellsWhatItIs) {
  const device::Info& i = device::info(*device());
  EXPECT_EQ(i.uuid.size(), 32u);
  EXPECT_FALSE(i.driver.empty());
  EXPECT_GE(i.subgroup_max, i.traits.subgroup_width);
  EXPECT_LE(i.subgroup_min, i.traits.subgroup_width);
  EXPECT_GE(i.max_groups[0], 65535u);
  EXPECT_GT(i.timestamp_ns, 0);
  EXPECT_GE(i.max_buffer_range, uint64_t{128} << 20);
  EXPECT_GT(i.memory_bytes, 0u);
}

TEST(Device, SaysWhatAVariantMisses) {
  device::Info i = device::info(*device());
  Variant v = {.name = "demanding", .passes = {}, .needs = {Feature::forward_progress, Feature::int64}};
  i.features = {Feature::int64};
  EXPECT_EQ(device::missing(i, v), "needs forward_progress");
  v.subgroup_min = 2 * i.traits.subgroup_width;
  v.needs.clear();
  EXPECT_TRUE(
      contains(device::missing(i, v), "subgroup width " + std::to_string(i.traits.subgroup_width) + " outside"));
  v.subgroup_min = 1;
  EXPECT_EQ(device::missing(i, v), "");
}

TEST(Device, ACallThatFailsIsNamed) {
  device::inject_failure("vkCreateDevice", kInitializationFailed);
  const std::string text = message_of<device::Error>([] { device::open(device_options()); });
  EXPECT_TRUE(contains(text, "vkCreateDevice(")) << text;
  EXPECT_TRUE(contains(text, "VK_ERROR_INITIALIZATION_FAILED")) << text;
  EXPECT_TRUE(contains(text, "harness/device/open.cpp:")) << text;
  EXPECT_NO_THROW(device::open(device_options()));
}

// Whatever call of opening a device fails, what was made before it is given back and the next attempt works.
TEST(Device, OpeningFailsCleanlyAtEveryCall) {
  uint32_t failures = 0;
  for (uint32_t after = 0; after < 100; ++after) {
    device::inject_failure("vk", kInitializationFailed, after);
    try {
      device::open(device_options());
      break;
    } catch (const device::Error&) {
      ++failures;
    }
  }
  device::inject_failure("", 0);
  EXPECT_GT(failures, 5u);
  EXPECT_NO_THROW(device::open(device_options()));
}

TEST(Device, LossIsToldAndAFreshDeviceWorks) {
  const Kernel& kernel = planted("device_copy");
  for (const char* call : {"vkQueueSubmit2", "vkWaitForFences"}) {
    device::Handle lost = device::open(device_options());
    const Ran before = run_variant(*lost, kernel, "direct", copy_case());
    device::inject_failure(call, kDeviceLost);
    const std::string text = message_of<device::Lost>([&] { device::run(*lost, before.commands); });
    EXPECT_TRUE(contains(text, "VK_ERROR_DEVICE_LOST")) << text;
    EXPECT_TRUE(contains(text, call)) << text;
    EXPECT_THROW(device::run(*lost, before.commands), device::Lost) << "a lost device stays lost";
    lost = device::open(device_options());
    EXPECT_NO_THROW(run_variant(*lost, kernel, "direct", copy_case()));
  }
}

TEST(Device, AFenceThatIsNotSignalledIsALoss) {
  device::Handle slow = device::open(device_options());
  const Ran before = run_variant(*slow, planted("device_copy"), "direct", copy_case());
  device::inject_failure("vkWaitForFences", kTimeout);
  EXPECT_TRUE(contains(message_of<device::Lost>([&] { device::run(*slow, before.commands); }), "60 s"));
}

TEST(Device, OutOfMemoryIsToldAndTheDeviceGoesOn) {
  const Kernel& kernel = planted("device_copy");
  device::Handle fresh = device::open(device_options());  // nothing kept to fall back on
  for (const char* call : {"vkAllocateMemory", "vkCreateBuffer", "vkBindBufferMemory", "vkCreateComputePipelines",
                           "vkCreateShaderModule", "vkCreatePipelineLayout"}) {
    device::Handle d = device::open(device_options());
    device::inject_failure(call, kOutOfDeviceMemory);
    const std::string text = message_of<device::OutOfMemory>([&] { run_variant(*d, kernel, "direct", copy_case()); });
    EXPECT_TRUE(contains(text, call)) << text;
    EXPECT_NO_THROW(run_variant(*d, kernel, "direct", copy_case())) << call;
  }
}

TEST(Device, MemoryKeptForReuseIsGivenUpWhenMemoryIsShort) {
  device::Handle d = device::open(device_options());
  device::make_buffer(*d, "kept", 100 << 10).reset();
  device::inject_failure("vkAllocateMemory", kOutOfDeviceMemory);
  EXPECT_NO_THROW(device::make_buffer(*d, "other", 1 << 20));
}

// Every checked call on the way of a whole run, one after another.
TEST(Device, ARunFailsCleanlyAtEveryCall) {
  const Kernel& kernel = planted("device_copy");
  device::Handle d = device::open(device_options());
  uint32_t after = 0;
  for (; after < 300; ++after) {
    device::inject_failure("vk", kOutOfDeviceMemory, after);
    try {
      run_variant(*d, kernel, after % 2 ? "direct" : "image", copy_case());
    } catch (const device::Error&) {
      d = device::open(device_options());  // a failed submission is a lost device
      continue;
    }
    device::inject_failure("", 0);
    if (after % 2) break;
  }
  EXPECT_GT(after, 10u);
  EXPECT_NO_THROW(run_variant(*d, kernel, "direct", copy_case()));
}

TEST(Device, ResourcesOutliveItsHandle) {
  device::Handle d = device::open(device_options());
  const device::Owned buffer = device::make_buffer(*d, "survivor", 64);
  const device::Owned image = device::make_image(*d, "picture", Format::r32_uint, {}, {3, 3});
  d.reset();
  EXPECT_EQ(device::payload_bytes(*buffer), 64u);
}

TEST(Device, ASecondQueueRunsTheSame) {
  if (!device::info(*device()).second_queue) GTEST_SKIP() << "one queue only";
  const Ran r = run_variant(*device(), planted("device_copy"), "direct", copy_case());
  EXPECT_NO_THROW(device::run(*device(), r.commands, 1));
}

TEST(Device, AQueueThatIsNotThereIsRefused) {
  const Ran r = run_variant(*device(), planted("device_copy"), "direct", copy_case());
  EXPECT_THROW(device::run(*device(), r.commands, 7), std::logic_error);
}

TEST(Device, ValidationIsSilentAboutAWholeRun) {
  device::Handle d;
  try {
    d = device::open({.select = device_options().select, .validation = device::Validation::sync});
  } catch (const device::Error& e) {
    GTEST_SKIP() << e.what();
  }
  for (const char* variant : {"direct", "image", "rows"}) run_variant(*d, planted("device_copy"), variant, copy_case());
  for (const std::string& m : device::validation_messages(*d)) ADD_FAILURE() << m;
}

// The layer does see this process: a write and a read of it without a barrier between them.
TEST(Device, ValidationSpeaksOfAMissingBarrier) {
  device::Handle d;
  try {
    d = device::open({.select = device_options().select, .validation = device::Validation::sync});
  } catch (const device::Error& e) {
    GTEST_SKIP() << e.what();
  }
  Ran r = run_variant(*d, planted("device_copy"), "rows", copy_case());
  EXPECT_TRUE(device::validation_messages(*d).empty());
  std::erase_if(r.commands, [](const device::Command& c) { return c.kind == device::Command::Kind::barrier; });
  device::run(*d, r.commands);
  const auto messages = device::validation_messages(*d);
  ASSERT_FALSE(messages.empty());
  EXPECT_TRUE(contains(messages[0], "SYNC-HAZARD")) << messages[0];
  EXPECT_TRUE(device::validation_messages(*d).empty()) << "messages are taken once";
}

}  // namespace
}  // namespace assay::tests
