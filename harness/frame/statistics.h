// Workgroups that tile classification saved, as seed 000 prints them.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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

std::string to_text(const std::vector<PassShare>&);
nlohmann::json to_json(const std::vector<PassShare>&);

}  // namespace assay::frame
