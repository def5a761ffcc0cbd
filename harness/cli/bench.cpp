// assay bench: times beside limits, and speed against error.
#include "harness/report/bench.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "harness/cli/command.h"
#include "harness/report/json.h"
#include "harness/report/progress.h"

namespace assay::cli {

namespace {

namespace fs = std::filesystem;

struct Flags {
  Common common;
  std::vector<std::string> kernels, sizes, cases;
  std::string variant, markdown, runs = "out/runs";
  bool defaults = false, all_sizes = false;
  uint32_t samples = 20;
};

// A new file each run; nothing that was measured is ever overwritten.
std::string record_file(const Flags& f) {
  std::string stamp = report::utc_now();
  std::erase_if(stamp, [](char c) { return c == '-' || c == ':'; });
  for (int n = 0;; ++n) {
    const fs::path file =
        fs::path(f.runs) / fmt::format("bench-{}-{}{}.json", stamp, getpid(), n ? fmt::format("-{}", n) : "");
    if (!fs::exists(file)) return file.string();
  }
}

int run(Flags& f) {
  report::Selection selection{.kernels = chosen_kernels(f.kernels),
                              .variant = f.variant,
                              .defaults_only = f.defaults,
                              .all_extents = f.all_sizes,
                              .cases = f.cases,
                              .fixtures = fixtures_folder()};
  must_have_variant(selection.kernels, f.variant);
  for (const auto& name : f.cases) must_have_case(selection.kernels, name);
  for (const auto& s : f.sizes) selection.extents.push_back(parse_size(s));
  const std::string record = f.runs == "none" ? "" : record_file(f);
  for (const auto& file : {f.common.json, f.markdown, record}) probe_writable(file);

  auto d = open_device(f.common);
  report::Progress progress;
  const auto tell = [&](const std::string& what, uint64_t done, uint64_t of) { progress.update(what, done, of); };
  const auto result = report::bench(*d, report::entries_of(selection), f.samples, tell);
  progress.clear();

  const auto& info = device::info(*d);
  const auto json = report::to_json(result, info);
  write_json(f.common, json);
  if (!record.empty()) {
    write_text(record, json.dump(1) + "\n");
    fmt::print(stderr, "every sample is in {}\n", record);
  }
  const auto by_kernel = [&](auto text_of) {
    std::string text;
    for (const Kernel* k : selection.kernels) {
      if (const auto table = report::speed_against_error_table(result, *k); !table.rows.empty())
        text += fmt::format("\nSpeed of {} against its error, fastest first\n\n{}", k->name, text_of(table));
      if (const auto table = report::error_table(result, *k); !table.rows.empty())
        text += fmt::format("\nErrors of {} by class of inputs, least first\n\n{}", k->name, text_of(table));
    }
    return text;
  };
  if (!f.markdown.empty())
    write_text(f.markdown, fmt::format("{} ({} {}), commit {}\n{}", info.name, info.driver, info.driver_info,
                                       report::commit(), by_kernel(report::as_markdown)));
  if (!json_on_stdout(f.common) && f.markdown != "-")
    fmt::print("{}\n{}{}", report::yardsticks_text(result), report::as_text(report::speed_table(result, info)),
               by_kernel(report::as_text));
  const auto missed = report::missed_goals(result.errors);
  for (const std::string& goal : missed) fmt::print(stderr, "{}\n", goal);
  const bool broken =
      !missed.empty() || std::ranges::any_of(result.rows, [](const report::Row& r) { return r.verified.broken; });
  const int spoken = validation_verdict(*d);
  return broken ? kViolation : spoken;
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  auto f = std::make_shared<Flags>();
  CLI::App* command = subcommand(
      app, "bench", "Times every variant beside what this device could do, and its speed beside its error",
      "Each variant is first verified against the oracle; one that breaks its bound is not timed (a baseline is).\n"
      "time: median GPU time, inputs rotated out of the cache; hot: the same input again and again; limit: the larger "
      "of\n"
      "bytes over the device's copy bandwidth and operations over its rate, plus its dispatches when empty; share: "
      "limit\n"
      "over time. Every run writes a new JSON file with every sample to --runs.",
      {"assay bench", "assay bench tile_classification --size 1920x1080 --size 3840x2160",
       "assay bench visibility --variant slim --samples 50 --json out/slim.json",
       "assay bench --defaults --markdown out/bench.md"});
  command->add_option("kernels", f->kernels, "Only these; all by default")->type_name("KERNEL");
  command->add_option("--variant", f->variant, "Only this variant, by name or with its constants");
  command->add_flag("--defaults", f->defaults, "Only each kernel's default variant");
  command->add_option("--size", f->sizes, "Repeatable; the kernel's first size by default")
      ->type_name("WxH")
      ->allow_extra_args(false);
  command->add_option("--case", f->cases, "Repeatable; this hard case or case file in place of sizes")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_flag("--all-sizes", f->all_sizes, "Every size that the kernel lists");
  command->add_option("--samples", f->samples, "Samples of a variant, each long enough for the device's clock")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000))
      ->type_name("N");
  command->add_option("--markdown", f->markdown, "The tables of speed against error as Markdown; - for standard output")
      ->type_name("FILE");
  command->add_option("--runs", f->runs, "Where each run's record goes, or none")
      ->capture_default_str()
      ->type_name("DIR");
  add_device_flags(command, f->common);
  add_json_flag(command, f->common, "The record as JSON, every sample in it");
  add_bench_particle_light(*command, action);
  add_bench_vrcs(*command, action);
  command->callback([&action, command, f] {
    if (command->get_subcommands().empty()) action = [f] { return run(*f); };
  });
}

}  // namespace assay::cli
