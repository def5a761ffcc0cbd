// The bench's tables: times beside limits, and speed against error.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/bench.h"

namespace assay::report {

namespace {

std::string input_text(const Entry& e) {
  return e.named ? e.named->name : fmt::format("{}x{}", e.extent.width, e.extent.height);
}

// Of a deterministic kernel "0"; else the worst value and how much was allowed.
std::string error_text(const Row& row) {
  const auto* worst = worst_bound(row.verified.bounds);
  if (!worst) return "-";
  if (worst->worst == 0 && worst->limit == 0) return "0";
  return fmt::format("{} of {} ({})", number_text(worst->worst), number_text(worst->limit), worst->name);
}

std::string baseline_text(const Row& row) {
  const Verified& v = row.verified;
  return fmt::format("baseline, {} of {} wrong, {} NaN", v.violations, v.judged, v.nans);
}

std::string state_text(const Row& row) {
  if (!row.verified.refused.empty()) return (row.verified.broken ? "NOT TIMED: " : "skipped: ") + row.verified.refused;
  std::string text = row.entry.variant->baseline ? baseline_text(row) : row.entry.is_default ? "default" : "";
  if (!row.cold_enough) text += text.empty() ? "fits the cache" : ", fits the cache";
  return text;
}

double bytes_of(const Row& row) { return static_cast<double>(row.cost.bytes_read + row.cost.bytes_written); }

double error_of(const Row& row) {
  const auto* worst = worst_bound(row.verified.bounds);
  return worst ? worst->worst : 0;
}

// Nothing else is both faster and more accurate, or equal in one and better in the other.
bool on_front(const Row& row, const std::vector<const Row*>& rivals) {
  return std::ranges::none_of(rivals, [&](const Row* r) {
    const bool no_worse = headline_ns(*r) <= headline_ns(row) && error_of(*r) <= error_of(row);
    return no_worse && (headline_ns(*r) < headline_ns(row) || error_of(*r) < error_of(row));
  });
}

}  // namespace

Table speed_table(const Run& run, const device::Info& info) {
  const bool cpu = info.type == "cpu";
  Table t{.columns = {{"kernel"}, {"variant"}, {"size"}, {"time", Align::right}}};
  if (cpu) t.columns.push_back({"CPU time", Align::right});
  for (const char* head : {"hot", "ns/px", "bytes", "limit", "share"}) t.columns.push_back({head, Align::right});
  t.columns.push_back({"error"});
  t.columns.push_back({""});
  for (const Row& row : run.rows) {
    const bool timed = row.verified.refused.empty();
    const double ns = headline_ns(row);
    std::vector<std::string> cells = {row.entry.kernel->name, label_of(row.entry), input_text(row.entry),
                                      time_text(ns)};
    if (cpu) cells.push_back(time_text(median_cpu_ns(row.cold)));
    cells.push_back(time_text(median_gpu_ns(row.hot)));
    cells.push_back(timed ? number_text(ns / static_cast<double>(pixel_count(row.entry.extent))) : "-");
    cells.push_back(bytes_text(bytes_of(row)));
    cells.push_back(timed ? time_text(row.limit_ns) : "-");
    cells.push_back(timed ? percent_text(share_of_limit(row)) : "-");
    cells.push_back(error_text(row));
    cells.push_back(state_text(row));
    t.rows.push_back(std::move(cells));
  }
  return t;
}

Table speed_against_error_table(const Run& run, const Kernel& kernel) {
  Table t{.columns = {{"size"},
                      {"variant"},
                      {"time", Align::right},
                      {"share of limit", Align::right},
                      {"bytes", Align::right},
                      {"error"},
                      {"undecided", Align::right},
                      {""}}};
  std::vector<const Row*> rows;
  for (const Row& row : run.rows)
    if (row.entry.kernel == &kernel && row.verified.refused.empty()) rows.push_back(&row);
  for (auto from = rows.begin(); from != rows.end();) {
    const auto to = std::find_if(from, rows.end(), [&](const Row* r) { return !same_input((*from)->entry, r->entry); });
    std::vector<const Row*> plot(from, to);
    std::ranges::stable_sort(plot, {}, [](const Row* r) { return headline_ns(*r); });
    for (const Row* r : plot) {
      const Verified& v = r->verified;
      std::string marks = on_front(*r, plot) ? "front" : "";
      if (r->entry.is_default) marks += marks.empty() ? "default" : ", default";
      if (r->entry.variant->baseline) marks += (marks.empty() ? "" : ", ") + baseline_text(*r);
      t.rows.push_back({input_text(r->entry), label_of(r->entry), time_text(headline_ns(*r)),
                        percent_text(share_of_limit(*r)), bytes_text(bytes_of(*r)), error_text(*r),
                        fmt::format("{} of {}", v.undecided, v.judged), marks});
    }
    from = to;
  }
  return t;
}

Table error_table(const Run& run, const Kernel& kernel) {
  std::vector<ErrorRow> rows;
  for (const ErrorRow& r : run.errors)
    if (r.kernel == &kernel) rows.push_back(r);
  std::map<std::string, SpeedAndSize> beside;
  for (const Row& r : run.rows)
    if (r.entry.kernel == &kernel && r.verified.refused.empty())
      beside.try_emplace(label_of(r.entry), SpeedAndSize{headline_ns(r), bytes_of(r)});
  return error_table(rows, beside);
}

std::string yardsticks_text(const Run& run) {
  std::string text = fmt::format("this device: empty dispatch {}, multiply and add {:.3g} Gop/s",
                                 time_text(run.yardsticks.empty_ns), run.yardsticks.operations_per_s / 1e9);
  for (const auto& [bytes, copy] : run.yardsticks.copies)
    text += fmt::format(
        ", copy of {} {}", bytes_text(static_cast<double>(bytes)),
        std::isfinite(copy.bytes_per_s) ? fmt::format("{:.3g} GB/s", copy.bytes_per_s / 1e9) : "lost in the dispatch");
  return text + fmt::format("; filters linear textures within {:.2f}/255, alpha of sRGB ones within {:.2f}/255\n",
                            run.yardsticks.filter.linear, run.yardsticks.filter.srgb_alpha);
}

}  // namespace assay::report
