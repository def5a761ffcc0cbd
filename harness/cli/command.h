// What the commands of `assay` share: common flags, exit codes, choice of device, output files.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/device/device.h"

namespace assay::cli {

// Exit codes: 0 success, 1 a kernel broke its bound (or the validation layer spoke), 2 unusable input, 3 a bug in
// Assay.
constexpr int kSuccess = 0, kViolation = 1, kUnusable = 2, kBug = 3;

// Unusable input: one line, what, where, what to do.
struct Unusable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Common {
  std::string device;
  std::string validation = "off";
  std::string json;  // a file, "-" for standard output, empty: none
};

// A command sets `action` when it is the one asked for; main runs it and returns its exit code.
using Action = std::function<int()>;
void add_devices(CLI::App&, Action&);
void add_list(CLI::App&, Action&);
void add_check(CLI::App&, Action&);
void add_mutate(CLI::App&, Action&);
void add_diff(CLI::App&, Action&);
void add_bench(CLI::App&, Action&);
void add_bench_particle_light(CLI::App& bench, Action&);
void add_bench_vrcs(CLI::App& bench, Action&);
void add_frame(CLI::App&, Action&);

// A subcommand whose help ends in examples, one a line.
CLI::App* subcommand(CLI::App& app, const std::string& name, const std::string& what, const std::string& more,
                     const std::vector<std::string>& examples);
void add_device_flags(CLI::App*, Common&);
void add_json_flag(CLI::App*, Common&, const std::string& what);

device::Options device_options(const Common&);
// Opens the device and says on stderr which one was chosen.
device::Handle open_device(const Common&);
// Prints what the validation layer has said since; kViolation if it spoke.
int validation_verdict(device::Device&);

bool json_on_stdout(const Common&);
// Makes sure, before any work, that the file can be written. Throws Unusable.
void probe_writable(const std::string& file);
void write_text(const std::string& file, const std::string& text);  // "-": standard output
void write_json(const Common&, const nlohmann::ordered_json&);      // where --json asks for it

// Names checked against what there is; unknown ones throw Unusable with the nearest.
std::vector<const Kernel*> chosen_kernels(const std::vector<std::string>& names);
void must_have_variant(const std::vector<const Kernel*>&, const std::string& variant);
// The case must be one of some chosen kernel; a file must be readable and for one of them.
void must_have_case(const std::vector<const Kernel*>&, const std::string& name);
Extent parse_size(const std::string& text);  // "1280x720", 1 to 16384 a side

// Fixtures lie beside the programs' folder, in a checkout as in an installed copy.
std::filesystem::path fixtures_folder();
std::filesystem::path program_folder();

}  // namespace assay::cli
