#include "kernels/cluster_voxelization/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/oracle.h"
#include "kernels/cluster_voxelization/solid.h"

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

using glm::dvec2;

constexpr double kRounding = 8 * kUnitRoundoff * (1 + 0x1p-18), kTiny = 0x1p-79;  // README, Error
constexpr double kWide = 0x1p-48;                                                 // of double's own sums

template <class Corners>
dvec2 interval(const Corners& corners, const dvec3& m) {
  dvec2 reach(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const dvec3& p : corners) {
    const double at = glm::dot(m, p);
    reach = dvec2(std::min(reach.x, at), std::max(reach.y, at));
  }
  return reach;
}

// What a device may say of two things that are `gap` apart along an axis (below 0: they overlap).
struct Said {
  bool may_keep = true, must_keep = true;
  Said operator&&(const Said& o) const { return {may_keep && o.may_keep, must_keep && o.must_keep}; }
};
// `sum`: the magnitudes of its terms; an eighth of the device's room for rounding is more than it needs: half of that
// is certain, and so is what it leaves for flushed terms.
Said said_of(double gap, double sum) {
  return {gap <= 2 * (kRounding * sum + kTiny), gap <= 0.5 * kUnitRoundoff * sum + kTiny / 4};
}

// How far the hulls are apart along an axis, first the one then the other way (below 0: they overlap), at least and at
// most: as the axis, the item's sums and the cell's are rounded.
struct Gaps {
  dvec2 least, most;
};
Gaps gaps_along(const Item& item, const Cell& cell, const Axis& axis) {
  const dvec3 m = glm::abs(axis.direction) + axis.off;
  const dvec2 there = interval(item.corners, axis.direction);
  const double off = glm::dot(axis.off, item.reach), room = 2 * kRounding * glm::dot(m, item.reach) + off;
  const double infinite = std::numeric_limits<double>::infinity();
  dvec2 wide(infinite, -infinite), narrow = wide;
  for (int i = 0; i < 8; ++i) {
    const dvec3& reach = cell.reach[i / 4];
    const double at = glm::dot(axis.direction, cell.corners[i]), off_here = glm::dot(axis.off, reach);
    const double room_here = 2 * (kRounding * glm::dot(m, reach) + kTiny * reach.z) + off_here;
    wide = dvec2(std::min(wide.x, at - room_here), std::max(wide.y, at + room_here));
    narrow = dvec2(std::min(narrow.x, at + off_here), std::max(narrow.y, at - off_here));
  }
  return {dvec2(wide.x - there.y, there.x - wide.y) - room, dvec2(narrow.x - there.y, there.x - narrow.y) + off};
}

Said along(const Item& item, const Cell& cell, const Axis& axis, bool both) {
  const Gaps gaps = gaps_along(item, cell, axis);
  const double least = both ? std::max(gaps.least.x, gaps.least.y) : gaps.least.x;
  const double most = both ? std::max(gaps.most.x, gaps.most.y) : gaps.most.x;
  return {least <= 4 * kTiny, most <= kTiny / 4};
}

// ---- The tests

// First and last of what the item reaches: at most, and at least (first > last: perhaps nothing).
struct Reach {
  uint first = 1, last = 0, sure_first = 1, sure_last = 0;
  bool may(uint i) const { return i >= first && i <= last; }
  bool must(uint i) const { return i >= sure_first && i <= sure_last; }
};

template <class Of>
Reach reach_of(uint count, Of of) {
  Reach r;
  bool any = false, sure = false;
  for (uint i = 0; i < count; ++i) {
    const Said said = of(i);
    if (said.may_keep) r.first = any ? r.first : i, r.last = i, any = true;
    if (said.must_keep) r.sure_first = sure ? r.sure_first : i, r.sure_last = i, sure = true;
  }
  return r;
}

// All of the item on one side of a plane through the eye: its slope is the cell's edge, exactly.
Said beside(const Item& item, const dvec3& m, bool larger) {
  const dvec2 there = interval(item.corners, m);
  return said_of(larger ? there.x : -there.y, glm::dot(glm::abs(m), item.reach));
}

struct Bounds {
  Reach columns, rows, slices;
};

struct Edges {
  Grid grid;
  std::span<const float> of;
  double column(uint i) const { return of[i]; }
  double row(uint i) const { return of[grid.columns + 1 + i]; }
  double slice(uint i) const { return of[grid.columns + grid.rows + 2 + i]; }
  Cell cell(uint x, uint y, uint z) const {
    return cell_of({column(x), column(x + 1)}, {row(y), row(y + 1)}, {slice(z), slice(z + 1)});
  }
};

