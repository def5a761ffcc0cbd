#include "kernels/cluster_voxelization/raster.h"

#include <algorithm>

#include "harness/parallel.h"
#include "kernels/cluster_voxelization/outline.h"

namespace assay::cluster_voxelization {

Expected expect_bits(const Bits& bits) {
  Expected x = expect_all(bits.low);
  x.high = expect_all(bits.high).low;
  return x;
}

// Six roundings of the quotient, and a device's room of 2^-20 for them, are less than 2^-19 together.
Depths depths_of(const vec2& reversed, float near_plane) {
  const bool is_plane = near_plane >= 0x1p-38f && near_plane < 0x1p38f;
  if (!is_plane || std::signbit(reversed.x) || !(reversed.y >= reversed.x)) return {};
  const dvec2 exact(near_plane / double{reversed.y}, near_plane / double{reversed.x});
  return {exact, dvec2(exact.x * (1 - 0x1p-19) - 0x1p-60, exact.y * (1 + 0x1p-19) + 0x1p-60)};
}

namespace {

// A cell as wide as a device may take it, and as narrow; either may be nothing.
struct Clipped {
  dvec2 wide, narrow;
  bool may() const { return wide.x <= wide.y; }
  bool sure() const { return narrow.x <= narrow.y; }
  // Surely; no plane through the eye keeps it away then.
  bool has_eye() const { return sure() && narrow.x <= 0; }
};

dvec2 common(const dvec2& a, const dvec2& b) { return {std::max(a.x, b.x), std::min(a.y, b.y)}; }

struct Column {  // of the screen: a column and a row
  const Edges& edges;
  uint x, y;
  Depths depths;

