// Workgroups that tile classification saved, as Lazarek and Hammer print them.
#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/kernel.h"

namespace assay::frame {

struct WorkloadShare {
  std::string name;    // "DEFERRED_LIGHTINGONLY_FEATURESUBSET0"
  std::string colour;  // "GREEN"
  uint32_t tiles = 0, groups = 0;
  double share = 0;  // of the theoretical groups, 0..1
};
struct PassShare {
  std::string name;                                         // "deferred lighting"
  uint32_t theoretical = 0, dispatched = 0, discarded = 0;  // workgroups: full screen, wanted, the difference
  std::vector<WorkloadShare> workloads;
};

// The resources that they come from, and without them there are no statistics.
inline constexpr const char* kStatistics = "tile_classification.statistics";
inline constexpr const char* kWorkloadCounts = "tile_classification.workload_counts";
std::vector<PassShare> pass_shares(const std::map<std::string, Bytes>& downloads);

std::string to_text(const std::vector<PassShare>&);
nlohmann::json to_json(const std::vector<PassShare>&);

}  // namespace assay::frame
