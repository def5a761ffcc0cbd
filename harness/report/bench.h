// Times variants, each verified against the oracle in the same run, and sets their speed beside their error.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/cases.h"
#include "harness/check/check.h"
#include "harness/check/run_case.h"
#include "harness/report/errors.h"
#include "harness/report/table.h"
#include "harness/report/yardsticks.h"

namespace assay::report {

// One variant with its constants on one input: the kernel's typical one at an extent, or a named case.
struct Entry {
  const Kernel* kernel = nullptr;
  const Variant* variant = nullptr;
  std::map<std::string, uint32_t> constants;
  Extent extent;
  std::optional<check::NamedCase> named = {};
  bool is_default = false;  // the kernel's default variant with its first constants
};
Case input_of(const Entry&);
bool same_input(const Entry&, const Entry&);
std::string label_of(const Entry&);  // "tile_reduce[PIXELS_PER_THREAD=4]"

struct Selection {
  std::vector<const Kernel*> kernels;
  std::string variant = {};             // name or label; empty: all
  bool defaults_only = false;           // each kernel's default variant with its first constants
  std::vector<Extent> extents = {};     // empty: each kernel's first
  bool all_extents = false;             // every extent of the kernel
  std::vector<std::string> cases = {};  // named ones, of the kernels that have them, in place of extents
  std::filesystem::path fixtures = {};  // where cases may lie too
};
std::vector<Entry> entries_of(const Selection&);

struct Verified {
  std::string refused;  // why it is not timed: it cannot run here, or breaks its bound; empty: timed
  bool broken = false;  // refused because it is wrong
  std::vector<check::BoundResult> bounds;
  uint64_t judged = 0, undecided = 0, violations = 0, nans = 0;  // elements
};
// One run against an oracle's answer that serves every variant of the kernel at that extent.
Verified verify(device::Device&, const Entry&, const check::Prepared&);

struct Row {
  Entry entry;
  std::string case_name;
  Verified verified;
  Cost cost;
  uint32_t dispatches = 0, sets = 0;
  uint64_t rotated_bytes = 0;
  bool cold_enough = false;
  std::vector<Sample> cold, hot;
  CopyFigure copy;  // the yardstick at this size
  double limit_ns = 0;
};
double headline_ns(const Row&);  // median GPU time, inputs rotated
double share_of_limit(const Row&);
// The worst of the bounds: the one nearest to, or furthest beyond, its limit. Nothing where there are none.
const check::BoundResult* worst_bound(const std::vector<check::BoundResult>&);

struct Run {
  Yardsticks yardsticks;
  std::vector<Row> rows;
  std::vector<ErrorRow> errors;  // of kernels that have an error table
};
// `count` samples of each kind an entry.
Run bench(device::Device&, const std::vector<Entry>&, uint32_t count, const check::Tell&);

Table speed_table(const Run&, const device::Info&);
// Of a kernel, one input after another: fastest first, the default and the Pareto front marked; empty: none was timed.
Table speed_against_error_table(const Run&, const Kernel&);
std::string yardsticks_text(const Run&);
// A kernel's errors by class of inputs, beside its times at the first extent; empty where it reports none.
Table error_table(const Run&, const Kernel&);

}  // namespace assay::report
