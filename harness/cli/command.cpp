#include "harness/cli/command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "harness/check/cases.h"
#include "harness/nearest.h"

namespace assay::cli {

namespace {

constexpr uint32_t kLargestSide = 16384;

const std::map<std::string, device::Validation> kValidation = {{"off", device::Validation::off},
                                                               {"core", device::Validation::core},
                                                               {"sync", device::Validation::sync},
                                                               {"gpuav", device::Validation::gpuav}};

}  // namespace

CLI::App* subcommand(CLI::App& app, const std::string& name, const std::string& what, const std::string& more,
                     const std::vector<std::string>& examples) {
  CLI::App* command = app.add_subcommand(name, what);
  std::string footer = more.empty() ? "" : more + "\n\n";
  footer += "Examples:";
  for (const auto& e : examples) footer += "\n  " + e;
  command->footer(footer);
  return command;
}

void add_device_flags(CLI::App* command, Common& common) {
  command->add_option(
      "--device", common.device,
      "Index, UUID (8 digits or more) or part of a name, as in assay devices; the CPU device by default");
  command
      ->add_option("--validation", common.validation,
                   "Vulkan validation layer: off, core, sync or gpuav; any message is a failure")
      ->check(CLI::IsMember({"off", "core", "sync", "gpuav"}))
      ->capture_default_str();
}

void add_json_flag(CLI::App* command, Common& common, const std::string& what) {
  command->add_option("--json", common.json, what + "; to standard output where no FILE (.json, a path or -) follows")
      ->type_name("[FILE]");
}

device::Options device_options(const Common& common) {
  return {.select = common.device, .validation = kValidation.at(common.validation)};
}

device::Handle open_device(const Common& common) {
  auto handle = device::open(device_options(common));
  const device::Info& i = device::info(*handle);
  fmt::print(stderr, "device {}: {}, {} {}, subgroups of {}{}\n", i.index, i.name, i.driver, i.driver_info,
             i.traits.subgroup_width, common.validation == "off" ? "" : ", validation " + common.validation);
  return handle;
}

int validation_verdict(device::Device& d) {
  const auto messages = device::validation_messages(d);
  for (const auto& m : messages) fmt::print(stderr, "validation: {}\n", m);
  return messages.empty() ? kSuccess : kViolation;
}

bool json_on_stdout(const Common& common) { return common.json == "-"; }

void probe_writable(const std::string& file) {
  if (file.empty() || file == "-") return;
  const std::filesystem::path path(file);
  std::error_code ignored;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
  const bool existed = std::filesystem::exists(path, ignored);
  if (!std::ofstream(path, std::ios::app)) throw Unusable(file + ": cannot be written");
  if (!existed) std::filesystem::remove(path, ignored);
}

void write_text(const std::string& file, const std::string& text) {
  if (file == "-") {
    fmt::print("{}", text);
    if (std::fflush(stdout) != 0) throw Unusable("standard output cannot be written");
    return;
  }
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw Unusable(file + ": cannot be written");
}

void write_json(const Common& common, const nlohmann::ordered_json& j) {
  if (!common.json.empty())
    write_text(common.json, j.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

std::vector<const Kernel*> chosen_kernels(const std::vector<std::string>& names) {
  std::vector<const Kernel*> chosen;
  chosen.reserve(all_kernels().size());
  for (const auto& name : names) chosen.push_back(&kernel_named(name));
  if (names.empty())
    for (const Kernel& k : all_kernels()) chosen.push_back(&k);
  return chosen;
}

void must_have_case(const std::vector<const Kernel*>& kernels, const std::string& name) {
  std::vector<std::string> there;
  for (const Kernel* k : kernels) {
    const auto found = check::cases_named(*k, fixtures_folder(), name);
    if (!found.empty()) {
      if (check::is_case_path(name)) found.front().make();  // a broken file is told before anything runs
      return;
    }
    for (const auto& c : check::hard_cases(*k, fixtures_folder(), true)) there.push_back(c.name);
  }
  if (check::is_case_path(name))
    throw Unusable(
        fmt::format("{}: a case of {}, which is not among the kernels asked for", name, check::kernel_of_case(name)));
  throw Unusable(fmt::format("no case '{}'{}", name, did_you_mean(name, there)));
}

void must_have_variant(const std::vector<const Kernel*>& kernels, const std::string& variant) {
  if (variant.empty()) return;
  std::vector<std::string> there;
  for (const Kernel* k : kernels)
    for (const Variant& v : k->variants) {
      there.push_back(v.name);
      for (const auto& constants : device::combinations(v)) there.push_back(device::label_of(v, constants));
    }
  if (std::ranges::find(there, variant) == there.end())
    throw Unusable(fmt::format("no variant '{}'{}", variant, did_you_mean(variant, there)));
}

Extent parse_size(const std::string& text) {
  uint32_t width = 0, height = 0;
  int end = 0;
  const bool whole = std::sscanf(text.c_str(), "%5ux%5u%n", &width, &height, &end) == 2 &&
                     static_cast<size_t>(end) == text.size() && text.find_first_of("+- ") == std::string::npos;
  if (!whole || width < 1 || height < 1 || width > kLargestSide || height > kLargestSide)
    throw Unusable(
        fmt::format("'{}' is no size; write WIDTHxHEIGHT, 1 to {} pixels a side, as in 1280x720", text, kLargestSide));
  return {width, height};
}

std::filesystem::path program_folder() {
  std::error_code failed;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::filesystem::path(".") : program.parent_path();
}

std::filesystem::path fixtures_folder() { return program_folder().parent_path() / "fixtures"; }

}  // namespace assay::cli
