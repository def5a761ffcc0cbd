// assay list: kernels, variants, ports and hard cases.
#include <fmt/format.h>

#include "harness/check/judge.h"
#include "harness/cli/command.h"
#include "harness/report/json.h"

namespace assay::cli {

namespace {

std::string constants_text(const Variant& v) {
  std::string text;
  for (const Constant& c : v.constants) text += fmt::format(" {}={}", c.name, fmt::join(c.values, ","));
  return text;
}

std::string port_text(const Port& p) {
  const char* use = p.use == Use::reads ? "reads" : p.use == Use::writes ? "writes" : "updates";
  switch (p.kind) {
    case PortKind::buffer:
      return fmt::format("{} {}, {} bytes an element", use, p.name, p.layout.stride);
    case PortKind::image:
      return fmt::format("{} {}, image {}", use, p.name, name_of(p.format));
    case PortKind::textures:
      return fmt::format("{} {}, textures", use, p.name);
  }
  return p.name;
}

void print(const Kernel& k) {
  fmt::print("{}\n  from {}\n", k.name, k.source);
  fmt::print("  variants\n");
  for (const Variant& v : k.variants)
    fmt::print("    {:<18} {}{}{}{}\n", v.name, v.name == k.default_variant ? "(default) " : "",
               v.baseline ? "(baseline) " : "", v.note, constants_text(v));
  fmt::print("  ports\n");
  for (const Port& p : k.ports) fmt::print("    {}\n", port_text(p));
  fmt::print("  bounds\n");
  for (const Bound& b : k.bounds) fmt::print("    {}, limit {:g}: {}\n", check::name_of(b), b.limit, b.reason);
  fmt::print("  hard cases\n");
  for (const HardCase& h : k.inputs.hard) fmt::print("    {:<28} {}{}\n", h.name, h.why, h.nightly ? " (nightly)" : "");
  fmt::print("\n");
}

int run(const Common& common, const std::vector<std::string>& names) {
  const auto kernels = chosen_kernels(names);
  probe_writable(common.json);
  if (!json_on_stdout(common))
    for (const Kernel* k : kernels) print(*k);
  write_json(common, report::list_json(kernels));
  return kSuccess;
}

}  // namespace

void add_list(CLI::App& app, Action& action) {
  auto common = std::make_shared<Common>();
  auto names = std::make_shared<std::vector<std::string>>();
  CLI::App* command = subcommand(app, "list", "Lists the kernels: variants, ports, bounds, hard cases",
                                 "Its names are what check, bench, frame and mutate take.",
                                 {"assay list", "assay list visibility", "assay list --json"});
  command->add_option("kernels", *names, "Only these")->type_name("KERNEL");
  add_json_flag(command, *common, "The list as JSON, in the shape of check's");
  command->callback([&action, common, names] { action = [common, names] { return run(*common, *names); }; });
}

}  // namespace assay::cli
