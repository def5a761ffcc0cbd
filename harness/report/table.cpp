#include "harness/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace assay::report {

namespace {

std::string pad(const std::string& text, size_t width, Align align) {
  return align == Align::left ? fmt::format("{:<{}}", text, width) : fmt::format("{:>{}}", text, width);
}

std::vector<size_t> widths_of(const Table& table) {
  std::vector<size_t> widths;
  for (const Column& c : table.columns) widths.push_back(c.head.size());
  for (const auto& row : table.rows) {
    if (row.size() != widths.size()) throw std::logic_error("a table row has another number of cells than the head");
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  return widths;
}

std::string escaped(const std::string& cell) {
  std::string out;
  for (const char c : cell) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

struct Unit {
  double scale;
  const char* name;
};

// Three significant digits in the largest unit that leaves at least one before the point.
std::string scaled(double value, std::span<const Unit> largest_first) {
  if (!(value >= 0)) return "-";
  for (const Unit& u : largest_first)
    if (value >= u.scale || &u == &largest_first.back()) {
      const double v = value / u.scale;
      const int decimals = v < 9.995 ? 2 : v < 99.95 ? 1 : 0;
      return fmt::format("{:.{}f} {}", v, decimals, u.name);
    }
  return "-";
}

}  // namespace

std::string as_text(const Table& table) {
  const auto widths = widths_of(table);
  std::string out;
  const auto line = [&](auto cell) {
    std::string text;
    for (size_t i = 0; i < widths.size(); ++i)
      text += fmt::format("{}{}", i ? "  " : "", pad(cell(i), widths[i], table.columns[i].align));
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + '\n';
  };
  line([&](size_t i) { return table.columns[i].head; });
  line([&](size_t i) { return std::string(widths[i], '-'); });
  for (const auto& row : table.rows) line([&](size_t i) { return row[i]; });
  return out;
}

std::string as_markdown(const Table& table) {
  widths_of(table);
  std::string out = "|", rule = "|";
  for (const Column& c : table.columns) {
    out += fmt::format(" {} |", escaped(c.head));
    rule += c.align == Align::left ? "---|" : "---:|";
  }
  out += '\n' + rule + '\n';
  for (const auto& row : table.rows) {
    out += '|';
    for (const auto& cell : row) out += fmt::format(" {} |", escaped(cell));
    out += '\n';
  }
  return out;
}

std::string time_text(double ns) {
  static constexpr Unit kUnits[] = {{1e9, "s"}, {1e6, "ms"}, {1e3, "us"}, {1, "ns"}};
  return scaled(ns, kUnits);
}

std::string bytes_text(double bytes) {
  if (bytes < 1000) return bytes >= 0 ? fmt::format("{:.0f} B", bytes) : "-";
  static constexpr Unit kUnits[] = {{1e12, "TB"}, {1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}};
  return scaled(bytes, kUnits);
}

std::string percent_text(double share) {
  if (!std::isfinite(share)) return "-";
  return fmt::format("{:.{}f} %", 100 * share, share < 0.0995 ? 1 : 0);
}

std::string number_text(double v) { return fmt::format("{:.3g}", v); }

}  // namespace assay::report
