// Whose result each pixel comes out with in the variants that shade primaries.
#pragma once
#include <map>

#include "harness/kernel.h"

namespace assay::deferred_lighting {

constexpr uint32_t kNobody = 0xffffffffu;       // the pixel is left as it was
constexpr uint32_t kFromNowhere = 0xfffffffeu;  // background

// Of a pixel one source: a pixel, itself or its primary, or background. Lists that are nobody's may leave pixels
// without one, or store several, of which any may be the last.
struct Sources {
  std::vector<uint32_t> first;  // a pixel
  std::map<uint64_t, std::vector<uint32_t>> others = {};

  explicit Sources(const Case& c) : first(pixels(c), kNobody) {}
  void add(uint64_t pixel, uint32_t source);
};
Sources sources_by_tiles(const Case&);
Sources sources_by_list(const Case&);

}  // namespace assay::deferred_lighting
