// What a frame runs and allocates, and why: every pass and every resource, left-out ones with their reason.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/frame/graph.h"

namespace assay::frame {

struct PassNote {
  std::string kernel, variant;  // "visibility", "slim"
  std::string pass;             // "dispatch gather.comp", "draw masked.vert masked.frag"
  bool runs = false;
  std::string reason;  // why it runs or is left out, a clause
};

struct ResourceNote {
  std::string name;                  // "visibility.depth", "scene.indices"
  uint64_t bytes = 0;                // payload; 0 where it shares another's memory or is not allocated
  std::string producer;              // kernel, or "scene" or "case"
  std::vector<std::string> readers;  // kernels
  std::string note;                  // "shares the memory of ...", "left out: ..."; empty for an ordinary one
};

struct Explanation {
  std::vector<PassNote> passes;
  std::vector<ResourceNote> resources;
};

Explanation explain(const Graph&, const std::map<std::string, uint64_t>& scene_bytes);
uint64_t total_bytes(const Explanation&);
std::string to_text(const Explanation&);     // two tables, a line each pass and resource
nlohmann::json to_json(const Explanation&);  // {"passes":[...],"resources":[...],"bytes":n}

}  // namespace assay::frame
