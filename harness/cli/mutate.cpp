// assay mutate: plants every listed fault and says whether the checks notice.
#include <fmt/format.h>

#include <algorithm>

#include "harness/check/check.h"
#include "harness/cli/command.h"
#include "harness/report/json.h"
#include "harness/report/progress.h"
#include "harness/report/table.h"

namespace assay::cli {

namespace {

struct Flags {
  Common common;
  std::vector<std::string> kernels;
  uint32_t trials = 50;
};

int run(const Flags& f) {
  std::vector<std::string> names;
  for (const Kernel* k : chosen_kernels(f.kernels)) names.push_back(k->name);
  probe_writable(f.common.json);
  auto d = open_device(f.common);
  report::Progress progress;
  const auto tell = [&](const std::string& what, uint64_t done, uint64_t of) { progress.update(what, done, of); };
  const auto results = check::mutate(d, device_options(f.common), names, f.trials, tell);
  progress.clear();
  const auto killed = std::ranges::count_if(results, [](const auto& m) { return !m.killed_by.empty(); });
  write_json(f.common, report::to_json(results));
  if (!json_on_stdout(f.common)) {
    report::Table t{
        .columns = {{"kernel"}, {"variant"}, {"file"}, {"n", report::Align::right}, {"killed by"}, {"fault"}}};
    for (const auto& m : results)
      t.rows.push_back(
          {m.kernel, m.variant, m.file, std::to_string(m.n), m.killed_by.empty() ? "SURVIVED" : m.killed_by, m.fault});
    fmt::print("{}", report::as_text(t));
    const double share = results.empty() ? 0 : static_cast<double>(killed) / static_cast<double>(results.size());
    fmt::print("mutation score {} ({} of {} killed)\n", report::percent_text(share), killed, results.size());
  }
  return static_cast<size_t>(killed) == results.size() ? kSuccess : kViolation;
}

}  // namespace

void add_mutate(CLI::App& app, Action& action) {
  auto f = std::make_shared<Flags>();
  CLI::App* command = subcommand(
      app, "mutate", "Plants each kernel's listed faults and prints how many the checks notice",
      "A fault is a line behind #ifdef MUTANT_n in a shader; it is run in every variant that uses the file, first on\n"
      "the case that should notice it. Exit 1 if one survives.",
      {"assay mutate", "assay mutate tile_classification --trials 200"});
  command->add_option("kernels", f->kernels, "Only these; all by default")->type_name("KERNEL");
  command->add_option("--trials", f->trials, "Random trials where no hard case notices")
      ->capture_default_str()
      ->type_name("N");
  add_device_flags(command, f->common);
  add_json_flag(command, f->common, "Results as JSON");
  command->callback([&action, f] { action = [f] { return run(*f); }; });
}

}  // namespace assay::cli
