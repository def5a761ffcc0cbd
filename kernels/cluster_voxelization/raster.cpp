#include "kernels/cluster_voxelization/raster.h"

#include <algorithm>

#include "harness/parallel.h"
#include "kernels/cluster_voxelization/hexahedron.h"

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
  const Shape shape = shape_of(raw);
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
  answer_smaller(c, answer, kind, first, count, to.hi_z);
  answer["hexahedra_" + kind] = expect_bits(to.hexahedra);
  answer["hi_z_" + kind] = expect_bits(to.hi_z);
  answer["two_pass_" + kind] = expect_bits(to.two_pass);
}

}  // namespace assay::cluster_voxelization
