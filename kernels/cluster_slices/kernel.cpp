#include "harness/kernel.h"

#include <algorithm>

#include "kernels/cluster_slices/inputs.h"
#include "kernels/cluster_slices/layout.h"
#include "kernels/cluster_slices/oracle.h"

namespace assay::cluster_slices {

namespace {

uint64_t words(const Case& c) { return c.params<SliceParams>().words; }
uint64_t edges(const Case& c) { return uint64_t{c.params<SliceParams>().grid.slices} + 1; }
Groups per_word(const Case& c) {
  const auto groups = static_cast<uint32_t>((words(c) + 63) / 64);
  return {std::min(groups, 32768u), ceil_div(groups, 32768)};
}

Cost cost(const Case& c) {
  return {
      .bytes_read = edges(c) * sizeof(float), .bytes_written = words(c) * sizeof(uint), .operations = words(c) * 4 * 5};
}

}  // namespace

Kernel describe() {
  return {
      .name = "cluster_slices",
      .source = "Sousa, Geffroy 2016: slices in the logarithm of depth",
      .default_variant = "search",
      .params = layout_of<SliceParams>(),
      .ports = {reads<float>("slice_edges", edges), writes<uint>("slices", words)},
      .variants = {{.name = "search", .passes = {Dispatch{"search.comp", per_word}}, .note = "a binary search"},
                   {.name = "count", .passes = {Dispatch{"count.comp", per_word}}, .note = "a comparison a slice"},
                   {.name = "logarithm",
                    .passes = {Dispatch{"logarithm.comp", per_word}},
                    .baseline = true,
                    .note = "log2 of the depth, no table"}},
      .oracle = expected_slices,
      .inputs = inputs(),
      .bounds = {exact("slices", "comparisons alone, no arithmetic on depths")},
      .mutants = {{"common.glsl", 1, "the second depth twice", "boundary_3"},
                  {"common.glsl", 2, "the last word is left as it was", "one_word"},
                  {"common.glsl", 6, "depths seven bits apart", "one_group_and_one"},
                  {"count.comp", 3, "the last slice's beginning is not asked", "boundary_23"},
                  {"count.comp", 4, "< for <=", "boundary_1"},
                  {"count.comp", 5, "the first boundary counts too", "boundary_3"},
                  {"harness/glsl/clusters.glsl", 9401, "< for <=", "boundary_12"}},
      .cost = cost,
      .typical = typical,
      .extents = {{256, 256}, {1920, 1080}, {3840, 2160}},
  };
}

}  // namespace assay::cluster_slices
