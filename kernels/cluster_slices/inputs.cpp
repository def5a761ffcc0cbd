#include "kernels/cluster_slices/inputs.h"

#include <bit>
#include <cmath>

#include "harness/clusters.h"
#include "kernels/cluster_slices/layout.h"

namespace assay::cluster_slices {

namespace {

struct Slices {
  double near = 0.3, far = 300;
  uint32_t count = 24;
  float near_plane = 0.1f;
  bool extended = true;
};

Case of_depths(const Slices& s, uint32_t first, uint32_t words) {
  std::vector<float> edges = slice_edges(s.near, s.far, s.count);
  if (s.extended) edges.front() = 0, edges.back() = 1e9f;
  Case c = {.extent = {words * 4, 1}};
  c.set_params(SliceParams{
      first, words, {.slices = s.count}, s.near_plane, static_cast<float>(s.near), static_cast<float>(s.far)});
  c.set_input("slice_edges", reversed_slice_edges(edges, s.near_plane));
  return c;
}

// 64 depths round the k-th boundary.
Case round_boundary(const Slices& s, uint32_t k) {
  const Case c = of_depths(s, 0, 0);
  return of_depths(s, std::bit_cast<uint32_t>(c.input<float>("slice_edges")[k]) - 32, 16);
}

Case random_case(Random& r) {
  Slices s;
  s.count = r.branch({{"slices_24", 0.6}, {"slices_any", 0.4}}) ? 1 + r.rng.below(kMaxClusterSlices) : 24;
  s.near = std::pow(10, r.rng.range(-2, 0.5)), s.far = s.near * std::pow(10, r.rng.range(0.3, 7));
  s.near_plane = static_cast<float>(std::pow(10, r.rng.range(-3, 0)));
  s.extended = r.branch({{"extended", 0.7}, {"as_they_are", 0.3}}) == 0;
  const uint32_t words = 1 + r.rng.below(r.branch({{"few", 0.5}, {"many", 0.5}}) ? 60000 : 300);
  switch (r.branch({{"round_a_boundary", 0.6}, {"anywhere", 0.4}})) {
    case 0: {
      const uint32_t k = r.rng.below(s.count + 1);
      const Case c = of_depths(s, 0, 0);
      return of_depths(s, std::bit_cast<uint32_t>(c.input<float>("slice_edges")[k]) - r.rng.below(4 * words), words);
    }
    default:
      return of_depths(s, r.rng.next(), words);
  }
}

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> cases = {
      {"none", "no depth", [] { return of_depths({}, 0x3f800000, 0); }},
      {"one_word", "one lane of one group is alive", [] { return of_depths({}, 0x3f7ffffe, 1); }},
      {"one_group_and_one", "a second group for one word", [] { return of_depths({}, 0x3c000000, 65); }},
      {"one_slice", "a table of one slice: nothing to ask", [] { return of_depths({.count = 1}, 0x3f000000, 100); }},
      {"most_slices", "32 slices over far / near of 10^7",
       [] { return of_depths({.near = 0.01, .far = 1e5, .count = 32}, 0x33000000, 1u << 16); }},
      {"zero_and_denormals", "depths 0, denormal and negative: infinitely far, or beyond",
       [] { return of_depths({}, 0u - 64u, 64); }},
      {"infinite_and_no_numbers", "infinity is nearer than anything; NaN is in the first slice",
       [] { return of_depths({}, 0x7f800000u - 64u, 64); }},
      {"negative_infinity", "negative depths down to NaN", [] { return of_depths({}, 0xff800000u - 64u, 64); }},
  };
  for (uint32_t k = 0; k <= 24; ++k)
    cases.push_back({"boundary_" + std::to_string(k), "the 32 floats before it, and as many from it on",
                     [k] { return round_boundary({.extended = false}, k); }});
  for (uint32_t part = 0; part < 64; ++part)
    cases.push_back({"all_floats_" + std::to_string(part), "a 64th of all 2^32",
                     [part] { return of_depths({}, part << 26, 1u << 24); }, true});
  return cases;
}

}  // namespace

Case typical(Extent e) {
  Case c = of_depths({}, 0x3dcccccd, static_cast<uint32_t>((pixel_count(e) + 3) / 4));
  c.name = "typical", c.extent = e;
  return c;
}

Inputs inputs() {
  return {
      .random = random_case,
      .branches = {"slices_24", "slices_any", "extended", "as_they_are", "few", "many", "round_a_boundary", "anywhere"},
      .hard = hard_cases()};
}

}  // namespace assay::cluster_slices
