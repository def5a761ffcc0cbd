#include "kernels/cluster_voxelization/outline.h"

#include <cmath>

#include "kernels/cluster_voxelization/apart.h"

namespace assay::cluster_voxelization {

namespace {

dvec3 sums(const dvec3& p, const dvec3& q) {  // of the magnitudes of a cross product's terms
  return dvec3(p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x);
}

// A point on an edge, a sum of up to three of the item's vectors, and the edge's direction, of up to three.
struct Edge {
  dvec3 on, direction, reach;  // reach: of the direction
};

// Four roundings of a term, two of them of the sums that are multiplied; README, Error.
Axis eye_plane(const Edge& edge, const dvec3& reach) {
  return {glm::cross(edge.on, edge.direction), 5 * kUnitRoundoff * sums(reach, edge.reach) + dvec3(0x1p-100)};
}

struct Vectors {
  dvec3 o, a, b, c;
  explicit Vectors(const ClusterItem& i) : o(i.origin), a(i.a), b(i.b), c(i.c) {}
};

// Around o + d ± u ± v.
void add_round(std::vector<Edge>& to, const dvec3& middle, const dvec3& u, const dvec3& v) {
  for (const double sign : {1.0, -1.0}) {
    to.push_back({middle + sign * v, u, glm::abs(u)});
    to.push_back({middle + sign * u, v, glm::abs(v)});
  }
}

std::vector<Edge> edges_of(const ClusterItem& item) {
  const Vectors v(item);
  std::vector<Edge> edges;
  if (item.shape != kShapePyramid) {
    for (const double sign : {1.0, -1.0}) {
      add_round(edges, v.o + sign * v.c, v.a, v.b);
      for (const double other : {1.0, -1.0}) edges.push_back({v.o + sign * v.a + other * v.b, v.c, glm::abs(v.c)});
    }
    return edges;
  }
  add_round(edges, v.o + v.c, v.a, v.b);
  for (int i = 0; i < 4; ++i)
    edges.push_back(
        {v.o, v.c + (i & 1 ? -v.a : v.a) + (i & 2 ? -v.b : v.b), glm::abs(v.a) + glm::abs(v.b) + glm::abs(v.c)});
  return edges;
}

// Of a number that a device compares with its room of 16 u of `sum`, and may be off by 13 u: at most the room?
Facing at_most_room(double number, double sum) {
  const double room = 2 * kRounding * sum + kTiny, off = 13 * kUnitRoundoff * (1 + 0x1p-18) * sum + kTiny;
  return {number <= room + off, number <= room * (1 - 0x1p-16) - off};
}
Facing either(const Facing& a, const Facing& b) { return {a.may || b.may, a.must || b.must}; }

}  // namespace

std::vector<Side> outline_of(const ClusterItem& raw, const Item& item) {
  std::vector<Side> sides;
  for (const Edge& edge : edges_of(raw)) {
    const Axis axis = eye_plane(edge, item.reach);
    const dvec2 there = interval(item, axis.direction);
    const double sum = glm::dot(sums(item.reach, edge.reach), item.reach);
    const Facing below = at_most_room(there.y, sum), above = at_most_room(-there.x, sum);
    if (below.may) sides.push_back({axis, below.must});
    if (above.may) sides.push_back({{-axis.direction, axis.off}, above.must});
  }
  return sides;
}

namespace {

// A face around o + d ± u ± v, or, u being 0, a triangle from o to o + d ± v.
struct Polygon {
  dvec3 o, d, u, v;
  bool triangle;
  dvec3 corner(int i) const { return o + d + (i & 1 ? u : -u) + (i & 2 ? v : -v); }
};

Item hull_of(const Polygon& p, const Item& item) {
  Item hull;
  for (int i = 0; i < 4; ++i) hull.corners.push_back(p.corner(i));
  if (p.triangle) hull.corners.push_back(p.o);
  hull.reach = item.reach;
  return hull;
}

// Which way it looks: a normal is turned outward by `out`, beyond rounding; the eye is on its inner side or beyond.
void face_eye(Face& face, const dvec3& normal, const dvec3& of_normal, const dvec3& out, const dvec3& on) {
  const double outward = glm::dot(normal, out), at = (outward < 0 ? -1 : 1) * glm::dot(normal, on);
  const Facing vague = at_most_room(std::fabs(outward), glm::dot(of_normal, glm::abs(out)));
  const double sum = glm::dot(of_normal, face.hull.reach);
  face.front = either(vague, at_most_room(at, sum)), face.back = either(vague, at_most_room(-at, sum));
}

// `normal`: as an edge's, the product that makes it.
Face face_of(const Polygon& p, const Item& item, const Edge& normal, const std::vector<Edge>& edges) {
  Face face{.hull = hull_of(p, item), .planes = {}, .front = {}, .back = {}};
  const dvec3 of_on = p.triangle ? normal.reach : glm::abs(normal.on);
  face.planes.push_back({glm::cross(normal.on, normal.direction),
                         5 * kUnitRoundoff * sums(of_on, glm::abs(normal.direction)) + dvec3(0x1p-100)});
  for (const Edge& edge : edges) face.planes.push_back(eye_plane(edge, item.reach));
  return face;
}

Face quad_of(const Polygon& p, const Item& item) {
  std::vector<Edge> edges;
  add_round(edges, p.o + p.d, p.u, p.v);
  Face face = face_of(p, item, {p.u, p.v, dvec3(0)}, edges);
  face_eye(face, glm::cross(p.u, p.v), sums(glm::abs(p.u), glm::abs(p.v)), p.d, p.o + p.d);
  return face;
}

// `aside`: the half axis at whose end the base's edge is; `v`: half of that edge.
Face side_of(const Vectors& vectors, const dvec3& aside, const dvec3& v, const Item& item) {
  const dvec3 &o = vectors.o, &c = vectors.c, d = c + aside, reach = glm::abs(c) + glm::abs(aside);
  Face face = face_of({o, d, dvec3(0), v, true}, item, {d, v, reach},
                      {{o + d, v, glm::abs(v)}, {o, d + v, reach + glm::abs(v)}, {o, d - v, reach + glm::abs(v)}});
  face_eye(face, glm::cross(d, v), sums(reach, glm::abs(v)), -c, o);
  return face;
}

}  // namespace

std::vector<Face> faces_of(const ClusterItem& raw, const Item& item) {
  const Vectors v(raw);
  if (raw.shape == kShapePyramid)
    return {side_of(v, v.a, v.b, item), side_of(v, -v.a, v.b, item), side_of(v, v.b, v.a, item),
            side_of(v, -v.b, v.a, item), quad_of({v.o, v.c, v.a, v.b, false}, item)};
  const dvec3 axes[] = {v.a, v.b, v.c};
  std::vector<Face> faces;
  for (size_t i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0})
      faces.push_back(quad_of({v.o, sign * axes[i], axes[(i + 1) % 3], axes[(i + 2) % 3], false}, item));
  return faces;
}

Facing eye_inside(const Item& item) {
  Facing inside;
  for (const Axis& face : item.faces) {
    const double far = interval(item, face.direction).y;
    if (!std::isfinite(face.off.x)) {
      inside.must = false;
      continue;
    }
    const double off = glm::dot(face.off, item.reach);
    const double room = 2 * kRounding * glm::dot(glm::abs(face.direction) + face.off, item.reach) + 4 * kTiny;
    inside.may = inside.may && far + off + room >= 0;
    inside.must = inside.must && far - off >= 0;
  }
  return inside;
}

}  // namespace assay::cluster_voxelization
