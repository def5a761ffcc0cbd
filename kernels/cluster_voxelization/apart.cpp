#include "kernels/cluster_voxelization/apart.h"

#include <algorithm>
#include <limits>

namespace assay::cluster_voxelization {

namespace {

constexpr double kWide = 0x1p-48;  // of double's own sums

template <class Corners>
dvec2 interval_of(const Corners& corners, const dvec3& m) {
  dvec2 reach(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const dvec3& p : corners) {
    const double at = glm::dot(m, p);
    reach = dvec2(std::min(reach.x, at), std::max(reach.y, at));
  }
  return reach;
}

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
  const dvec2 there = interval_of(item.corners, axis.direction);
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

Axis cross_of(const dvec3& cell_edge, const Axis& edge) {
  const dvec3 a = glm::abs(cell_edge), b = glm::abs(edge.direction);
  const auto sum = [&](const dvec3& q) {
    return dvec3(a.y * q.z + a.z * q.y, a.z * q.x + a.x * q.z, a.x * q.y + a.y * q.x);
  };
  return {glm::cross(cell_edge, edge.direction), 3 * kUnitRoundoff * sum(b) + sum(edge.off) + dvec3(0x1p-100)};
}

}  // namespace

dvec2 interval(const Item& item, const dvec3& m) { return interval_of(item.corners, m); }

Said along(const Item& item, const Cell& cell, const Axis& axis, bool both) {
  const Gaps gaps = gaps_along(item, cell, axis);
  const double least = both ? std::max(gaps.least.x, gaps.least.y) : gaps.least.x;
  const double most = both ? std::max(gaps.most.x, gaps.most.y) : gaps.most.x;
  return {least <= 4 * kTiny, most <= kTiny / 4};
}

Said beside(const Item& item, const dvec3& m, bool larger) {
  const dvec2 there = interval_of(item.corners, m);
  return said_of(larger ? there.x : -there.y, glm::dot(glm::abs(m), item.reach));
}

Bounds bounds_of(const Item& item, const Edges& e) {
  const dvec2 depths = interval_of(item.corners, dvec3(0, 0, 1));
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

bool touches(const Item& item, const Cell& cell, const Edges& e, uint x, uint y) {
  const auto apart = [&](const dvec3& m) {
    const dvec2 there = interval(item, m), here = interval_of(cell.corners, m);
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

}  // namespace assay::cluster_voxelization
