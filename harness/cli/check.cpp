// assay check: every variant against its oracle.
#include "harness/check/check.h"

#include <fmt/format.h>

#include "harness/check/cases.h"
#include "harness/cli/command.h"
#include "harness/nearest.h"
#include "harness/report/json.h"
#include "harness/report/progress.h"
#include "harness/report/table.h"

namespace assay::cli {

namespace {

struct Flags {
  Common common;
  check::Options options;
  uint64_t seed = 0;
};

std::string verdict_text(const check::VariantResult& v) {
  if (!v.skipped.empty()) return "skipped: " + v.skipped;
  std::string text = v.violations == 0 ? "ok" : fmt::format("{} VIOLATIONS", v.violations);
  if (v.baseline)
    text = fmt::format("baseline, {}, {} of {} wrong, {} NaN",
                       v.failures.empty() ? "held to memory safety only" : "UNSAFE", v.wrong, v.judged, v.nans);
  if (v.undecided) text += fmt::format(", {} of {} undecided", v.undecided, v.judged);
  if (v.flaky) text += fmt::format(", FLAKY: device lost and repeated {} times", v.flaky);
  return text;
}

void print(const check::KernelResult& k) {
  fmt::print("{}\n", k.name);
  report::Table t{.columns = {{"  variant"},
                              {"trials", report::Align::right},
                              {"cases", report::Align::right},
                              {"bound"},
                              {"limit", report::Align::right},
                              {"worst", report::Align::right},
                              {"reason"}}};
  for (const auto& v : k.variants) {
    t.rows.push_back({"  " + v.name, std::to_string(v.trials), std::to_string(v.cases), verdict_text(v), "", "", ""});
    if (v.skipped.empty())
      for (const auto& b : v.bounds)
        t.rows.push_back(
            {"", "", "", "  " + b.name, report::number_text(b.limit), report::number_text(b.worst), b.reason});
  }
  fmt::print("{}", report::as_text(t));
  for (const auto& c : k.complaints) fmt::print("  COMPLAINT: {}\n", c);
  for (const auto& v : k.variants)
    for (const auto& f : v.failures)
      fmt::print("\n  FAILURE {}\n  replay: {}\n{}", f.text, f.replay,
                 f.file.empty() ? "" : "  case: " + f.file.string() + "\n");
  fmt::print("\n");
}

int run(Flags& f) {
  const auto kernels = chosen_kernels(f.options.kernels);
  must_have_variant(kernels, f.options.variant);
  if (!f.options.case_name.empty()) must_have_case(kernels, f.options.case_name);
  probe_writable(f.common.json);
  auto d = open_device(f.common);
  report::Progress progress;
  f.options.progress = [&](const std::string& what, uint64_t done, uint64_t of) { progress.update(what, done, of); };
  const auto results = check::check(d, device_options(f.common), f.options);
  progress.clear();
  if (!json_on_stdout(f.common))
    for (const auto& k : results) print(k);
  write_json(f.common, report::to_json(results));
  const int spoken = d ? validation_verdict(*d) : kSuccess;
  if (!json_on_stdout(f.common))
    fmt::print("{}\n", check::passed(results) ? "every bound holds" : "NOT every bound holds");
  return check::passed(results) ? spoken : kViolation;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto f = std::make_shared<Flags>();
  f->options.fixtures = fixtures_folder();
  CLI::App* command = subcommand(
      app, "check", "Runs every variant against its oracle: hard cases, the typical input, then random trials",
      "Prints each bound's limit, the worst value seen and the reason. A failure prints one command that replays it,\n"
      "and its shrunk case is written to out/failures. Exit 1 if a bound is broken.",
      {"assay check", "assay check tile_classification --trials 1000",
       "assay check visibility --variant slim --case shared_edges",
       "assay check visibility --seed 17            one trial, as a failure prints it",
       "assay check --json out/check.json --validation sync"});
  command->add_option("kernels", f->options.kernels, "Only these; all by default")->type_name("KERNEL");
  auto* variant = command->add_option("--variant", f->options.variant,
                                      "Only this variant, by name or with its constants, as in reduce[WIDTH=4]");
  command->add_flag("--defaults", f->options.defaults, "Only each kernel's default variant")->excludes(variant);
  command->add_option("--case", f->options.case_name,
                      "Only this hard case, fixture or case file, or the typical input; no random trials");
  auto* seed =
      command->add_option("--seed", f->seed, "Only this random trial, or with --trials so many from this one on");
  auto* trials = command->add_option("--trials", f->options.trials, "Random trials a variant");
  trials->capture_default_str()->type_name("N");
  command->add_flag("--nightly", f->options.nightly, "The large cases too, oracles unsampled");
  add_device_flags(command, f->common);
  add_json_flag(command, f->common, "Results as JSON");
  command->callback([&action, f, seed, trials] {
    if (seed->count() > 0) {
      f->options.seed = f->seed;
      if (trials->count() == 0) f->options.trials = 1;
    }
    action = [f] { return run(*f); };
  });
}

}  // namespace assay::cli
