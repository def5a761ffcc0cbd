#include "kernels/cluster_voxelization/oracle.h"

#include <algorithm>

#include "harness/parallel.h"
#include "kernels/cluster_voxelization/raster.h"

namespace assay::cluster_voxelization {

Grid grid_of(const Case& c) {
  const auto p = c.params<ClusterParams>();
  return {std::min(p.columns, kMaxClusterColumns), std::min(p.rows, kMaxClusterRows),
          std::min(p.slices, kMaxClusterSlices)};
}
ItemCounts item_counts(const Case& c) {
  const auto p = c.params<ClusterParams>();
  return {std::min(p.lights, kMaxClusterLights), std::min(p.decals, kMaxClusterDecals),
          std::min(p.probes, kMaxClusterProbes)};
}

namespace {

// Calls visit(item, cell index, Item, Cell, x, y, z, in bounds) of each pair that may be in the item's bounds.
template <class Visit>
void visit_pairs(const Case& c, uint first, uint count, Visit visit) {
  const Edges e{grid_of(c), c.input<float>("edges")};
  const auto items = c.input<ClusterItem>("items");
  for (uint i = 0; i < count; ++i) {
    if (!is_usable(items[first + i])) continue;
    const Item item = item_of(items[first + i]);
    const Bounds b = bounds_of(item, e);
    for (uint z = b.slices.first; z <= b.slices.last; ++z)
      for (uint y = b.rows.first; y <= b.rows.last; ++y)
        for (uint x = b.columns.first; x <= b.columns.last; ++x) {
          const bool sure = b.slices.must(z) && b.rows.must(y) && b.columns.must(x);
          visit(i, (uint64_t{z} * e.grid.rows + y) * e.grid.columns + x, item, e, x, y, z, sure);
        }
  }
}

// The cells of items first + begin to first + end - 1, numbered from `first`.
void answer_items(const Case& c, Bits& two_way, Bits& exact, uint first, uint begin, uint end) {
  const uint64_t cells = grid_of(c).cells();
  visit_pairs(c, first + begin, end - begin,
              [&](uint i, uint64_t at, const Item& item, const Edges& e, uint x, uint y, uint z, bool sure) {
                i += begin;
                const Cell cell = e.cell(x, y, z);
                const Said faces = by_faces(item, cell);
                if (!faces.may_keep) return;
                two_way.set(two_way.high, i, at, cells);
                const Said edges = by_edges(item, cell) && by_sides(item, cell);
                if (edges.may_keep) exact.set(exact.high, i, at, cells);
                const bool touch = (sure && faces.must_keep && edges.must_keep) || touches(item, cell, e, x, y);
                if (touch) exact.set(exact.low, i, at, cells);
                if (touch || (sure && faces.must_keep)) two_way.set(two_way.low, i, at, cells);
              });
}

// Words of different items are different words.
void answer_kind(const Case& c, Answer& answer, const std::string& kind, uint first, uint count) {
  const uint64_t all = words(count) * grid_of(c).cells();
  Bits two_way(all), exact(all);
  in_parallel(words(count), [&](uint64_t w) {
    const uint begin = static_cast<uint>(w) * 32;
    answer_items(c, two_way, exact, first, begin, std::min(begin + 32, count));
  });
  answer["two_way_" + kind] = expect_bits(two_way);
  answer["exact_" + kind] = expect_bits(exact);
  answer_raster(c, answer, kind, first, count, two_way.high);
}

}  // namespace

Answer mark(const Case& c) {
  const ItemCounts n = item_counts(c);
  Answer answer;
  answer_kind(c, answer, "lights", 0, n.lights);
  answer_kind(c, answer, "decals", n.lights, n.decals);
  answer_kind(c, answer, "probes", n.lights + n.decals, n.probes);
  uint dropped = 0;
  for (const ClusterItem& item : c.input<ClusterItem>("items").first(n.all())) dropped += !is_usable(item);
  answer["dropped_items"] = expect_all(std::vector<uint>{dropped});
  return answer;
}

uint64_t touching_pairs(const Case& c) {
  uint64_t pairs = 0;
  visit_pairs(c, 0, item_counts(c).all(),
              [&](uint, uint64_t, const Item& item, const Edges& e, uint x, uint y, uint z, bool) {
                pairs += touches(item, e.cell(x, y, z), e, x, y);
              });
  return pairs;
}

}  // namespace assay::cluster_voxelization
