#include "harness/report/bench.h"

#include <algorithm>
#include <limits>

namespace assay::report {

namespace {

using Constants = std::map<std::string, uint32_t>;

bool wanted(const Selection& s, const Variant& v, const Constants& constants) {
  return s.variant.empty() || s.variant == v.name || s.variant == device::label_of(v, constants);
}

std::vector<Extent> extents_of(const Selection& s, const Kernel& k) {
  if (!s.extents.empty()) return s.extents;
  if (s.all_extents || k.extents.empty()) return k.extents;
  return {k.extents.front()};
}

device::Plan plan_of(const Entry& e) { return {.kernel = e.kernel, .variant = e.variant, .constants = e.constants}; }

double distance_from_limit(const check::BoundResult& b) {
  if (b.limit > 0) return b.worst / b.limit;
  return b.worst > 0 ? std::numeric_limits<double>::infinity() : 0;
}

void time_row(device::Device& d, Run& run, Row& row, const Case& c, uint32_t count) {
  Loop loop = make_loop(d, plan_of(row.entry), c);
  warm_up(d, loop);
  row.dispatches = loop.dispatches;
  row.sets = static_cast<uint32_t>(loop.sets.size());
  row.rotated_bytes = loop.rotated_bytes;
  row.cold_enough = loop.cold_enough;
  row.cold = samples(d, loop, Cache::cold, count);
  row.hot = samples(d, loop, Cache::hot, count);
  row.copy = copy_at(d, run.yardsticks, row.cost.bytes_read + row.cost.bytes_written, count);
  row.limit_ns = limit_ns(run.yardsticks, row.copy, row.cost, row.dispatches);
}

// Errors are of inputs of their own, the same at every extent that is timed; who names a case asks for its time alone.
bool has_errors(const std::vector<Entry>& entries, const Entry& e) {
  return !e.named && same_input(*std::ranges::find(entries, e.kernel, &Entry::kernel), e);
}

// Of one kernel, variants aside.
std::vector<Entry> inputs_of(const Selection& s, const Kernel& k) {
  std::vector<Entry> inputs;
  for (const std::string& name : s.cases)
    for (check::NamedCase& c : check::cases_named(k, s.fixtures, name)) {
      const Extent extent = c.make().extent;
      inputs.push_back({.kernel = &k, .extent = extent, .named = std::move(c)});
    }
  if (s.cases.empty())
    for (const Extent extent : extents_of(s, k)) inputs.push_back({.kernel = &k, .extent = extent});
  return inputs;
}

}  // namespace

Case input_of(const Entry& e) {
  if (!e.named) return e.kernel->typical(e.extent);
  Case c = e.named->make();
  c.name = e.named->name;
  return c;
}

bool same_input(const Entry& a, const Entry& b) {
  return a.kernel == b.kernel && a.extent.width == b.extent.width && a.extent.height == b.extent.height &&
         (a.named ? a.named->name : "") == (b.named ? b.named->name : "");
}

std::string label_of(const Entry& e) { return device::label_of(*e.variant, e.constants); }

std::vector<Entry> entries_of(const Selection& s) {
  std::vector<Entry> entries;
  for (const Kernel* k : s.kernels)
    for (const Entry& input : inputs_of(s, *k))
      for (const Variant& v : k->variants) {
        const auto combinations = device::combinations(v);
        for (const auto& constants : combinations) {
          const bool is_default = v.name == k->default_variant && &constants == &combinations.front();
          if (wanted(s, v, constants) && (is_default || !s.defaults_only))
            entries.push_back({k, &v, constants, input.extent, input.named, is_default});
        }
      }
  return entries;
}

Verified verify(device::Device& d, const Entry& e, const check::Prepared& prepared) {
  Verified result;
  result.refused = device::missing(device::info(d), *e.variant);
  if (!result.refused.empty()) return result;
  const auto ports = device::make_ports(d, *e.kernel, prepared.input, {}, e.variant);
  const check::Outcome outcome = check::run_case(d, plan_of(e), prepared, ports, true);
  const auto bounds = check::bounds_for(*e.kernel, *e.variant);
  for (size_t i = 0; i < bounds.size(); ++i) {
    const check::Verdict& v = outcome.verdicts.at(i);
    result.bounds.push_back({check::name_of(bounds[i]), bounds[i].limit, v.worst, bounds[i].reason});
    result.judged += v.judged;
    result.undecided += v.undecided;
    result.violations += v.violations;
    result.nans += v.nans;
  }
  result.refused = check::fault_of(outcome, *e.variant).text;
  result.broken = !result.refused.empty();
  return result;
}

double headline_ns(const Row& row) { return median_gpu_ns(row.cold); }
double share_of_limit(const Row& row) { return row.limit_ns / headline_ns(row); }

const check::BoundResult* worst_bound(const std::vector<check::BoundResult>& bounds) {
  const auto it = std::ranges::max_element(bounds, {}, distance_from_limit);
  return it == bounds.end() ? nullptr : &*it;
}

Run bench(device::Device& d, const std::vector<Entry>& entries, uint32_t count, const check::Tell& tell) {
  Run run;
  tell("yardsticks", 0, entries.size() + 1);
  run.yardsticks = measure_yardsticks(d, count);
  check::Prepared prepared;
  for (size_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries[i];
    tell(e.kernel->name + " " + label_of(e), i + 1, entries.size() + 1);
    if (i == 0 || !same_input(e, entries[i - 1]))
      prepared = check::prepare(*e.kernel, input_of(e), device::info(d).traits);
    Row row{.entry = e, .case_name = prepared.input.name};
    row.verified = verify(d, e, prepared);
    row.cost = cost_of(*e.kernel, *e.variant, prepared.input);
    if (row.verified.refused.empty()) time_row(d, run, row, prepared.input, count);
    run.rows.push_back(std::move(row));
    if (has_errors(entries, e)) {
      auto errors = measure_errors(d, *e.kernel, *e.variant, e.constants);
      run.errors.insert(run.errors.end(), std::make_move_iterator(errors.begin()),
                        std::make_move_iterator(errors.end()));
    }
  }
  return run;
}

}  // namespace assay::report
