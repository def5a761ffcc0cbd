#include "harness/clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/formats/cluster_lists.h"

namespace assay {

std::vector<float> slice_edges(double near, double far, uint32_t slices) {
  std::vector<float> edges;
  for (uint32_t k = 0; k <= slices; ++k) {
    const double exact = near * std::pow(far / near, static_cast<double>(k) / slices);
    const auto f = static_cast<float>(exact);
    edges.push_back(f < exact ? std::nextafter(f, HUGE_VALF) : f);
  }
  return edges;
}

std::vector<float> reversed_slice_edges(const std::vector<float>& edges, float near_plane) {
  std::vector<float> reversed;
  for (const float z : edges) {
    // d * z is exact in double, the quotient is not: the comparison decides.
    auto d = static_cast<float>(std::min(double{near_plane} / double{z}, double{std::numeric_limits<float>::max()}));
    const auto is_beyond = [&](float at) { return double{at} * double{z} <= double{near_plane}; };
    while (!is_beyond(d)) d = std::nextafter(d, 0.0f);
    while (d < std::numeric_limits<float>::max() && is_beyond(std::nextafter(d, HUGE_VALF)))
      d = std::nextafter(d, HUGE_VALF);
    reversed.push_back(d);
  }
  return reversed;
}

ClusterGrid grid_over(Extent picture, Extent cell, uint32_t slices) {
  return {ceil_div(picture.width, cell.width), ceil_div(picture.height, cell.height), slices, cell.width, cell.height};
}

Extent coarse_cell(Extent picture) { return {ceil_div(picture.width, 16), ceil_div(picture.height, 8)}; }

Extent fine_cell(Extent picture) {
  return {std::max(32u, ceil_div(picture.width, kMaxClusterColumns)),
          std::max(32u, ceil_div(picture.height, kMaxClusterRows))};
}

uint32_t first_of_level(Extent picture, uint32_t level) {
  uint32_t first = 0;
  const uint32_t side = std::max(picture.width, picture.height);
  for (uint32_t k = 1; k < level && side > 1u << k; ++k)
    first += ceil_div(picture.width, 1u << k) * ceil_div(picture.height, 1u << k);
  return first;
}

uint32_t list_capacity(const ClusterGrid& g) {
  return static_cast<uint32_t>(
      std::min<uint64_t>(uint64_t{g.columns} * g.rows * g.slices * kMaxClusterEntries, 1u << 22));
}

}  // namespace assay
