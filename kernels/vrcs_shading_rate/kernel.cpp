#include "harness/kernel.h"

#include "kernels/vrcs_shading_rate/inputs.h"
#include "kernels/vrcs_shading_rate/oracle.h"

namespace assay::vrcs_shading_rate {

namespace {

Groups per_64_cells(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }

Bytes widened(std::span<const std::byte> texels) {
  Bytes words(texels.size() * 4);
  for (size_t i = 0; i < texels.size(); ++i) words[4 * i] = texels[i];
  return words;
}

Variant variant(Estimator estimator, uint32_t side, const std::string& note) {
  const std::string name = name_of(estimator) + ("_" + std::to_string(side));
  Bound b = between({"rates"}, "integers against a threshold, which is off by 100 u at most");
  b.unpack = Unpack{layout_of<uint32_t>(), widened}, b.answer = name;
  return {.name = name, .passes = {Dispatch{name + ".comp", per_64_cells}}, .bounds = {{b}}, .note = note};
}

Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * 2,
          .bytes_written = pixel_count(cells_of(c.extent)),
          .operations = pixels(c) * 2 * 40};  // two lumas; nine neighbours and six sums
}

}  // namespace

Kernel describe() {
  Port rates = writes_image("rates", Format::r8_uint);
  rates.extent = [](const Case& c) { return cells_of(c.extent); };
  Kernel k = {
      .name = "vrcs_shading_rate",
      .source =
          "Fuller, Hammer 2025, Shading Rate Image; Yang et al. 2019, Visually Lossless Content and Motion Adaptive "
          "Shading",
      .default_variant = "second_difference_8",
      .params = layout_of<RateParams>(),
      .ports = {reads_image("luma", Format::rg8_unorm), rates},
      .variants = {variant(Estimator::second_difference, 8, "what the deblocked duplicates are off, of all phases"),
                   variant(Estimator::second_difference, 2, "the same, a rate a cell"),
                   variant(Estimator::first_difference, 8, "what copied duplicates are off, of all phases"),
                   variant(Estimator::first_difference, 2, "the same, a rate a cell"),
                   variant(Estimator::second_and_slope, 8, "the second difference, or an eighth of the first"),
                   variant(Estimator::second_and_slope, 2, "the same, a rate a cell"),
                   variant(Estimator::sobel, 8, "the source's: the largest slope"),
                   variant(Estimator::sobel, 2, "the same, a rate a cell")},
      .oracle = vrcs_shading_rate::rates,
      .inputs = inputs(),
      .bounds = {},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
  k.bounds = *k.variants.front().bounds;
  return k;
}

}  // namespace assay::vrcs_shading_rate
