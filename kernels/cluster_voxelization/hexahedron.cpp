#include "kernels/cluster_voxelization/hexahedron.h"

namespace assay::cluster_voxelization {

Clipped Column::slice(int z, const Item& hull) const {
  const int slices = static_cast<int>(edges.grid.slices);
  const dvec2 all(z < 0 ? 0 : edges.slice(static_cast<uint>(z)),
                  z == slices ? HUGE_VAL : edges.slice(static_cast<uint>(z + 1)));
  const dvec2 of_hull = interval(hull, dvec3(0, 0, 1));
  const double room = 2 * (kRounding * hull.reach.z + kTiny);
  return {common(all, common(depths.wide, of_hull + dvec2(-room, room))), common(all, common(depths.exact, of_hull))};
}

Shape shape_of(const ClusterItem& raw) {
  Shape shape{.item = item_of(raw), .outline = {}, .faces = {}, .inside = {}};
  shape.outline = outline_of(raw, shape.item), shape.faces = faces_of(raw, shape.item);
  shape.inside = eye_inside(shape.item);
  return shape;
}

Said clipped_along(const Item& hull, const Column& at, const Clipped& z, const Axis& axis, bool both) {
  if (!along(hull, at.edges.cell(at.x, at.y, z.wide), axis, both).may_keep) return {false, false};
  return {true, z.sure() && along(hull, at.edges.cell(at.x, at.y, z.narrow), axis, both).must_keep};
}

namespace {

// Half-spaces of which a device has some and may have others.
Said by_half_space(const Item& hull, const Column& at, const Clipped& z, const Axis& axis, bool certain) {
  if (!std::isfinite(axis.off.x)) return {true, false};
  const Said said = clipped_along(hull, at, z, axis, false);
  return {said.may_keep || !certain, said.must_keep};
}

}  // namespace

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

}  // namespace assay::cluster_voxelization
