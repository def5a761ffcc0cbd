// One kernel under check: its variants' tallies, and the running of a case through all of them.
#pragma once
#include <string>
#include <vector>

#include "harness/check/cases.h"
#include "harness/check/run_case.h"

namespace assay::check {

constexpr uint64_t kFailuresStop = 10;   // a variant that failed so often is not run again
constexpr uint64_t kFailuresShrunk = 2;  // a variant's first ones

struct VariantState {
  const Variant* variant;
  std::vector<std::map<std::string, uint32_t>> combinations;
  VariantResult result;
  bool is_broken = false;  // cannot be run at all: a complaint says why
  bool is_live() const { return result.skipped.empty() && !is_broken && result.violations < kFailuresStop; }
};

struct Share {  // of elements judged by `between`, those whose answer rounding can tip
  uint64_t judged = 0, undecided = 0;
};

struct KernelRun {
  Session session;
  const Options& options;
  const Kernel& kernel;
  KernelResult result;
  std::vector<VariantState> variants;
  Share of_typical;              // over the variants
  std::vector<Share> of_trials;  // likewise, one a trial
};

// Of `of` equal parts of the work, the progress of part `part`, from 0.
Tell part_of(const Tell&, size_t part, size_t of);

// The kernel's selected variants, those that cannot run here marked with the reason.
KernelRun start(Session, const Options&, const Kernel&);
bool is_selected(const Variant&, const std::string& name_or_label);

enum class Kind { hard, typical, trial };
// The case in every live variant: all combinations of its constants for a hard one, the first for the typical one, one
// by the seed for a trial.
void run_everywhere(KernelRun&, const Prepared&, const std::string& replay, Kind);

}  // namespace assay::check
