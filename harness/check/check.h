// Runs kernels against their oracles: hard cases, random trials, poison and guards, bounds, shrinking, mutants.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/device/device.h"
#include "harness/kernel.h"

namespace assay::check {

// Told of what is worked on and how much of it is done, for whoever waits.
using Tell = std::function<void(const std::string& what, uint64_t done, uint64_t of)>;

struct Options {
  std::vector<std::string> kernels = {};  // empty: all
  std::string variant = {};               // name or label; empty: all
  bool defaults = false;                  // only each kernel's default variant
  std::string case_name = {};  // a hard case, `typical`, a fixture of the kernel, or a path to a case file; empty: all
  std::optional<uint64_t> seed = {};  // of the first random trial; given, nothing but the trials runs
  uint32_t trials = 50;
  bool hard = true;           // run the hard cases and the typical input
  bool nightly = false;       // the large ones too, and oracles unsampled
  uint32_t extent_limit = 0;  // leaves out hard cases with more pixels a side; 0: none
  std::filesystem::path fixtures = "fixtures", failures = "out/failures";
  Tell progress = {};
};

struct BoundResult {
  std::string name;
  double limit = 0, worst = 0;
  std::string reason;
};
struct Failure {
  std::string text;            // kernel, variant, case, seed, element, expected, got, bound
  std::string replay;          // the command that repeats it
  std::filesystem::path file;  // the shrunk case
};
struct VariantResult {
  std::string name;  // the variant's, over all combinations of its constants; its label where only one was asked for
  bool baseline = false;
  std::string skipped;  // the reason; empty: it ran
  uint64_t trials = 0, cases = 0, violations = 0, judged = 0, undecided = 0;
  uint64_t hard_undecided = 0;   // of the undecided, those in hard cases
  uint64_t wrong = 0, nans = 0;  // elements outside their bound, and those of them that are NaN: a baseline's figures
  uint64_t flaky = 0;            // device lost and repeated with success
  std::vector<BoundResult> bounds;
  std::vector<Failure> failures;  // the first ten, after which the variant is not run again
};
struct KernelResult {
  std::string name;
  std::vector<VariantResult> variants;
  std::map<std::string, uint64_t> branches;  // how often each fired
  std::vector<std::string> complaints;       // starved branches, too few large trials, validation messages
};
bool passed(const std::vector<KernelResult>&);

// May replace the device after a loss.
std::vector<KernelResult> check(device::Handle&, const device::Options&, const Options&);
// The same for a kernel that need not be registered; Options.kernels is not looked at.
KernelResult check_kernel(device::Handle&, const device::Options&, const Options&, const Kernel&);

struct MutantResult {
  std::string kernel, variant, file, fault, killed_by;  // killed_by: the case that did; empty: survived
  uint32_t n = 0;
  std::string named;  // the case that the description says kills it: one killed by another is a complaint too
};
// Each mutant in every variant that uses its file, against its named case first, then every hard case, then trials.
// Nothing notices a baseline's values, so a mutant is not run in one if another variant compiles its file too; a mutant
// of a file that only baselines compile must break memory safety to count as killed.
std::vector<MutantResult> mutate(device::Handle&, const device::Options&, const std::vector<std::string>& kernels,
                                 uint32_t trials, const Tell& = {});
std::vector<MutantResult> mutate_kernel(device::Handle&, const device::Options&, const Kernel&, uint32_t trials,
                                        const Tell& = {});

// Case files: JSON, words in hexadecimal. Broken ones throw std::runtime_error with one line.
void save_case(const std::filesystem::path&, const Kernel&, const Case&);
Case load_case(const std::filesystem::path&, const Kernel&);

}  // namespace assay::check
