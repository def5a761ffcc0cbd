#include <bit>

#include "harness/parallel.h"
#include "kernels/cluster_voxelization/hexahedron.h"

namespace assay::cluster_voxelization {

namespace {

// Bins are the columns of a coarser grid, whose edges are some of the grid's.
struct Bins {
  std::vector<float> edges;
  Grid grid;
  explicit Bins(const Edges& e)
      : grid{ceil_div(e.grid.columns, kBinSide), ceil_div(e.grid.rows, kBinSide), e.grid.slices} {
    for (uint i = 0; i <= grid.columns; ++i) edges.push_back(e.of[std::min(i * kBinSide, e.grid.columns)]);
    const auto rows = e.of.subspan(e.grid.columns + 1), slices = rows.subspan(e.grid.rows + 1);
    for (uint i = 0; i <= grid.rows; ++i) edges.push_back(rows[std::min(i * kBinSide, e.grid.rows)]);
    edges.insert(edges.end(), slices.begin(), slices.begin() + grid.slices + 1);
  }
};

// A bin is reached where one of its columns or rows is.
Reach bins_of(const Reach& r) {
  const bool is_sure = r.sure_first <= r.sure_last, may = r.first <= r.last;
  return {may ? r.first / kBinSide : 1, may ? r.last / kBinSide : 0, is_sure ? r.sure_first / kBinSide : 1,
          is_sure ? r.sure_last / kBinSide : 0};
}

void mark_bins(const ClusterItem& raw, const Edges& fine, const Edges& bins, uint i, Bits& to) {
  if (!is_usable(raw)) return;
  const Shape shape = shape_of(raw);
  const Bounds bounds = bounds_of(shape.item, fine);
  const Reach across = bins_of(bounds.columns), down = bins_of(bounds.rows);
  for (uint z = bounds.slices.first; z <= bounds.slices.last; ++z)
    for (uint y = down.first; y <= down.last; ++y)
      for (uint x = across.first; x <= across.last; ++x) {
        const uint64_t at = (uint64_t{z} * bins.grid.rows + y) * bins.grid.columns + x;
        const bool sure = across.must(x) && down.must(y) && bounds.slices.must(z);
        const Said said = hexahedron(shape, {bins, x, y, {}}, z);
        if (!said.may_keep) continue;
        Bits::set(to.high, i, at, bins.grid.cells());
        if ((sure && said.must_keep) || touches(shape.item, bins.cell(x, y, z), bins, x, y))
          Bits::set(to.low, i, at, bins.grid.cells());
      }
}

// Of each column, what it has in any slice.
std::vector<uint> flattened(const std::vector<uint>& bits, const Grid& grid, uint64_t words) {
  const uint64_t columns = uint64_t{grid.columns} * grid.rows;
  std::vector<uint> flat(words * columns);
  for (uint64_t w = 0; w < words; ++w)
    for (uint64_t cell = 0; cell < grid.cells(); ++cell)
      flat[w * columns + cell % columns] |= bits[w * grid.cells() + cell];
  return flat;
}

// How many each list has, at least and at most.
struct Lengths {
  std::vector<uint> low, high;
};
std::vector<uint> lengths_of(const std::vector<uint>& bits, uint64_t lists) {
  std::vector<uint> lengths(lists);
  for (uint64_t i = 0; i < bits.size(); ++i) lengths[i % lists] += static_cast<uint>(std::popcount(bits[i]));
  return lengths;
}
Lengths lengths_of(const Bits& bits, uint64_t lists) {
  return {lengths_of(bits.low, lists), lengths_of(bits.high, lists)};
}

}  // namespace

void answer_smaller(const Case& c, Answer& answer, const std::string& kind, uint first, uint count, const Bits& hi_z) {
  const Edges fine{grid_of(c), c.input<float>("edges")};
  if (fine.grid.cells() == 0 || count == 0) {
    answer["smaller_" + kind] = expect_bits(Bits(0));
    return;
  }
  const Bins bins(fine);
  const Edges coarse{bins.grid, bins.edges};
  const uint64_t cells = fine.grid.cells(), columns = uint64_t{fine.grid.columns} * fine.grid.rows;
  Bits of_bins(words(count) * bins.grid.cells()), of_columns(0), to(words(count) * cells);
  in_parallel(words(count), [&](uint64_t w) {
    for (uint i = static_cast<uint>(w) * 32; i < std::min(static_cast<uint>(w) * 32 + 32, count); ++i)
      mark_bins(c.input<ClusterItem>("items")[first + i], fine, coarse, i, of_bins);
  });
  of_columns.low = flattened(hi_z.low, fine.grid, words(count));
  of_columns.high = flattened(hi_z.high, fine.grid, words(count));
  const Lengths long_columns = lengths_of(of_columns, columns), long_bins = lengths_of(of_bins, bins.grid.cells());
  for (uint64_t cell = 0; cell < cells; ++cell) {
    const uint64_t column = cell % columns, x = column % fine.grid.columns, y = column / fine.grid.columns;
    const uint64_t bin = (cell / columns * bins.grid.rows + y / kBinSide) * bins.grid.columns + x / kBinSide;
    const bool may_column = long_columns.low[column] <= long_bins.high[bin],
               may_bin = long_bins.low[bin] < long_columns.high[column];
    for (uint64_t w = 0; w < words(count); ++w) {
      const uint64_t c_at = w * columns + column, b_at = w * bins.grid.cells() + bin;
      to.low[w * cells + cell] = (may_column ? of_columns.low[c_at] : ~0u) & (may_bin ? of_bins.low[b_at] : ~0u);
      to.high[w * cells + cell] = (may_column ? of_columns.high[c_at] : 0u) | (may_bin ? of_bins.high[b_at] : 0u);
    }
  }
  answer["smaller_" + kind] = expect_bits(to);
}

}  // namespace assay::cluster_voxelization
