// The program as its users meet it: help that teaches, one line and exit 2 for unusable input, JSON of the promised
// shape.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/check/check.h"
#include "harness/image/image.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Removed with all that it holds.
class Folder {
 public:
  Folder() {
    std::string path = (fs::temp_directory_path() / "assay-cli-XXXXXX").string();
    if (!mkdtemp(path.data())) throw std::runtime_error("no temporary folder");
    path_ = path;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string with(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    return file(name);
  }

 private:
  fs::path path_;
};

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Ran {
  int code = -1;
  std::string out, err;
};

// Beside this very program, in a build as in an installed copy.
std::string program() { return (fs::read_symlink("/proc/self/exe").parent_path() / "assay").string(); }

Ran assay(const std::string& arguments) {
  const Folder folder;
  const std::string out = folder.file("stdout.txt"), err = folder.file("stderr.txt");
  const int status = std::system(
      fmt::format("cd {} && '{}' {} >stdout.txt 2>stderr.txt </dev/null", folder.file(""), program(), arguments)
          .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

// The device that the other tests use.
std::string on_device() {
  const std::string& select = device_options().select;
  return select.empty() ? "" : fmt::format(" --device '{}'", select);
}

std::string first_kernel() { return all_kernels().front().name; }

std::string with_kernel(const std::string& format) {
  return fmt::format(fmt::runtime(format), fmt::arg("kernel", first_kernel()));
}

void expect_one_line(const std::string& arguments, const std::string& mention) {
  const Ran r = assay(arguments);
  EXPECT_EQ(r.code, 2) << arguments << '\n' << r.err;
  EXPECT_EQ(std::ranges::count(r.err, '\n'), 1) << arguments << '\n' << r.err;
  EXPECT_NE(r.err.find(mention), std::string::npos) << arguments << '\n' << r.err;
  EXPECT_TRUE(r.out.empty()) << arguments << '\n' << r.out;
}

TEST(Cli, EveryCommandTeaches) {
  for (const std::string command : {"devices", "list", "check", "bench", "frame", "mutate", "diff"}) {
    const Ran r = assay(command + " --help");
    EXPECT_EQ(r.code, 0);
    EXPECT_NE(r.out.find("Examples:\n  assay " + command), std::string::npos) << r.out;
    EXPECT_NE(assay("--help").out.find("assay " + command), std::string::npos);
  }
}

TEST(Cli, WrongFlagsAndNamesAreOneLine) {
  const std::pair<const char*, const char*> wrong[] = {
      {"", "no command"},
      {"cheque", "no command 'cheque'; did you mean 'check'"},
      {"check --nonsense", "--nonsense"},
      {"check --trials many", "trials"},
      {"check --trials -1", "trials"},
      {"check --seed 1.5", "seed"},
      {"check no_such_kernel", "no kernel 'no_such_kernel'; did you mean"},
      {"check {kernel} --variant no_such_variant", "no variant 'no_such_variant'; did you mean"},
      {"check {kernel} --defaults --variant x", "defaults"},
      {"check {kernel} --case no_such_case", "no case 'no_such_case'; did you mean"},
      {"check --validation maybe", "maybe"},
      {"list no_such_kernel", "no_such_kernel"},
      {"mutate no_such_kernel", "no_such_kernel"},
      {"bench {kernel} --size 0x4", "0x4"},
      {"bench {kernel} --size 64", "64"},
      {"bench particle-light --only nonsense", "nonsense"},
      {"bench particle-light --side 64", "64"},
      {"bench particle-light --filter nearest", "no variant 'nearest'; did you mean"},
      {"bench particle-light --encoding rgba8", "rgba8"},
      {"bench particle-light --only sizes --scene bare", "no particles"},
      {"bench particle-light --size 64", "64"},
      {"bench vrcs --only nonsense", "nonsense"},
      {"bench vrcs --estimator sobel_9", "no variant 'sobel_9'; did you mean"},
      {"bench {kernel} --size 64x64x64", "64x64x64"},
      {"bench {kernel} --samples 0", "samples"},
      {"bench {kernel} --case no_such_case", "no case 'no_such_case'; did you mean"},
      {"frame --view nothing", "nothing"},
      {"frame --clusters some", "some"},
      {"frame --vrcs some", "some"},
      {"frame --vrcs-tolerance -1", "vrcs-tolerance"},
      {"frame --vrcs-tolerance nan", "tolerance of nan"},
      {"frame --view rate", "--vrcs"},
      {"frame --view primary --vrcs off", "--vrcs"},
      {"frame --frames 0", "frames"},
      {"frame --frames many", "frames"},
      {"frame --frames 4 --cut 4", "cut"},
      {"frame --cut 0", "cut"},
      {"frame --size axb", "axb"},
      {"frame --camera 1,2,3", "1,2,3"},
      {"frame --camera 0,0,0,0,0,0", "camera"},
      {"frame --variant {kernel}", "kernel=variant"},
      {"frame --variant no_such_kernel=x", "no_such_kernel"},
      {"diff", "reference"},
      {"diff a.png", "test"},
      {"diff a.png b.exr", "cannot be compared"},
      {"diff a.png b.jpg", "b.jpg"},
      {"diff a.png b.png --max-flip 2", "max-flip"},
      {"diff a.png b.png --map c.txt", "c.txt"},
  };
  for (const auto& [arguments, mention] : wrong) expect_one_line(with_kernel(arguments), mention);
}

TEST(Cli, AbsentDeviceIsOneLine) {
  for (const std::string device : {"999", "no_such_gpu", "ffffffffffffffffffffffffffffffff"})
    for (const std::string command : {"check --trials 1", "bench", "frame", "mutate"})
      expect_one_line(fmt::format("{} --device {}", command, device), device);
}

TEST(Cli, MissingAndBrokenFilesAreOneLine) {
  const Folder folder;
  const std::string broken_case = folder.with("broken.case", "{\"kernel\": 7,"),
                    empty_case = folder.with("empty.case", "");
  const std::string not_json = folder.with("a.gltf", "not a scene"), not_glb = folder.with("b.glb", "glTF\1\2\3");
  for (const auto& file : {folder.file("missing.case"), broken_case, empty_case})
    for (const char* command : {"check", "bench"})
      expect_one_line(fmt::format("{} {} --case {}", command, first_kernel(), file),
                      fs::path(file).filename().string());
  for (const auto& file : {folder.file("missing.gltf"), folder.file("missing.glb"), not_json, not_glb})
    expect_one_line("frame --scene " + file, fs::path(file).filename().string());
  expect_one_line("frame --scene no_such_scene", "no_such_scene");
  expect_one_line("frame --sidecar " + folder.file("absent.lights.json"), "absent.lights.json");
  expect_one_line("frame --sidecar " + folder.with("bad.lights.json", R"({"lights": [{"kind": "laser"}]})"),
                  "bad.lights.json: lights[0].kind");
  for (const char* kind : {"png", "exr"}) {
    const std::string absent = folder.file(fmt::format("absent.{}", kind)),
                      broken = folder.with(fmt::format("broken.{}", kind), "no picture");
    expect_one_line(fmt::format("diff {0} {0}", absent), absent);
    expect_one_line(fmt::format("diff {0} {0}", broken), broken);
  }
}

TEST(Cli, UnwritableOutputIsOneLineBeforeAnyWork) {
  const Folder folder;
  const std::string blocked = folder.with("file", "") + "/x";  // a file where a folder should be
  for (const std::string command : {"devices", "list", "check", "bench", "frame", "mutate"})
    expect_one_line(fmt::format("{} --json={}", command, blocked), blocked);
  expect_one_line("frame --out " + blocked, blocked);
  expect_one_line("bench --markdown " + blocked, blocked);
  expect_one_line("bench --runs " + blocked, blocked);
  for (const char* flag : {"json=", "map="})
    expect_one_line(fmt::format("diff a.png b.png --{}{}.png", flag, blocked), blocked);
}

TEST(Cli, ChecksTheDefaultsAlone) {
  const Ran r = assay("check tile_visit tile_classification --defaults --trials 1 --json=-");
  EXPECT_EQ(r.code, 0) << r.err;
  const Json kernels = Json::parse(r.out).at("kernels");
  ASSERT_EQ(kernels.size(), 2u);
  for (const Json& k : kernels) {
    ASSERT_EQ(k.at("variants").size(), 1u);
    EXPECT_EQ(k.at("variants")[0].at("name"), kernel_named(k.at("name")).default_variant);
  }
}

TEST(Cli, DiffTellsHowFarAndFails) {
  const Folder folder;
  const std::string a = folder.file("a.png"), b = folder.file("b.png"), map = folder.file("map.exr");
  image::Rgba8 picture = {16, 16, std::vector<uint8_t>(16 * 16 * 4, 255)};
  image::write_png(a, picture);
  picture.texels[4 * 77] = 0;
  image::write_png(b, picture);
  const Ran same = assay(fmt::format("diff {0} {0} --max-flip 0", a)),
            off = assay(fmt::format("diff {} {} --max-flip 0 --json --map {}", a, b, map));
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_NE(same.out.find("FLIP 0.000000 mean, PSNR inf dB, 16x16"), std::string::npos) << same.out;
  EXPECT_EQ(off.code, 1) << off.err;
  const double flip = Json::parse(off.out).at("flip");
  const image::Layers read = image::read_exr(map);
  double sum = 0;
  for (const float v : read.channels.at(0).values) sum += v;
  EXPECT_NEAR(sum / 256, flip, 1e-7);
  EXPECT_GT(flip, 0);
}

void expect_shape(const Json& j, bool ran) {
  ASSERT_TRUE(j.contains("kernels"));
  for (const Json& kernel : j["kernels"]) {
    EXPECT_TRUE(kernel["name"].is_string());
    ASSERT_FALSE(kernel["variants"].empty());
    for (const Json& v : kernel["variants"]) {
      EXPECT_TRUE(v["name"].is_string() && v["baseline"].is_boolean()) << v;
      for (const char* count : {"trials", "cases", "violations", "undecided"}) EXPECT_TRUE(v[count].is_number()) << v;
      EXPECT_TRUE(v["bounds"].is_array());
      for (const Json& b : v["bounds"]) {
        EXPECT_TRUE(b["name"].is_string() && b["limit"].is_number() && b["reason"].is_string()) << b;
        EXPECT_TRUE(b.contains("worst") && (b["worst"].is_number() || !ran || v["baseline"])) << b;
      }
    }
  }
}

TEST(Cli, ListHasTheShapeOfCheck) {
  const Ran r = assay("list --json");
  EXPECT_EQ(r.code, 0);
  const Json j = Json::parse(r.out);
  expect_shape(j, false);
  EXPECT_EQ(j["kernels"].size(), all_kernels().size());
}

TEST(Cli, CheckWritesTheDocumentedJson) {
  const Folder folder;
  const std::string file = folder.file("deep/check.json");
  const Ran r = assay(fmt::format("check {} --trials 2 --json {}{}", first_kernel(), file, on_device()));
  EXPECT_EQ(r.code, 0) << r.out << r.err;
  EXPECT_TRUE(r.err.starts_with("device ")) << r.err;
  EXPECT_NE(r.out.find("limit"), std::string::npos);
  const Json j = Json::parse(text_of(file));
  expect_shape(j, true);
  ASSERT_EQ(j["kernels"].size(), 1u);
  EXPECT_EQ(j["kernels"][0]["variants"][0]["trials"], 2);
}

TEST(Cli, CheckRunsOneTrialOfASeed) {
  const Ran r = assay(fmt::format("check {} --seed 17 --json{}", first_kernel(), on_device()));
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(Json::parse(r.out)["kernels"][0]["variants"][0]["trials"], 1) << r.out;
}

TEST(Cli, BenchRecordsEverySample) {
  const Folder folder;
  const std::string file = folder.file("bench.json"), table = folder.file("bench.md"), runs = folder.file("runs");
  const Ran r = assay(fmt::format("bench {} --defaults --size 64x64 --samples 3 --json {} --markdown {} --runs {}{}",
                                  first_kernel(), file, table, runs, on_device()));
  EXPECT_EQ(r.code, 0) << r.out << r.err;
  const Json j = Json::parse(text_of(file));
  ASSERT_EQ(j["results"].size(), 1u);
  const Json& row = j["results"][0];
  EXPECT_EQ(row["samples"].size(), 3u);
  EXPECT_EQ(row["hot_samples"].size(), 3u);
  for (const Json& s : row["samples"]) EXPECT_GT(s["gpu_ns"].get<double>(), 0) << s;
  EXPECT_GT(row["limit_ns"].get<double>(), 0);
  EXPECT_GT(j["yardsticks"]["operations_per_s"].get<double>(), 0);
  EXPECT_GT(j["yardsticks"]["empty_dispatch_ns"].get<double>(), 0);
  for (const char* key : {"time", "commit", "device"}) EXPECT_TRUE(j.contains(key)) << key;
  EXPECT_NE(text_of(table).find("Speed of " + first_kernel() + " against"), std::string::npos) << text_of(table);
  EXPECT_EQ(std::distance(fs::directory_iterator(runs), {}), 1);
}

TEST(Cli, FrameWritesAPicture) {
  const Folder folder;
  const Ran r = assay(fmt::format("frame --scene bare --size 96x64 --out {} --json {}{}", folder.file("f"),
                                  folder.file("frame.json"), on_device()));
  ASSERT_EQ(r.code, 0) << r.out << r.err;
  const auto picture = image::read_png(folder.file("f/frame.png"));
  EXPECT_GE(picture.width, 96u);
  EXPECT_GT(picture.height, 64u);  // the legend below
  EXPECT_TRUE(Json::parse(text_of(folder.file("frame.json"))).contains("device"));
}

TEST(Cli, FrameExplains) {
  const Folder folder;
  const Ran r =
      assay(fmt::format("frame --scene bare --size 96x64 --explain --out {}{}", folder.file("f"), on_device()));
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.out.find("visibility.visibility"), std::string::npos) << r.out;
}

}  // namespace
}  // namespace assay::tests
