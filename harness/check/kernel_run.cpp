#include "harness/check/kernel_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/check/shrink.h"

namespace assay::check {

bool is_selected(const Variant& variant, const std::string& wanted) {
  if (wanted.empty() || wanted == variant.name) return true;
  for (const auto& constants : device::combinations(variant))
    if (device::label_of(variant, constants) == wanted) return true;
  return false;
}

Tell part_of(const Tell& tell, size_t part, size_t of) {
  if (!tell || of < 2) return tell;
  return [&tell, part, of](const std::string& what, uint64_t done, uint64_t whole) {
    tell(fmt::format("{} ({} of {})", what, part + 1, of), part * whole + done, of * whole);
  };
}

KernelRun start(Session session, const Options& options, const Kernel& kernel) {
  KernelRun run{session, options, kernel, {.name = kernel.name}, {}};
  for (const Variant& variant : kernel.variants) {
    if (!is_selected(variant, options.variant)) continue;
    if (options.defaults && variant.name != kernel.default_variant) continue;
    VariantState state{&variant, device::combinations(variant), {.name = variant.name, .baseline = variant.baseline}};
    if (!options.variant.empty() && options.variant != variant.name) {
      state.result.name = options.variant;
      std::erase_if(state.combinations, [&](const auto& c) { return device::label_of(variant, c) != options.variant; });
    }
    state.result.skipped = device::missing(device::info(*session.device), variant);
    for (const Bound& bound : bounds_for(kernel, variant))
      state.result.bounds.push_back({name_of(bound), bound.limit, 0, bound.reason});
    run.variants.push_back(std::move(state));
  }
  return run;
}

namespace {

void tally(KernelRun& run, VariantState& state, const Outcome& outcome, Kind kind) {
  const auto bounds = bounds_for(run.kernel, *state.variant);
  for (size_t i = 0; i < outcome.verdicts.size(); ++i) {
    const Verdict& v = outcome.verdicts[i];
    BoundResult& bound = state.result.bounds[i];
    bound.worst = std::max(bound.worst, v.worst);
    state.result.judged += v.judged;
    state.result.undecided += v.undecided;
    state.result.wrong += v.violations;
    state.result.nans += v.nans;
    if (kind == Kind::hard) state.result.hard_undecided += v.undecided;
    if (kind == Kind::hard || (bounds[i].judge != Judge::between && bounds[i].judge != Judge::bits)) continue;
    Share& share = kind == Kind::typical ? run.of_typical : run.of_trials.back();
    share.judged += v.judged;
    share.undecided += v.undecided;
  }
  state.result.flaky += outcome.flaky;
}

// Runs a smaller case from scratch; it counts when it fails in the same way.
bool fails_alike(KernelRun& run, const device::Plan& plan, const Case& c, const std::string& kind) {
  const Prepared prepared = prepare(run.kernel, c, device::info(*run.session.device).traits);
  device::Ports ports;
  return fault_of(attempt(run.session, plan, prepared, ports, true), *plan.variant).kind == kind;
}

std::string file_name(const std::string& text) {
  std::string name = text;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  return name;
}

// A hang costs a minute a try and messages are about the commands, not the data: neither is made smaller.
void add_shrunk_case(KernelRun& run, const device::Plan& plan, const Case& c, const Fault& fault, Failure& failure) {
  if (fault.kind == "device lost" || fault.kind == "validation") return;
  const Shrunk shrunk =
      shrink(run.kernel, c, [&](const Case& smaller) { return fails_alike(run, plan, smaller, fault.kind); });
  failure.file =
      run.options.failures / fmt::format("{}-{}-{}.case", run.kernel.name,
                                         file_name(device::label_of(*plan.variant, plan.constants)), file_name(c.name));
  save_case(failure.file, run.kernel, shrunk.input);
  failure.text += fmt::format("\n  shrunk to {}x{} pixels in {} steps: {}", shrunk.input.extent.width,
                              shrunk.input.extent.height, shrunk.steps, failure.file.string());
}

void report(KernelRun& run, VariantState& state, const device::Plan& plan, const Case& c, const Fault& fault,
            const std::string& replay) {
  const std::string label = device::label_of(*state.variant, plan.constants);
  ++state.result.violations;
  if (state.result.violations > kFailuresStop) return;
  Failure failure;
  failure.text = fmt::format("{} {}, case {}, seed {}: {}", run.kernel.name, label, c.name, c.seed, fault.text);
  failure.replay = fmt::format("build/assay check {} --variant {} {}", run.kernel.name, state.variant->name, replay);
  if (state.result.violations <= kFailuresShrunk) add_shrunk_case(run, plan, c, fault, failure);
  if (state.result.violations == kFailuresStop)
    failure.text += fmt::format("\n  {} failures: {} is not run further", kFailuresStop, label);
  state.result.failures.push_back(std::move(failure));
}

void collect_messages(KernelRun& run, VariantState& state, const device::Plan& plan, const Case& c,
                      const std::string& replay) {
  if (run.session.options.validation == device::Validation::off) return;
  const auto messages = device::validation_messages(*run.session.device);
  if (messages.empty()) return;
  const Fault fault{"validation", fmt::format("validation: {}", fmt::join(messages, " | "))};
  report(run, state, plan, c, fault, replay);
}

void run_variant(KernelRun& run, VariantState& state, const Prepared& prepared, device::Ports& ports,
                 const std::string& replay, Kind kind) {
  std::vector<std::map<std::string, uint32_t>> combinations = state.combinations;
  if (kind == Kind::typical) combinations.resize(1);
  if (kind == Kind::trial) combinations = {combinations[prepared.input.seed % combinations.size()]};
  for (const auto& constants : combinations) {
    const device::Plan plan{.kernel = &run.kernel, .variant = state.variant, .constants = constants};
    const Outcome outcome = attempt(run.session, plan, prepared, ports, kind != Kind::trial);
    tally(run, state, outcome, kind);
    const Fault& fault = fault_of(outcome, *state.variant);
    if (!fault.text.empty()) report(run, state, plan, prepared.input, fault, replay);
    collect_messages(run, state, plan, prepared.input, replay);
  }
  ++(kind == Kind::trial ? state.result.trials : state.result.cases);
}

}  // namespace

void run_everywhere(KernelRun& run, const Prepared& prepared, const std::string& replay, Kind kind) {
  device::Ports ports;
  for (VariantState& state : run.variants) {
    if (!state.is_live()) continue;
    try {
      run_variant(run, state, prepared, ports, replay, kind);
    } catch (const std::logic_error& e) {  // shader, description and oracle at odds: running more cases tells no more
      state.is_broken = true;
      run.result.complaints.push_back(
          fmt::format("{} {}, case {}: {}", run.kernel.name, state.variant->name, prepared.input.name, e.what()));
    }
  }
}

}  // namespace assay::check
