// The pipeline cache on disk: the second run finds it, and one that is damaged or another's does no harm.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "harness/check/check.h"
#include "harness/device/cache_file.h"
#include "tests/check_report.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

namespace fs = std::filesystem;

// A cache folder of the test's own, as XDG_CACHE_HOME.
class Cache : public testing::Test {
 protected:
  Cache() {
    fs::create_directories(home_);
    setenv("XDG_CACHE_HOME", home_.c_str(), 1);
  }
  ~Cache() override {
    if (before_.empty())
      unsetenv("XDG_CACHE_HOME");
    else
      setenv("XDG_CACHE_HOME", before_.c_str(), 1);
    fs::remove_all(home_);
  }

  // Opens a device, checks a kernel on it, closes it; how much of a cache it found.
  size_t run() const {
    device::Handle d = device::open(device_options());
    const size_t found = device::loaded_cache_bytes(*d);
    const check::Options options{.variant = "correct", .trials = 0, .fixtures = "", .failures = home_};
    const auto result = check::check_kernel(d, device_options(), options, planted("check_faults"));
    EXPECT_TRUE(check::passed({result})) << complaints_of({result});
    return found;
  }
  fs::path file() const {
    const fs::directory_iterator all(home_ / "assay");
    EXPECT_EQ(std::distance(all, {}), 1) << "nothing is left beside the cache";
    return fs::directory_iterator(home_ / "assay")->path();
  }
  // Nothing is found in the file, the run is right, and it leaves a good one.
  void expect_ignored(const char* what) const {
    EXPECT_EQ(run(), 0u) << what;
    EXPECT_GT(run(), 0u) << what;
  }

  fs::path home_ = fs::temp_directory_path() / "assay-cache-test";
  std::string before_ = std::getenv("XDG_CACHE_HOME") ? std::getenv("XDG_CACHE_HOME") : "";
};

TEST_F(Cache, IsFoundByTheSecondRun) {
  EXPECT_EQ(run(), 0u);
  const Bytes kept = device::read_sealed(file());
  EXPECT_GE(kept.size(), 32u) << "Vulkan's header at least";
  EXPECT_EQ(run(), kept.size());
}

TEST_F(Cache, IsIgnoredWhereItWasCutOff) {
  run();
  const auto size = fs::file_size(file());
  for (const uintmax_t left : {size - 1, size / 2, uintmax_t{10}, uintmax_t{0}}) {
    fs::resize_file(file(), left);
    expect_ignored("cut off");
  }
}

TEST_F(Cache, IsIgnoredWhereABitHasTurned) {
  run();
  const auto size = fs::file_size(file());
  for (const uintmax_t at : {uintmax_t{0}, uintmax_t{9}, uintmax_t{16}, size / 2, size - 1}) {
    std::fstream turned(file(), std::ios::binary | std::ios::in | std::ios::out);
    turned.seekg(static_cast<std::streamoff>(at));
    const int byte = turned.get();
    turned.seekp(static_cast<std::streamoff>(at));
    turned.put(static_cast<char>(byte ^ 0x10));
    turned.close();
    expect_ignored("a bit turned");
  }
}

TEST_F(Cache, IsIgnoredWhereItIsAnothers) {
  run();
  const Bytes ours = device::read_sealed(file());
  for (const size_t at : {size_t{4}, size_t{8}, size_t{12}, size_t{16}}) {  // version, vendor, device, driver's UUID
    Bytes foreign = ours;
    foreign.at(at) ^= std::byte{1};
    device::write_sealed(file(), foreign);
    EXPECT_EQ(device::read_sealed(file()), foreign);
    expect_ignored("another's");
  }
  device::write_sealed(file(), std::span(ours).first(20));  // no whole header
  expect_ignored("no header");
}

TEST_F(Cache, ThatCannotBeWrittenIsDoneWithout) {
  std::ofstream(home_ / "assay") << "a file where the folder should be";
  EXPECT_EQ(run(), 0u);
  EXPECT_EQ(run(), 0u);
  setenv("XDG_CACHE_HOME", "/proc/nowhere", 1);
  EXPECT_EQ(run(), 0u);
}

}  // namespace
}  // namespace assay::tests
