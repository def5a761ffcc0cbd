#include "harness/frame/statistics.h"

#include <fmt/format.h>

#include "harness/formats/workloads.h"
#include "harness/frame/downloads.h"

namespace assay::frame {

namespace {

double percent(uint32_t part, uint32_t of) { return of ? 100.0 * part / of : 0.0; }

}  // namespace

std::vector<PassShare> pass_shares(const std::map<std::string, Bytes>& downloads) {
  const auto passes = values_of<PassStatistics>(downloads, kStatistics);
  const auto counts = values_of<WorkloadCount>(downloads, kWorkloadCounts);
  std::vector<PassShare> shares;
  for (size_t p = 0; p < passes.size() && p < std::size(kFramePasses); ++p) {
    PassShare share = {kFramePasses[p].name, passes[p].theoretical, passes[p].dispatched, passes[p].discarded, {}};
    for (size_t w = 0; w < counts.size() && w < std::size(kFrameWorkloads); ++w)
      if (kFrameWorkloads[w].row.pass == p)
        share.workloads.push_back({kFrameWorkloads[w].name, kFrameWorkloads[w].colour, counts[w].tiles,
                                   counts[w].groups, percent(counts[w].groups, share.theoretical) / 100});
    shares.push_back(std::move(share));
  }
  return shares;
}

std::string to_text(const std::vector<PassShare>& passes) {
  std::string text;
  for (size_t i = 0; i < passes.size(); ++i) {
    const PassShare& p = passes[i];
    text += fmt::format("{}. {} group stats\n", i + 1, p.name);
    text += fmt::format("{}a. theoretical fullscreen threadgroups: {} (100%)\n", i + 1, p.theoretical);
    text += fmt::format("{}b. actual dispatched threadgroups: {} ({:.0f}%)\n", i + 1, p.dispatched,
                        percent(p.dispatched, p.theoretical));
    text += fmt::format("{}c. discarded threadgroups (not dispatched): {} ({:.0f}%)\n", i + 1, p.discarded,
                        percent(p.discarded, p.theoretical));
    for (const WorkloadShare& w : p.workloads)
      text += fmt::format("indirect dispatch DISPATCHWORKLOAD_{} ({}): {} threadgroups ({:.1f}%)\n", w.name, w.colour,
                          w.groups, 100 * w.share);
  }
  return text;
}

nlohmann::json to_json(const std::vector<PassShare>& passes) {
  nlohmann::json all = nlohmann::json::array();
  for (const PassShare& p : passes) {
    nlohmann::json workloads = nlohmann::json::array();
    for (const WorkloadShare& w : p.workloads)
      workloads.push_back(
          {{"name", w.name}, {"colour", w.colour}, {"tiles", w.tiles}, {"groups", w.groups}, {"share", w.share}});
    all.push_back({{"pass", p.name},
                   {"theoretical", p.theoretical},
                   {"dispatched", p.dispatched},
                   {"discarded", p.discarded},
                   {"workloads", workloads}});
  }
  return all;
}

}  // namespace assay::frame
