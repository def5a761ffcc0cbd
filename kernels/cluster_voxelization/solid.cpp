#include "kernels/cluster_voxelization/solid.h"

#include <algorithm>
#include <cmath>

#include "harness/oracle.h"

namespace assay::cluster_voxelization {

namespace {

// Each component of a float cross product is two products and a difference: 2 u of both, at most; a sum as an operand
// is one more.
Axis cross_of(const dvec3& p, const dvec3& q) {
  const dvec3 a = glm::abs(p), b = glm::abs(q);
  const dvec3 sum(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x);
  return {glm::cross(p, q), 4 * kUnitRoundoff * sum + dvec3(0x1p-100)};
}
Axis flipped(const Axis& axis) { return {-axis.direction, axis.off}; }

Item box_of(const dvec3& o, const dvec3& a, const dvec3& b, const dvec3& c) {
  Item item;
  for (int i = 0; i < 8; ++i) item.corners.push_back(o + (i & 1 ? a : -a) + (i & 2 ? b : -b) + (i & 4 ? c : -c));
  for (const Axis& face : {cross_of(b, c), cross_of(c, a), cross_of(a, b)})
    item.faces.push_back(face), item.faces.push_back(flipped(face));
  item.edges = {{a}, {b}, {c}};
  return item;
}

Item pyramid_of(const dvec3& o, const dvec3& a, const dvec3& b, const dvec3& c) {
  Item item;
  item.corners.push_back(o);
  for (int i = 0; i < 4; ++i) {
    const dvec3 side = c + (i & 1 ? -a : a) + (i & 2 ? -b : b);
    item.corners.push_back(o + side);
    item.edges.push_back({side, 2 * kUnitRoundoff * (glm::abs(a) + glm::abs(b) + glm::abs(c))});
  }
  item.edges.push_back({a}), item.edges.push_back({b});
  // Outward: away from the apex at the base, away from the base's centre at a side.
  for (const Axis& face : {cross_of(c + a, b), cross_of(c - a, b), cross_of(c + b, a), cross_of(c - b, a)})
    item.faces.push_back(glm::dot(face.direction, c) > 0 ? flipped(face) : face);
  const Axis base = cross_of(a, b);
  item.faces.push_back(glm::dot(base.direction, c) < 0 ? flipped(base) : base);
  for (Axis& face : item.faces) {
    const double along = std::fabs(glm::dot(face.direction, c));
    // A float may see the other sign: then its plane keeps nothing away, and this one's need not.
    if (along <= glm::dot(face.off, glm::abs(c)) + 4 * kUnitRoundoff * glm::dot(glm::abs(face.direction), glm::abs(c)))
      face.off = dvec3(HUGE_VAL);
  }
  return item;
}

}  // namespace

bool is_usable(const ClusterItem& item) {
  for (const vec3& v : {item.origin, item.a, item.b, item.c})
    for (int i = 0; i < 3; ++i)
      if (!(std::fabs(v[i]) < 0x1p38f)) return false;
  return true;
}

Item item_of(const ClusterItem& item) {
  const dvec3 o(item.origin), a(item.a), b(item.b), c(item.c);
  Item out = item.shape == kShapePyramid ? pyramid_of(o, a, b, c) : box_of(o, a, b, c);
  out.reach = glm::abs(o) + glm::abs(a) + glm::abs(b) + glm::abs(c);
  return out;
}

Cell cell_of(const glm::dvec2& x, const glm::dvec2& y, const glm::dvec2& z) {
  Cell cell;
  for (int i = 0; i < 8; ++i) {
    const double depth = i & 4 ? z.y : z.x;
    cell.corners[i] = dvec3((i & 1 ? x.y : x.x) * depth, (i & 2 ? y.y : y.x) * depth, depth);
  }
  const dvec3 slopes(std::max(std::fabs(x.x), std::fabs(x.y)), std::max(std::fabs(y.x), std::fabs(y.y)), 1);
  cell.reach[0] = slopes * z.x, cell.reach[1] = slopes * z.y;
  cell.edges[0] = dvec3(1, 0, 0), cell.edges[1] = dvec3(0, 1, 0);
  for (int i = 0; i < 4; ++i) cell.edges[2 + i] = dvec3(i & 1 ? x.y : x.x, i & 2 ? y.y : y.x, 1);
  return cell;
}

}  // namespace assay::cluster_voxelization
