// assay devices: every device with its driver, limits and what each kernel would miss there.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/cli/command.h"
#include "harness/report/json.h"
#include "harness/report/table.h"

namespace assay::cli {

namespace {

struct Miss {
  std::string kernel, variant, why;
};

std::vector<Miss> misses(const device::Info& info) {
  std::vector<Miss> all;
  for (const Kernel& k : all_kernels())
    for (const Variant& v : k.variants)
      if (const auto why = device::missing(info, v); !why.empty()) all.push_back({k.name, v.name, why});
  return all;
}

void print(const device::Info& i) {
  fmt::print("{}  {} ({})\n", i.index, i.name, i.type);
  const auto line = [](const char* what, const std::string& value) { fmt::print("   {:<16} {}\n", what, value); };
  line("uuid", i.uuid);
  line("driver", fmt::format("{} {}, Vulkan {}", i.driver, i.driver_info, i.api));
  line("subgroups", fmt::format("{} ({} to {})", i.traits.subgroup_width, i.subgroup_min, i.subgroup_max));
  line("memory", report::bytes_text(static_cast<double>(i.memory_bytes)));
  line("buffer range", report::bytes_text(static_cast<double>(i.max_buffer_range)));
  line("shared memory", report::bytes_text(static_cast<double>(i.shared_memory)));
  line("groups", fmt::format("{} x {} x {}", i.max_groups[0], i.max_groups[1], i.max_groups[2]));
  line("precision", fmt::format("{} sub-pixel, {} sub-texel, {} mipmap bits", i.traits.sub_pixel_bits,
                                i.traits.sub_texel_bits, i.traits.mipmap_bits));
  line("timestamps", i.timestamp_ns > 0 ? fmt::format("{:g} ns a tick", i.timestamp_ns) : "none; wall time instead");
  line("second queue", i.second_queue ? "yes" : "no");
  std::string features;
  for (const Feature f : i.features) features += (features.empty() ? "" : ", ") + std::string(name_of(f));
  line("features", features);
  if (!i.missing.empty()) {
    line("unusable", i.missing);
    return;
  }
  const auto all = misses(i);
  if (all.empty()) line("kernels", "every variant runs here");
  for (const Miss& m : all) line("left out", fmt::format("{} {}: {}", m.kernel, m.variant, m.why));
}

int run(const Common& common) {
  probe_writable(common.json);
  const auto devices = device::list();
  report::Json all = report::Json::array();
  for (const device::Info& i : devices) {
    report::Json j = report::to_json(i);
    j["left_out"] = report::Json::array();
    for (const Miss& m : misses(i))
      j["left_out"].push_back({{"kernel", m.kernel}, {"variant", m.variant}, {"why", m.why}});
    all.push_back(std::move(j));
    if (!json_on_stdout(common)) print(i);
  }
  write_json(common, {{"devices", all}});
  if (devices.empty()) throw Unusable("no Vulkan device; install a driver, such as Mesa's lavapipe for the CPU");
  return kSuccess;
}

}  // namespace

void add_devices(CLI::App& app, Action& action) {
  auto common = std::make_shared<Common>();
  CLI::App* command =
      subcommand(app, "devices", "Lists the devices: driver, limits, and what each kernel would miss there",
                 "The index, the UUID or part of the name is what --device takes elsewhere.",
                 {"assay devices", "assay devices --json", "assay check --device nvidia"});
  add_json_flag(command, *common, "The list as JSON");
  command->callback([&action, common] { action = [common] { return run(*common); }; });
}

}  // namespace assay::cli
