// Listed pairs over touching ones, on the distributions of numerics.md 3.2.
#include <fmt/format.h>

#include <bit>

#include "harness/known.h"
#include "kernels/cluster_voxelization/inputs.h"

namespace assay::cluster_voxelization {

namespace {

struct ItemClass {
  const char* name;
  double size;  // aspect of a box, half angle of a spot in degrees
  bool spot;
};
constexpr ItemClass kItems[] = {{"box, aspect 2", 2, false},
                                {"box, aspect 20", 20, false},
                                {"spot of 10 deg", 10, true},
                                {"spot of 30 deg", 30, true},
                                {"spot of 55 deg", 55, true}};
struct GridClass {
  const char* name;
  uint columns, rows, slices, items;
  double two_way_goal;  // kernels.md; items of 0.25 m and more
};
constexpr GridClass kGrids[] = {
    {"16x8x24", 16, 8, 24, 400, 1.17}, {"60x34x1", 60, 34, 1, 400, 0}, {"60x34x24", 60, 34, 24, 50, 1.28}};

Case class_case(const GridClass& grid, const ItemClass& item, double radius) {
  Scene s;
  s.columns = grid.columns, s.rows = grid.rows, s.slices = grid.slices, s.extended = false;
  Pcg32 rng(32);
  for (uint i = 0; i < grid.items; ++i)
    s.lights.push_back(item.spot ? random_spot(rng, s, radius, item.size) : random_box(rng, s, radius, item.size));
  return s.to_case();
}

double goal_of(const Variant& v, const Case& c) {
  if (v.name == "separating_axis") return grid_of(c).slices > 1 ? 1.001 : 1.01;  // numerics.md 3.3 of full depth
  const bool hexahedra = v.name == "hexahedra_raster" || v.name == "hexahedra_hi_z";
  if (hexahedra && grid_of(c).slices == 1) return 1.01;  // outlines are exact
  for (const GridClass& g : kGrids)
    if ((v.name == "two_way" || hexahedra) && g.columns == grid_of(c).columns && g.slices == grid_of(c).slices)
      return g.two_way_goal;
  return 0;
}

std::vector<Figure> figures(const Variant& v, const Case& c, const std::map<std::string, Bytes>& written) {
  const Bytes& bytes = written.at("light_bits");
  uint64_t listed = 0;
  for (const std::byte b : bytes) listed += static_cast<uint64_t>(std::popcount(std::to_integer<unsigned>(b)));
  static Known<uint64_t> known;
  const uint64_t touching = known.at(c.name, [&] { return touching_pairs(c); });
  const double items = item_counts(c).lights, listed_pairs = static_cast<double>(listed),
               pairs = static_cast<double>(touching);
  return {{"cells an item", pairs / items, 0}, {"listed / touching", listed_pairs / pairs, goal_of(v, c)}};
}

}  // namespace

ErrorTable error_table() {
  ErrorTable t = {.classes = {}, .figures = figures};
  for (const GridClass& grid : kGrids)
    for (const ItemClass& item : kItems)
      for (const double radius : {0.25, 1.0, 4.0, 16.0}) {
        const std::string name = fmt::format("{}, {}, {} m", grid.name, item.name, radius);
        t.classes.push_back({name, "numerics.md 3.2", [&grid, &item, radius, name] {
                               Case c = class_case(grid, item, radius);
                               c.name = name;
                               return c;
                             }});
      }
  return t;
}

}  // namespace assay::cluster_voxelization