  // A slice, to the depths of the column and of a hull; a device may give the hull twice its room.
  // Slice -1: what lies before the first; one past the last: what lies beyond.
  Clipped slice(int z, const Item& hull) const {
    const int slices = static_cast<int>(edges.grid.slices);
    const dvec2 all(z < 0 ? 0 : edges.slice(static_cast<uint>(z)),
                    z == slices ? HUGE_VAL : edges.slice(static_cast<uint>(z + 1)));
    const dvec2 of_hull = interval(hull, dvec3(0, 0, 1));
    const double room = 2 * (kRounding * hull.reach.z + kTiny);
    return {common(all, common(depths.wide, of_hull + dvec2(-room, room))), common(all, common(depths.exact, of_hull))};
  }
};

Said clipped_along(const Item& hull, const Column& at, const Clipped& z, const Axis& axis, bool both) {
  if (!along(hull, at.edges.cell(at.x, at.y, z.wide), axis, both).may_keep) return {false, false};
  return {true, z.sure() && along(hull, at.edges.cell(at.x, at.y, z.narrow), axis, both).must_keep};
}

// Half-spaces of which a device has some and may have others.
Said by_half_space(const Item& hull, const Column& at, const Clipped& z, const Axis& axis, bool certain) {
  if (!std::isfinite(axis.off.x)) return {true, false};
  const Said said = clipped_along(hull, at, z, axis, false);
  return {said.may_keep || !certain, said.must_keep};
}

struct Shape {
  Item item;
  std::vector<Side> outline;
  std::vector<Face> faces;
  Facing inside;
};

Said hexahedron(const Shape& shape, const Column& at, uint z) {
  const Clipped cell = at.slice(static_cast<int>(z), shape.item);
  if (!cell.may()) return {false, false};
  Said said = {true, cell.sure()};
  for (const Axis& face : shape.item.faces) {
    said = said && by_half_space(shape.item, at, cell, face, true);
    if (!said.may_keep) return said;
  }
  for (const Side& side : shape.outline) {
    if (cell.has_eye()) break;
    said = said && by_half_space(shape.item, at, cell, side.axis, side.certain);
    if (!said.may_keep) return said;
  }
  return said;
}

// ---- Two passes

// Whether a face reaches a slice of a column.
Said face_in(const Face& face, const Column& at, int z) {
  const Clipped cell = at.slice(z, face.hull);
  if (!cell.may()) return {false, false};
  Said said = {true, cell.sure()};
  for (const Axis& plane : face.planes) {
    if (!said.may_keep || (cell.has_eye() && &plane != face.planes.data())) return said;
    said = said && clipped_along(face.hull, at, cell, plane, true);
  }
  return said;
}
Said face_in(const Face& face, const Edges& e, uint x, uint y) {
  return beside(face.hull, dvec3(1, 0, -e.column(x)), false) &&
         beside(face.hull, dvec3(1, 0, -e.column(x + 1)), true) && beside(face.hull, dvec3(0, 1, -e.row(y)), false) &&
         beside(face.hull, dvec3(0, 1, -e.row(y + 1)), true);
}

// Slices near .. far - 1; a near of kNever: none.
constexpr int kNever = 1 << 20;
struct Walk {
  int near = kNever, far = 0;
  bool has(int z) const { return z >= near && z < far; }
};

// What a face that reaches slice z does, as far as it does.
void walk(Walk& walk, bool front, bool back, bool inside, int z, int first) {
  if (back) walk.far = std::max(walk.far, z + 1);
  if (front) walk.near = std::min(walk.near, z);
  if (back && inside) walk.near = std::min(walk.near, first);
}

struct Walks {
  Walk may, must;
};

// Before the first slice and beyond the last there are faces too, of items that reach that far.
Walks walks_of(const Shape& shape, const Column& at, const Reach& slices) {
  const int all = static_cast<int>(at.edges.grid.slices), first = static_cast<int>(slices.first);
  const int last = static_cast<int>(slices.last), sure_first = static_cast<int>(slices.sure_first);
  Walks walks;
  for (const Face& face : shape.faces) {
    const Said reached = face_in(face, at.edges, at.x, at.y);
    if (!reached.may_keep) continue;
    for (int z = first == 0 ? -1 : first; z <= (last + 1 == all ? all : last); ++z) {
      const Said said = face_in(face, at, z) && reached;
      if (!said.may_keep) continue;
      const bool sure = said.must_keep && slices.must(static_cast<uint>(std::clamp(z, 0, all - 1)));
      walk(walks.may, face.front.may, face.back.may, shape.inside.may, z, first);
      walk(walks.must, sure && face.front.must, sure && face.back.must, shape.inside.must, z, sure_first);
    }
  }
  return walks;
}

// ---- The answers

struct Answers {
  Bits hexahedra, hi_z, two_pass;
};

struct Pair {
  uint item;
  uint64_t cells;
  const std::vector<uint>& may_touch;
};

void answer_column(const Pair& pair, const Shape& shape, const Bounds& bounds, Column at, const Depths& depths,
                   Answers& to) {
  const Walks walks = walks_of(shape, at, bounds.slices);
  const bool sure_column = bounds.columns.must(at.x) && bounds.rows.must(at.y);
  for (uint z = bounds.slices.first; z <= bounds.slices.last; ++z) {
    const Grid& grid = at.edges.grid;
    const uint64_t cell = (uint64_t{z} * grid.rows + at.y) * grid.columns + at.x;
    const bool near = Bits::has(pair.may_touch, pair.item, cell, pair.cells),
               sure = sure_column && bounds.slices.must(z);
    const auto mark = [&](Bits& bits, const Said& said, const dvec2& z_range) {
      const bool kept = sure && said.may_keep && said.must_keep;
      const bool touch = !kept && near && z_range.x <= z_range.y &&
                         touches(shape.item, at.edges.cell(at.x, at.y, z_range), at.edges, at.x, at.y);
      if (kept || touch) Bits::set(bits.low, pair.item, cell, pair.cells);
      if (said.may_keep) Bits::set(bits.high, pair.item, cell, pair.cells);
    };
    const dvec2 all(at.edges.slice(z), at.edges.slice(z + 1));
    at.depths = {};
    mark(to.hexahedra, near ? hexahedron(shape, at, z) : Said{false, false}, all);
    mark(to.two_pass, {walks.may.has(static_cast<int>(z)), walks.must.has(static_cast<int>(z))}, all);
    at.depths = depths;
    mark(to.hi_z, near ? hexahedron(shape, at, z) : Said{false, false}, common(all, depths.exact));
  }
}

void answer_item(const Case& c, const Edges& e, uint first, const std::vector<uint>& may_touch, uint i, Answers& to) {
  const ClusterItem& raw = c.input<ClusterItem>("items")[first + i];
  if (!is_usable(raw)) return;
  const auto p = c.params<ClusterParams>();
  const auto ranges = c.input<vec2>("depth_ranges").subspan(p.first_range);
  Shape shape{.item = item_of(raw), .outline = {}, .faces = {}, .inside = {}};
  shape.outline = outline_of(raw, shape.item), shape.faces = faces_of(raw, shape.item);
  shape.inside = eye_inside(shape.item);
  const Bounds bounds = bounds_of(shape.item, e);
  for (uint y = bounds.rows.first; y <= bounds.rows.last; ++y)
    for (uint x = bounds.columns.first; x <= bounds.columns.last; ++x)
      answer_column({i, e.grid.cells(), may_touch}, shape, bounds, {e, x, y, {}},
                    depths_of(ranges[size_t{y} * e.grid.columns + x], p.near_plane), to);
}

}  // namespace

void answer_raster(const Case& c, Answer& answer, const std::string& kind, uint first, uint count,
                   const std::vector<uint>& may_touch) {
  const Edges e{grid_of(c), c.input<float>("edges")};
  const uint64_t all = words(count) * e.grid.cells();
  Answers to{Bits(all), Bits(all), Bits(all)};
  in_parallel(words(count), [&](uint64_t w) {
    for (uint i = static_cast<uint>(w) * 32; i < std::min(static_cast<uint>(w) * 32 + 32, count); ++i)
      answer_item(c, e, first, may_touch, i, to);
  });
  answer["hexahedra_" + kind] = expect_bits(to.hexahedra);
  answer["hi_z_" + kind] = expect_bits(to.hi_z);
  answer["two_pass_" + kind] = expect_bits(to.two_pass);
}

}  // namespace assay::cluster_voxelization
