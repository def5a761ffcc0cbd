#include "harness/frame/memory.h"

#include <fmt/format.h>

#include <algorithm>

namespace assay::frame {

namespace {

// Lazarek, Hammer 2025, "Memory Results", the rows of deferred rendering.
struct Purpose {
  const char* name;
  double mib;  // 0: not among theirs
  std::vector<std::string> resources;
};
const std::vector<Purpose>& purposes() {
  static const std::vector<Purpose> all = {
      {"visibility buffer", 63.75, {"visibility.visibility"}},
      {"dispatch buffers", 20.11, {"pixel_commands.args", "pixel_commands.commands"}},
      {"pixel commands and counters",
       57,
       {"pixel_commands.entries", "pixel_commands.tiles", "pixel_commands.shaders", "pixel_commands.status"}},
      {"pixel commands, scratch", 0, {"pixel_commands.tile_lists", "pixel_commands.tile_groups"}},
      {"barycentric derivatives", 63.75, {"attribute_interpolation.derivatives"}},
      {"barycentrics", 31.88, {"attribute_interpolation.barycentrics"}},
      {"tangent frame", 63.75, {"attribute_interpolation.tangent_frame"}},
  };
  return all;
}
constexpr double kMib = 1 << 20;

}  // namespace

std::vector<MemoryRow> memory_rows(const Explanation& e, Extent size) {
  const double scale = static_cast<double>(pixel_count(size)) / (3840.0 * 2160.0);
  std::vector<MemoryRow> rows;
  for (const Purpose& p : purposes()) {
    MemoryRow row = {p.name, p.mib * scale, 0};
    for (const ResourceNote& r : e.resources)
      if (std::ranges::find(p.resources, r.name) != p.resources.end())
        row.ours_mib += static_cast<double>(r.bytes) / kMib;
    if (row.ours_mib > 0) rows.push_back(row);
  }
  return rows;
}

std::string to_text(const std::vector<MemoryRow>& rows) {
  if (rows.empty()) return "";
  std::string text = "Memory in MiB, beside Lazarek and Hammer 2025 (3840x2160, in proportion to the pixels)\n";
  for (const MemoryRow& r : rows)
    text += fmt::format("  {:<28} {:8.2f}  {}\n", r.name, r.ours_mib,
                        r.theirs_mib > 0 ? fmt::format("theirs {:8.2f}", r.theirs_mib) : "not among theirs");
  return text;
}

nlohmann::json to_json(const std::vector<MemoryRow>& rows) {
  nlohmann::json json = nlohmann::json::array();
  for (const MemoryRow& r : rows)
    json.push_back({{"name", r.name}, {"mib", r.ours_mib}, {"lazarek_hammer_mib", r.theirs_mib}});
  return json;
}

}  // namespace assay::frame
