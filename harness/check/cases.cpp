#include "harness/check/cases.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/oracle.h"

namespace assay::check {

namespace fs = std::filesystem;

namespace {

std::vector<NamedCase> fixture_cases(const Kernel& kernel, const fs::path& fixtures) {
  std::vector<fs::path> files;
  const fs::path folder = fixtures / kernel.name;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".case") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<NamedCase> cases;
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    cases.push_back({name, [file, &kernel] { return load_case(file, kernel); }, "--case " + name});
  }
  return cases;
}

}  // namespace

std::vector<NamedCase> hard_cases(const Kernel& kernel, const fs::path& fixtures, bool nightly) {
  std::vector<NamedCase> cases;
  for (const HardCase& hard : kernel.inputs.hard)
    if (nightly || !hard.nightly) cases.push_back({hard.name, hard.make, "--case " + hard.name});
  for (NamedCase& fixture : fixture_cases(kernel, fixtures)) cases.push_back(std::move(fixture));
  return cases;
}

std::vector<NamedCase> typical_case(const Kernel& kernel) {
  if (!kernel.typical || kernel.extents.empty()) return {};
  const auto make = [&kernel] {
    Case c = kernel.typical(kernel.extents.front());
    c.name = kTypical;
    return c;
  };
  return {{kTypical, make, std::string("--case ") + kTypical}};
}

bool is_case_path(const std::string& name) {
  return name.find('/') != std::string::npos || fs::path(name).extension() == ".case";
}

std::vector<NamedCase> cases_named(const Kernel& kernel, const fs::path& fixtures, const std::string& name) {
  if (is_case_path(name)) {
    if (kernel_of_case(name) != kernel.name) return {};
    return {{fs::path(name).stem().string(), [name, &kernel] { return load_case(name, kernel); }, "--case " + name}};
  }
  if (name == kTypical) return typical_case(kernel);
  auto cases = hard_cases(kernel, fixtures, true);
  std::erase_if(cases, [&](const NamedCase& c) { return c.name != name; });
  return cases;
}

namespace {

constexpr uint32_t kWidePixels = 4 * 32;

// A kernel may work on lists or cells rather than pixels.
uint64_t items_of(const Kernel& kernel, const Case& c) {
  uint64_t items = pixels(c);
  for (const Port& p : kernel.ports)
    if (p.kind == PortKind::buffer && p.count) items = std::max(items, p.count(c));
  return items;
}

bool is_wide(const Kernel& kernel, const Trial& trial) {
  const Extent e = trial.input.extent;
  if (std::ranges::find(kernel.ports, PortKind::image, &Port::kind) == kernel.ports.end())
    return trial.items > uint64_t{kWidePixels} * kWidePixels;
  return e.width > kWidePixels && e.height > kWidePixels;
}

}  // namespace

Trial random_case(const Kernel& kernel, uint64_t seed) {
  Random random(seed);
  Trial trial{.input = kernel.inputs.random(random)};
  trial.input.seed = seed;
  trial.input.name = fmt::format("seed{}", seed);
  trial.items = items_of(kernel, trial.input);
  trial.wide = is_wide(kernel, trial);
  trial.taken = std::move(random.taken);
  return trial;
}

namespace {

constexpr uint64_t kLargeItems = 100000;
constexpr uint64_t kEnoughTrials = 1000;

}  // namespace

void note(Coverage& coverage, const Trial& trial) {
  ++coverage.trials;
  coverage.wide += trial.wide;
  coverage.large += trial.items > kLargeItems;
  for (const std::string& branch : trial.taken) ++coverage.branches[branch];
}

std::vector<std::string> complaints(const Coverage& coverage, const std::vector<std::string>& declared) {
  std::vector<std::string> found;
  for (const auto& [branch, times] : coverage.branches)
    if (std::ranges::find(declared, branch) == declared.end())
      found.push_back(fmt::format("the generator took branch {}, which inputs.branches does not declare", branch));
  if (coverage.trials < kEnoughTrials) return found;
  const auto share = [&](uint64_t n) { return static_cast<double>(n) / static_cast<double>(coverage.trials); };
  for (const std::string& branch : declared) {
    const auto it = coverage.branches.find(branch);
    const uint64_t times = it == coverage.branches.end() ? 0 : it->second;
    if (!(share(times) >= 0.01))
      found.push_back(fmt::format("branch {} fired in {} of {} trials, under 1 %", branch, times, coverage.trials));
  }
  if (!(share(coverage.wide) >= 0.3))
    found.push_back(
        fmt::format("{} of {} trials span over 4 tiles a side, under 30 %", coverage.wide, coverage.trials));
  if (!(share(coverage.large) >= 0.05))
    found.push_back(fmt::format("{} of {} trials hold over 100,000 items, under 5 %", coverage.large, coverage.trials));
  return found;
}

}  // namespace assay::check
