#include "kernels/tile_visit/oracle.h"

#include <algorithm>

#include "harness/oracle.h"

namespace assay::tile_visit {

uint64_t tiles(const Case& c) { return tile_count(c.extent, kTileSide); }
uint64_t workloads(const Case& c) { return std::min(c.params<VisitParams>().workloads, kMaxVisitors); }

// Every pixel of a listed tile is visited once an entry, if there are groups to do it.
Answer visit(const Case& c) {
  const auto lists = c.input<uint>("workload_tiles");
  const auto counts = c.input<WorkloadCount>("workload_counts");
  const auto args = c.input<DispatchArgs>("workload_args");
  const uint32_t across = tiles_of(c.extent, kTileSide).width;
  std::vector<uint> visits(pixels(c));
  for (size_t w = 0; w < workloads(c); ++w) {
    const uint64_t groups = args[w].x == 0 ? 0 : uint64_t{args[w].y} * args[w].z;
    const uint64_t entries = std::min({groups, uint64_t{counts[w].tiles}, tiles(c)});
    for (uint64_t entry = 0; entry < entries; ++entry) {
      const uint tile = lists[w * tiles(c) + entry];
      if (tile >= tiles(c)) continue;
      const uint32_t left = tile % across * kTileSide, top = tile / across * kTileSide;
      for (uint32_t y = top; y < std::min(top + kTileSide, c.extent.height); ++y)
        for (uint32_t x = left; x < std::min(left + kTileSide, c.extent.width); ++x)
          visits[size_t{y} * c.extent.width + x] += 1u << (4 * w);
    }
  }
  return {{"visits", expect_all(visits)}};
}

}  // namespace assay::tile_visit
