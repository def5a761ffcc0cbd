#include "harness/check/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "harness/check/kernel_run.h"
#include "harness/nearest.h"

namespace assay::check {

namespace {

void step(const KernelRun& run, uint64_t done, uint64_t of) {
  if (run.options.progress) run.options.progress(run.kernel.name, done, of);
}

bool any_live(const KernelRun& run) { return std::ranges::any_of(run.variants, &VariantState::is_live); }

void run_named(KernelRun& run, const std::vector<NamedCase>& cases, Kind kind, uint64_t done, uint64_t of) {
  for (size_t i = 0; i < cases.size() && any_live(run); ++i) {
    step(run, done + i, of);
    Case c = cases[i].make();
    if (c.name.empty()) c.name = cases[i].name;
    const uint32_t limit = run.options.extent_limit;
    if (limit != 0 && std::max(c.extent.width, c.extent.height) > limit) continue;
    c.judge_all = run.options.nightly;
    const Prepared prepared = prepare(run.kernel, std::move(c), device::info(*run.session.device).traits);
    run_everywhere(run, prepared, cases[i].replay, kind);
  }
}

struct PreparedTrial {
  Trial trial;
  Prepared prepared;
};

PreparedTrial prepare_trial(const Kernel& kernel, uint64_t seed, const DeviceTraits& traits, bool judge_all) {
  Trial trial = random_case(kernel, seed);
  trial.input.judge_all = judge_all;
  Prepared prepared = prepare(kernel, std::move(trial.input), traits);
  trial.input = {.extent = prepared.input.extent};
  return {std::move(trial), std::move(prepared)};
}

// The next trial's input and oracle are worked out while the device runs this one's.
void run_trials(KernelRun& run, uint64_t first_seed, uint64_t trials, uint64_t done, uint64_t of) {
  const DeviceTraits traits = device::info(*run.session.device).traits;
  const auto begin = [&](uint64_t t) {
    return std::async(std::launch::async,
                      [&kernel = run.kernel, seed = first_seed + t, traits, all = run.options.nightly] {
                        return prepare_trial(kernel, seed, traits, all);
                      });
  };
  Coverage coverage;
  std::future<PreparedTrial> next = trials > 0 ? begin(0) : std::future<PreparedTrial>{};
  for (uint64_t t = 0; t < trials && any_live(run); ++t) {
    step(run, done + t, of);
    const PreparedTrial now = next.get();
    if (t + 1 < trials) next = begin(t + 1);
    note(coverage, now.trial);
    run.of_trials.emplace_back();
    run_everywhere(run, now.prepared, fmt::format("--seed {}", first_seed + t), Kind::trial);
  }
  for (std::string& complaint : complaints(coverage, run.kernel.inputs.branches))
    run.result.complaints.push_back(std::move(complaint));
  run.result.branches = std::move(coverage.branches);
}

// An error estimated from fewer is none; the typical input is judged always.
constexpr size_t kTellingTrials = 30;

// Parts that few trials make up (two surfaces in one plane) come in lumps: the limit is broken where the trials show it
// at three standard errors of the ratio, a trial being one observation.
double standard_error(const std::vector<Share>& shares, const Share& sum) {
  const double judged = static_cast<double>(sum.judged), part = static_cast<double>(sum.undecided) / judged;
  double squares = 0;
  for (const Share& s : shares) {
    const double rest = static_cast<double>(s.undecided) - part * static_cast<double>(s.judged);
    squares += rest * rest;
  }
  return std::sqrt(squares) / judged;
}

void judge_undecided(KernelRun& run, const std::vector<Share>& shares, const char* of) {
  Share sum;
  for (const Share& s : shares) sum = {sum.judged + s.judged, sum.undecided + s.undecided};
  if (sum.judged == 0) return;
  const double part = static_cast<double>(sum.undecided) / static_cast<double>(sum.judged);
  const double error = shares.size() > 1 ? standard_error(shares, sum) : 0;
  if (part - 3 * error <= run.kernel.undecided_limit) return;
  run.result.complaints.push_back(fmt::format(
      "{} of {} elements of {} are undecided, {:.3g}; the limit is {:g}{}{}", sum.undecided, sum.judged, of, part,
      run.kernel.undecided_limit, run.kernel.undecided_reason.empty() ? "" : ": ", run.kernel.undecided_reason));
}

constexpr uint64_t kFirstSeed = 1;

// A fault of the kernel's own code (generator, oracle, description) ends its check, not the whole one.
void run_cases(KernelRun& run) {
  const Options& o = run.options;
  std::vector<NamedCase> hard, typical;
  if (o.case_name == kTypical) {
    typical = typical_case(run.kernel);
  } else if (!o.case_name.empty()) {
    hard = cases_named(run.kernel, o.fixtures, o.case_name);
  } else if (o.hard && !o.seed) {
    hard = hard_cases(run.kernel, o.fixtures, o.nightly);
    typical = typical_case(run.kernel);
  }
  const uint64_t trials = o.case_name.empty() ? o.trials : 0;
  const uint64_t named = hard.size() + typical.size(), of = named + trials;
  run_named(run, hard, Kind::hard, 0, of);
  run_named(run, typical, Kind::typical, hard.size(), of);
  run_trials(run, o.seed.value_or(kFirstSeed), trials, named, of);
  step(run, of, of);
}

// What users get unasked, the frame among them, must be held to its bounds.
void judge_default(KernelRun& run) {
  for (const Variant& v : run.kernel.variants)
    if (v.baseline && v.name == run.kernel.default_variant)
      run.result.complaints.push_back(fmt::format("the default variant, {}, is a baseline", v.name));
}

void finish(KernelRun& run) {
  if (run.options.variant.empty() && !run.options.defaults) {  // the limit is of all variants together
    judge_undecided(run, {run.of_typical}, "the typical input");
    if (run.of_trials.size() >= kTellingTrials) judge_undecided(run, run.of_trials, "random trials");
  }
  judge_default(run);
  const auto ran = [](const VariantState& s) { return s.result.skipped.empty(); };
  if (!std::ranges::any_of(run.variants, ran)) run.result.complaints.push_back("no variant can run on this device");
  for (VariantState& state : run.variants) run.result.variants.push_back(std::move(state.result));
}

void require_variant(const std::vector<const Kernel*>& kernels, const std::string& wanted) {
  std::vector<std::string> names;
  for (const Kernel* kernel : kernels)
    for (const Variant& variant : kernel->variants) {
      if (is_selected(variant, wanted)) return;
      names.push_back(variant.name);
    }
  throw std::invalid_argument(fmt::format("no variant '{}'{}", wanted, did_you_mean(wanted, names)));
}

void require_case(const std::vector<const Kernel*>& kernels, const Options& options) {
  std::vector<std::string> names;
  for (const Kernel* kernel : kernels) {
    if (!cases_named(*kernel, options.fixtures, options.case_name).empty()) return;
    for (const NamedCase& c : hard_cases(*kernel, options.fixtures, true)) names.push_back(c.name);
  }
  if (is_case_path(options.case_name))
    throw std::invalid_argument(options.case_name + ": a case of kernel " + kernel_of_case(options.case_name));
  throw std::invalid_argument(fmt::format("no case '{}'{}", options.case_name, did_you_mean(options.case_name, names)));
}

// Kernels that the options leave: those named, or all, less those without the variant or the case asked for.
std::vector<const Kernel*> selected(const Options& options) {
  std::vector<const Kernel*> kernels;
  for (const std::string& name : options.kernels) kernels.push_back(&kernel_named(name));
  if (options.kernels.empty())
    for (const Kernel& kernel : all_kernels()) kernels.push_back(&kernel);
  require_variant(kernels, options.variant);
  if (!options.case_name.empty()) require_case(kernels, options);
  std::erase_if(kernels, [&](const Kernel* kernel) {
    const auto wanted = [&](const Variant& v) { return is_selected(v, options.variant); };
    return std::ranges::none_of(kernel->variants, wanted) ||
           (!options.case_name.empty() && cases_named(*kernel, options.fixtures, options.case_name).empty());
  });
  return kernels;
}

}  // namespace

KernelResult check_kernel(device::Handle& handle, const device::Options& device_options, const Options& options,
                          const Kernel& kernel) {
  KernelRun run = start({handle, device_options}, options, kernel);
  try {
    run_cases(run);
  } catch (const device::NoSuchDevice&) {
    throw;  // the replacement of a lost device is gone: nothing more can be checked
  } catch (const std::logic_error& e) {
    run.result.complaints.push_back(e.what());
  }
  finish(run);
  return std::move(run.result);
}

std::vector<KernelResult> check(device::Handle& handle, const device::Options& device_options, const Options& options) {
  std::vector<KernelResult> results;
  const auto kernels = selected(options);
  for (const Kernel* kernel : kernels) {
    Options mine = options;
    mine.progress = part_of(options.progress, results.size(), kernels.size());
    results.push_back(check_kernel(handle, device_options, mine, *kernel));
  }
  return results;
}

bool passed(const std::vector<KernelResult>& results) {
  return std::ranges::all_of(results, [](const KernelResult& kernel) {
    return kernel.complaints.empty() &&
           std::ranges::all_of(kernel.variants, [](const VariantResult& v) { return v.violations == 0; });
  });
}

}  // namespace assay::check
