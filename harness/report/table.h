// Tables for the terminal and for Markdown, and figures as people read them.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace assay::report {

enum class Align { left, right };
struct Column {
  std::string head;
  Align align = Align::left;
};
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  // as many cells as columns
};
std::string as_text(const Table&);      // aligned with blanks, two between columns, no trailing ones
std::string as_markdown(const Table&);  // pipes in cells escaped

std::string time_text(double ns);        // "12.3 us", three digits; "-" for NaN and for anything below 0
std::string bytes_text(double bytes);    // decimal: "33.2 MB"
std::string percent_text(double share);  // 0.5 is "50 %"
std::string number_text(double);         // shortest of three digits: "0", "0.125", "1e-07"

}  // namespace assay::report
