#include "kernels/cluster_slices/oracle.h"

#include <cstring>

#include "harness/oracle.h"
#include "kernels/cluster_slices/layout.h"

namespace assay::cluster_slices {

namespace {

// Boundaries descend, so the last that d reaches counts them; NaN reaches none.
uint32_t slice_at(uint32_t bits, std::span<const float> edges, uint32_t slices) {
  float d;
  std::memcpy(&d, &bits, sizeof(d));
  uint32_t last = 0;
  for (uint32_t k = 1; k < slices; ++k)
    if (d <= edges[k]) last = k;
  return last;
}

}  // namespace

Answer expected_slices(const Case& c) {
  const auto p = c.params<SliceParams>();
  const auto edges = c.input<float>("slice_edges");
  std::vector<uint32_t> words(p.words);
  for (uint32_t i = 0; i < p.words; ++i)
    for (uint32_t byte = 0; byte < 4; ++byte)
      words[i] |= slice_at(p.first + 4 * i + byte, edges, p.grid.slices) << 8 * byte;
  return {{"slices", expect_all(words)}};
}

}  // namespace assay::cluster_slices
