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

// Variants in which the fault must be found.
std::vector<const Variant*> carriers(const Kernel& kernel, const Mutant& mutant) {
  std::vector<const Variant*> found;
  for (const Variant& variant : kernel.variants)
    if (uses(kernel, variant, mutant)) found.push_back(&variant);
  if (found.empty())
    throw std::logic_error(fmt::format("{}: no variant compiles MUTANT_{} of {}", kernel.name, mutant.n, mutant.file));
  if (!std::ranges::all_of(found, &Variant::baseline)) std::erase_if(found, &Variant::baseline);
  return found;
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

struct Hunt {
  Session session;
  const Kernel& kernel;
  const Variant& variant;
  const Mutant& mutant;
  PreparedCases& prepared;

  bool kills(const NamedCase& named) {
    const Prepared& c = prepared.get(named);
    return std::ranges::any_of(device::combinations(variant), [&](const auto& constants) {
      const device::Plan plan{.kernel = &kernel, .variant = &variant, .constants = constants, .mutant = &mutant};
      device::Ports ports;
      return !fault_of(attempt(session, plan, c, ports, true), variant).text.empty();
    });
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
                                        const Kernel& kernel, uint32_t trials, const Tell& tell) {
  std::vector<std::pair<const Mutant*, const Variant*>> hunts;
  for (const Mutant& mutant : kernel.mutants)
    for (const Variant* variant : carriers(kernel, mutant))
      if (device::missing(device::info(*handle), *variant).empty()) hunts.emplace_back(&mutant, variant);
  std::vector<MutantResult> results;
  const auto hard = hunting_cases(kernel);
  PreparedCases prepared(kernel, device::info(*handle).traits);
  for (const auto& [mutant, variant] : hunts) {
    if (tell) tell(fmt::format("{} {} MUTANT_{}", kernel.name, variant->name, mutant->n), results.size(), hunts.size());
    Hunt hunt{{handle, device_options}, kernel, *variant, *mutant, prepared};
    results.push_back({kernel.name, variant->name, mutant->file, mutant->fault, killer(hunt, hard, trials), mutant->n,
                       mutant->killed_by});
  }
  return results;
}

std::vector<MutantResult> mutate(device::Handle& handle, const device::Options& device_options,
                                 const std::vector<std::string>& kernels, uint32_t trials, const Tell& tell) {
  std::vector<const Kernel*> chosen;
  chosen.reserve(all_kernels().size());
  for (const std::string& name : kernels) chosen.push_back(&kernel_named(name));
  if (kernels.empty())
    for (const Kernel& kernel : all_kernels()) chosen.push_back(&kernel);
  std::vector<MutantResult> results;
  for (size_t i = 0; i < chosen.size(); ++i)
    std::ranges::move(mutate_kernel(handle, device_options, *chosen[i], trials, part_of(tell, i, chosen.size())),
                      std::back_inserter(results));
  return results;
}

}  // namespace assay::check
