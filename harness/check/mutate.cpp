// Mutants: one-line faults that the cases must find. What survives shows a hole in the tests.
#include <fmt/format.h>

#include <algorithm>
#include <list>

#include "harness/check/kernel_run.h"

namespace assay::check {

namespace {

std::vector<std::string> shader_files(const Variant& variant) {
  std::vector<std::string> files;
  for (const Pass& pass : variant.passes) {
    if (const auto* dispatch = std::get_if<Dispatch>(&pass)) files.push_back(dispatch->shader);
    if (const auto* draw = std::get_if<Draw>(&pass))
      for (const DrawCall& call : draw->calls) files.insert(files.end(), {call.vertex, call.fragment});
  }
  std::erase(files, "");  // a depth-only draw has no fragment shader
  return files;
}

// The mutant's file may be included by the shader rather than be it: what counts is that the fault was compiled in.
bool uses(const Kernel& kernel, const Variant& variant, const Mutant& mutant) {
  return std::ranges::any_of(shader_files(variant), [&](const std::string& file) {
    return device::shader(kernel.name, file, mutant.n).mutant == mutant.n;
  });
}

// Cases with their oracle's answers, the last few kept: the mutants of a kernel share their cases.
class PreparedCases {
 public:
  PreparedCases(const Kernel& kernel, const DeviceTraits& traits) : kernel_(kernel), traits_(traits) {}
  const Prepared& get(const NamedCase& c) {
    const auto it = std::ranges::find(kept_, c.name, &Kept::name);
    if (it != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, it);
    } else {
      kept_.push_front({c.name, prepare(kernel_, c.make(), traits_)});
      if (kept_.size() > kMost) kept_.pop_back();
    }
    return kept_.front().prepared;
  }

 private:
  static constexpr size_t kMost = 16;
  struct Kept {
    std::string name;
    Prepared prepared;
  };
  const Kernel& kernel_;
  DeviceTraits traits_;
  std::list<Kept> kept_;
};

uint64_t wrong_elements(const Outcome& outcome) {
  uint64_t wrong = 0;
  for (const Verdict& v : outcome.verdicts) wrong += v.violations;
  return wrong;
}

struct Hunt {
  Session session;
  const Kernel& kernel;
  const Variant& variant;
  const Mutant& mutant;
  PreparedCases& prepared;

  Outcome run(const std::map<std::string, uint32_t>& constants, const Prepared& c, const Mutant* faulty) {
    const device::Plan plan{.kernel = &kernel, .variant = &variant, .constants = constants, .mutant = faulty};
    device::Ports ports;
    return attempt(session, plan, c, ports, true);
  }
  // A baseline may break its bounds unmutated; there the fault has to make more elements wrong.
  bool kills(const NamedCase& named) {
    const Prepared& c = prepared.get(named);
    for (const auto& constants : device::combinations(variant)) {
      const Outcome faulty = run(constants, c, &mutant);
      if (!fault_of(faulty, variant).text.empty()) return true;
      if (variant.baseline && wrong_elements(faulty) > wrong_elements(run(constants, c, nullptr))) return true;
    }
    return false;
  }
};

std::string killer(Hunt& hunt, const std::vector<NamedCase>& hard, uint32_t trials) {
  const auto named = std::ranges::find(hard, hunt.mutant.killed_by, &NamedCase::name);
  if (named != hard.end() && hunt.kills(*named)) return named->name;
  for (const NamedCase& c : hard)
    if (c.name != hunt.mutant.killed_by && hunt.kills(c)) return c.name;
  for (uint64_t seed = 1; seed <= trials; ++seed) {
    const NamedCase trial{fmt::format("seed{}", seed), [&] { return random_case(hunt.kernel, seed).input; }, ""};
    if (hunt.kills(trial)) return trial.name;
  }
  return "";
}

// The daily cases and whichever nightly ones a mutant names.
std::vector<NamedCase> hunting_cases(const Kernel& kernel) {
  auto cases = hard_cases(kernel, "", true);
  std::erase_if(cases, [&](const NamedCase& c) {
    const auto hard = std::ranges::find(kernel.inputs.hard, c.name, &HardCase::name);
    return hard->nightly && std::ranges::find(kernel.mutants, c.name, &Mutant::killed_by) == kernel.mutants.end();
  });
  return cases;
}

}  // namespace

std::vector<MutantResult> mutate_kernel(device::Handle& handle, const device::Options& device_options,
                                        const Kernel& kernel, uint32_t trials) {
  std::vector<MutantResult> results;
  const auto hard = hunting_cases(kernel);
  PreparedCases prepared(kernel, device::info(*handle).traits);
  for (const Mutant& mutant : kernel.mutants) {
    bool used = false;
    for (const Variant& variant : kernel.variants) {
      if (!uses(kernel, variant, mutant)) continue;
      used = true;
      if (!device::missing(device::info(*handle), variant).empty()) continue;
      Hunt hunt{{handle, device_options}, kernel, variant, mutant, prepared};
      results.push_back({kernel.name, variant.name, mutant.file, mutant.fault, killer(hunt, hard, trials), mutant.n,
                         mutant.killed_by});
    }
    if (!used)
      throw std::logic_error(
          fmt::format("{}: no variant compiles MUTANT_{} of {}", kernel.name, mutant.n, mutant.file));
  }
  return results;
}

std::vector<MutantResult> mutate(device::Handle& handle, const device::Options& device_options,
                                 const std::vector<std::string>& kernels, uint32_t trials) {
  std::vector<const Kernel*> chosen;
  chosen.reserve(all_kernels().size());
  for (const std::string& name : kernels) chosen.push_back(&kernel_named(name));
  if (kernels.empty())
    for (const Kernel& kernel : all_kernels()) chosen.push_back(&kernel);
  std::vector<MutantResult> results;
  for (const Kernel* kernel : chosen)
    std::ranges::move(mutate_kernel(handle, device_options, *kernel, trials), std::back_inserter(results));
  return results;
}

}  // namespace assay::check
