// The frame's memory beside the table that Lazarek and Hammer print for theirs.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/frame/explain.h"

namespace assay::frame {

// A row of their table, MiB at 3840x2160 including their alignment, and what this frame has for the same purpose.
struct MemoryRow {
  std::string name;
  double theirs_mib = 0;  // in proportion to the pixels where the frame has another size
  double ours_mib = 0;
};
// Rows of which the frame has something. `size` is the frame's.
std::vector<MemoryRow> memory_rows(const Explanation&, Extent size);
std::string to_text(const std::vector<MemoryRow>&);  // empty where there are no rows
nlohmann::json to_json(const std::vector<MemoryRow>&);

}  // namespace assay::frame
