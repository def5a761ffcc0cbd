#include "harness/report/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace assay::report {

namespace {

std::map<std::string, Bytes> written(device::Device& d, const device::Plan& plan, const Case& c) {
  const auto ports = device::make_ports(d, *plan.kernel, c, {}, plan.variant);
  device::run(d, device::lower(d, plan, c, ports));
  std::map<std::string, Bytes> bytes;
  for (const Port& p : plan.kernel->ports)
    if (p.use != Use::reads && p.kind != PortKind::textures && has_port(*plan.variant, p))
      bytes[p.name] = device::read(d, *ports.at(p.name));
  return bytes;
}

double median_of_first_figure(const std::vector<ErrorRow>& rows) {
  std::vector<double> values;
  for (const ErrorRow& r : rows)
    if (!r.figures.empty()) values.push_back(r.figures[0].value);
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// The rows of each variant together, the variants of a kernel in order of their errors.
std::vector<std::vector<ErrorRow>> ranked(const std::vector<ErrorRow>& rows) {
  std::vector<std::vector<ErrorRow>> groups;
  for (const ErrorRow& r : rows) {
    if (groups.empty() || groups.back()[0].kernel != r.kernel || groups.back()[0].label != r.label)
      groups.emplace_back();
    groups.back().push_back(r);
  }
  for (auto from = groups.begin(); from != groups.end();) {
    const auto to = std::find_if(from, groups.end(), [&](const auto& g) { return g[0].kernel != (*from)[0].kernel; });
    std::stable_sort(
        from, to, [](const auto& a, const auto& b) { return median_of_first_figure(a) < median_of_first_figure(b); });
    from = to;
  }
  return groups;
}

}  // namespace

std::vector<Figure> measure_errors(device::Device& d, const device::Plan& plan, const HardCase& input_class) {
  const Case c = input_class.make();
  return plan.kernel->errors.figures(*plan.variant, c, written(d, plan, c));
}

std::vector<ErrorRow> measure_errors(device::Device& d, const Kernel& k, const Variant& v,
                                     const std::map<std::string, uint32_t>& constants) {
  std::vector<ErrorRow> rows;
  if (!device::missing(device::info(d), v).empty()) return rows;
  const device::Plan plan = {.kernel = &k, .variant = &v, .constants = constants};
  for (const HardCase& input : k.errors.classes) {
    if (input.nightly) continue;
    auto figures = measure_errors(d, plan, input);
    if (!figures.empty()) rows.push_back({&k, &v, device::label_of(v, constants), input.name, std::move(figures)});
  }
  return rows;
}

std::vector<std::string> missed_goals(const std::vector<ErrorRow>& rows) {
  std::vector<std::string> missed;
  for (const ErrorRow& r : rows)
    for (const Figure& f : r.figures)
      if (f.limit != 0 && !(f.value <= f.limit))
        missed.push_back(fmt::format("{} {}, class {}: {} is {}, the goal {}", r.kernel->name, r.label, r.input_class,
                                     f.quantity, number_text(f.value), number_text(f.limit)));
  return missed;
}

Table error_table(const std::vector<ErrorRow>& rows, const std::map<std::string, SpeedAndSize>& beside) {
  Table t{.columns = {{"variant"}, {"time", Align::right}, {"bytes", Align::right}, {"class"}}};
  if (rows.empty()) return t;
  for (const Figure& f : rows[0].figures) t.columns.push_back({f.quantity, Align::right});
  for (const auto& group : ranked(rows))
    for (const ErrorRow& r : group) {
      const auto speed = beside.find(r.label);
      std::vector<std::string> cells = {r.label, speed == beside.end() ? "-" : time_text(speed->second.time_ns),
                                        speed == beside.end() ? "-" : bytes_text(speed->second.bytes), r.input_class};
      for (const Figure& f : r.figures) cells.push_back(fmt::format("{:.3g}", f.value));
      cells.resize(t.columns.size());
      t.rows.push_back(std::move(cells));
    }
  return t;
}

}  // namespace assay::report