Bounds bounds_of(const Item& item, const Edges& e) {
  const dvec2 depths = interval(item.corners, dvec3(0, 0, 1));
  return {reach_of(e.grid.columns,
                   [&](uint i) {
                     return beside(item, dvec3(1, 0, -e.column(i)), false) &&
                            beside(item, dvec3(1, 0, -e.column(i + 1)), true);
                   }),
          reach_of(e.grid.rows,
                   [&](uint i) {
                     return beside(item, dvec3(0, 1, -e.row(i)), false) &&
                            beside(item, dvec3(0, 1, -e.row(i + 1)), true);
                   }),
          reach_of(e.grid.slices, [&](uint i) {
            return said_of(e.slice(i) - depths.y, item.reach.z + std::fabs(e.slice(i))) &&
                   said_of(depths.x - e.slice(i + 1), item.reach.z + std::fabs(e.slice(i + 1)));
          })};
}

Said by_faces(const Item& item, const Cell& cell) {
  Said said;
  for (const Axis& face : item.faces) {
    if (!std::isfinite(face.off.x)) {
      said.must_keep = false;
      continue;
    }
    said = said && along(item, cell, face, false);
    if (!said.may_keep) break;
  }
  return said;
}

Axis cross_of(const dvec3& cell_edge, const Axis& edge) {
  const dvec3 a = glm::abs(cell_edge), b = glm::abs(edge.direction);
  const auto sum = [&](const dvec3& q) {
    return dvec3(a.y * q.z + a.z * q.y, a.z * q.x + a.x * q.z, a.x * q.y + a.y * q.x);
  };
  return {glm::cross(cell_edge, edge.direction), 3 * kUnitRoundoff * sum(b) + sum(edge.off) + dvec3(0x1p-100)};
}

Said by_edges(const Item& item, const Cell& cell) {
  Said said;
  for (const Axis& edge : item.edges)
    for (const dvec3& of_cell : cell.edges) {
      said = said && along(item, cell, cross_of(of_cell, edge), true);
      if (!said.may_keep) return said;
    }
  return said;
}

Said by_sides(const Item& item, const Cell& cell) {
  Said said;
  for (const dvec3& edge : cell.edges)  // of the four to the eye, two lie in each side
    if (edge.z == 1)
      said = said && along(item, cell, {dvec3(1, 0, -edge.x)}, true) && along(item, cell, {dvec3(0, 1, -edge.y)}, true);
  return said;
}

// Whether they touch: no direction separates them. The exact answer, but for double's rounding, which counts as apart.
bool touches(const Item& item, const Cell& cell, const Edges& e, uint x, uint y) {
  const auto apart = [&](const dvec3& m) {
    const dvec2 there = interval(item.corners, m), here = interval(cell.corners, m);
    return std::max(there.x - here.y, here.x - there.y) > -kWide * glm::dot(glm::abs(m), item.reach + cell.reach[1]);
  };
  if (apart(dvec3(0, 0, 1))) return false;
  for (const uint i : {0u, 1u})
    if (apart(dvec3(1, 0, -e.column(x + i))) || apart(dvec3(0, 1, -e.row(y + i)))) return false;
  for (const Axis& face : item.faces)
    if (apart(face.direction)) return false;
  for (const Axis& edge : item.edges)
    for (const dvec3& of_cell : cell.edges)
      if (apart(glm::cross(of_cell, edge.direction))) return false;
  return true;
}

// ---- The answer

struct Bits {
  std::vector<uint> low, high;
  void set(std::vector<uint>& to, uint item, uint64_t cell, uint64_t cells) {
    to[item / 32 * cells + cell] |= 1u << item % 32;
  }
};

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

Expected expect_bits(const Bits& bits) {
  Expected x = expect_all(bits.low);
  x.high = expect_all(bits.high).low;
  return x;
}

void answer_kind(const Case& c, Answer& answer, const std::string& kind, uint first, uint count) {
  const uint64_t cells = grid_of(c).cells(), all = words(count) * cells;
  Bits two_way{std::vector<uint>(all), std::vector<uint>(all)}, exact = two_way;
  visit_pairs(c, first, count,
              [&](uint i, uint64_t at, const Item& item, const Edges& e, uint x, uint y, uint z, bool sure) {
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
  answer["two_way_" + kind] = expect_bits(two_way);
  answer["exact_" + kind] = expect_bits(exact);
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
