// Case files survive the round trip, and broken ones are refused in one line that names file and place.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>
#include <fstream>

#include "harness/check/cases.h"
#include "harness/check/check.h"

namespace assay::tests {
namespace {

namespace fs = std::filesystem;

struct Folder {  // removed with its files
  fs::path path = fs::temp_directory_path() /
                  ("assay-case-file-" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) + "-" +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

Kernel kernel() {
  return {.name = "sums",
          .params = layout_of<uint32_t>(),
          .ports = {reads<uint32_t>("values", pixels), reads_textures("pictures", 2),
                    reads_image("depth", Format::r16_float), writes<uint32_t>("sum", fixed(1))}};
}

Case sample() {
  Case c{.name = "sample", .seed = 0xfedcba9876543210ull, .extent = {3, 2}};
  c.set_params(5u);
  c.set_input("values", std::vector<uint32_t>{1, 0, 0, 0, 0xffffffffu, 7});
  c.set_input("depth", std::vector<uint16_t>{1, 2, 3, 4, 5, 6});
  c.textures["pictures"] = {
      {.format = Format::r8_unorm, .width = 3, .height = 3, .layers = 1, .levels = 2, .bytes = Bytes(10)},
      {.format = Format::bc7_srgb,
       .width = 5,
       .height = 3,
       .layers = 1,
       .levels = 3,
       .bytes = Bytes(64, std::byte{64})}};
  return c;
}

std::string written(const fs::path& path) {
  check::save_case(path, kernel(), sample());
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The message for the sample's file after one replacement.
std::string refusal(const std::string& from, const std::string& to) {
  const Folder folder;
  const fs::path path = folder.path / "broken.case";
  std::string text = written(path);
  const size_t at = text.find(from);
  if (at == std::string::npos) return "the file does not hold " + from;
  std::ofstream(path) << text.replace(at, from.size(), to);
  try {
    check::load_case(path, kernel());
  } catch (const std::runtime_error& e) {
    const std::string message = e.what(), prefix = path.string() + ": ";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : "no file in: " + message;
  }
  return "accepted";
}

TEST(CaseFile, RoundTrip) {
  const Folder folder;
  const fs::path path = folder.path / "deeper" / "sample.case";
  const Case before = sample();
  check::save_case(path, kernel(), before);
  const Case after = check::load_case(path, kernel());
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.seed, before.seed);
  EXPECT_EQ(after.extent.width, 3u);
  EXPECT_EQ(after.extent.height, 2u);
  EXPECT_EQ(after.parameters, before.parameters);
  EXPECT_EQ(after.inputs, before.inputs);
  ASSERT_EQ(after.textures.at("pictures").size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const Texture &a = after.textures.at("pictures")[i], &b = before.textures.at("pictures")[i];
    EXPECT_EQ(a.format, b.format);
    EXPECT_EQ(a.levels, b.levels);
    EXPECT_EQ(a.bytes, b.bytes);
  }
  EXPECT_EQ(check::kernel_of_case(path), "sums");
}

TEST(CaseFile, EqualWordsTakeOneEntry) {
  const Folder folder;
  EXPECT_NE(written(folder.path / "a.case").find("\"00000001 00000000*3 ffffffff 00000007\""), std::string::npos);
}

TEST(CaseFile, AnyWordsSurvive) {
  const Folder folder;
  EXPECT_TRUE(rc::check("words of any value, with runs", [&](std::vector<uint32_t> words, uint8_t run) {
    if (!words.empty()) words.insert(words.end(), run, words.back());
    Case c = sample();
    c.extent = {static_cast<uint32_t>(words.size()), 1};
    c.set_input("values", words);
    c.set_input("depth", std::vector<uint16_t>(words.size(), 7));
    check::save_case(folder.path / "any.case", kernel(), c);
    RC_ASSERT(check::load_case(folder.path / "any.case", kernel()).inputs == c.inputs);
  }));
}

TEST(CaseFile, BrokenFilesAreRefused) {
  EXPECT_EQ(refusal("00000001 ", "0000zz01 "), "/inputs/values/words/0: '0000zz01' is not a hexadecimal number");
  EXPECT_EQ(refusal("00000000*3", "00000000*99999999999"),
            "/inputs/values/words/0: '00000000*99999999999' is more words than \"bytes\" says");
  EXPECT_EQ(refusal("00000000*3", "00000000*2"), "/inputs/values: 5 words for 24 bytes");
  EXPECT_EQ(refusal("\"width\": 3", "\"width\": 4"), "/inputs/values: 24 bytes; extent and parameters ask for 32");
  EXPECT_EQ(refusal("\"width\": 3", "\"width\": -3"), "/width: -3 is not a whole number up to 65536");
  EXPECT_EQ(refusal("\"width\"", "\"girth\""), "/: no \"width\"");
  EXPECT_EQ(refusal("\"values\"", "\"prices\""), "/inputs: sums has no input prices");
  EXPECT_EQ(refusal("\"values\"", "\"sum\""), "/inputs: sums has no input sum");
  EXPECT_EQ(refusal("\"sums\"", "\"products\""), "/kernel: 'products' is not sums");
  EXPECT_EQ(refusal("r8_unorm", "r9_unorm"), "/inputs/pictures/0/format: \"r9_unorm\" is not a format");
  EXPECT_EQ(refusal("\"levels\": 2", "\"levels\": 1"), "/inputs/pictures/0: 10 bytes, its size says 9");
  EXPECT_EQ(refusal("\"bytes\": 4,", "\"bytes\": 8,"), "/parameters: 1 words for 8 bytes");
  EXPECT_EQ(refusal("{\n", "{{\n"), "line 1: not JSON");
}

TEST(CaseFile, AbsentAndCutFilesAreRefused) {
  EXPECT_THROW(check::load_case("/nowhere/at.case", kernel()), std::runtime_error);
  const Folder folder;
  const std::string text = written(folder.path / "cut.case");
  std::ofstream(folder.path / "cut.case") << text.substr(0, text.size() / 2);
  EXPECT_THROW(check::load_case(folder.path / "cut.case", kernel()), std::runtime_error);
}

TEST(CaseFile, FixturesFollowTheHardCases) {
  const Folder folder;
  check::save_case(folder.path / "sums" / "kept.case", kernel(), sample());
  Kernel k = kernel();
  k.inputs.hard = {{"hard", "", sample}, {"large", "", sample, true}};
  const auto names = [&](bool nightly) {
    std::vector<std::string> out;
    for (const auto& c : check::hard_cases(k, folder.path, nightly)) out.push_back(c.name);
    return out;
  };
  EXPECT_EQ(names(false), (std::vector<std::string>{"hard", "kept"}));
  EXPECT_EQ(names(true), (std::vector<std::string>{"hard", "large", "kept"}));
  EXPECT_EQ(check::cases_named(k, folder.path, "kept").at(0).make().inputs, sample().inputs);
  EXPECT_TRUE(check::cases_named(k, folder.path, "lost").empty());
}

}  // namespace
}  // namespace assay::tests
