#include "harness/kernel.h"

#include "harness/groups.h"
#include "kernels/shadow_lookup/inputs.h"
#include "kernels/shadow_lookup/oracle.h"

namespace assay::shadow_lookup {

namespace {

Groups per_receiver(const Case& c) { return spread_groups((pixels(c) + 63) / 64); }
uint64_t lights(const Case& c) { return c.params<LookupParams>().lights; }
uint64_t views(const Case& c) { return c.params<LookupParams>().views; }
Extent atlas(const Case& c) { return {c.params<LookupParams>().atlas_width, c.params<LookupParams>().atlas_height}; }

// Each receiver once, and as if each texel, view and light were read once. A tap's 12 operations, and a lookup's 110.
std::function<Cost(const Case&)> cost_of(uint32_t taps) {
  return [taps](const Case& c) {
    return Cost{.bytes_read = pixels(c) * sizeof(Receiver) + lights(c) * sizeof(LightRecord) +
                              views(c) * sizeof(ShadowView) + pixel_count(atlas(c)) * sizeof(float),
                .bytes_written = pixels(c) * sizeof(float),
                .operations = pixels(c) * (110 + 12 * taps * taps)};
  };
}

Variant filter(uint32_t taps, const std::string& note) {
  const std::string name = "pcf_" + std::to_string(taps) + "x" + std::to_string(taps);
  Bound bound = between({"shares"}, "comparisons and weights within fp32's running error (README, Bounds)");
  bound.answer = name;
  return {.name = name,
          .passes = {Dispatch{name + ".comp", per_receiver}},
          .bounds = std::vector<Bound>{bound},
          .cost = cost_of(taps),
          .note = note};
}

}  // namespace

Kernel describe() {
  Port shadow_depth = reads_image("shadow_depth", Format::d32_float);
  shadow_depth.extent = atlas;
  return {
      .name = "shadow_lookup",
      .source = "Sousa, Geffroy 2016, Lighting: shadows; Reeves, Salesin, Cook 1987; Pettineo 2016",
      .default_variant = "pcf_3x3",
      .params = layout_of<LookupParams>(),
      .ports = {reads<Receiver>("receivers", pixels), reads<LightRecord>("lights", lights),
                reads<ShadowView>("shadow_views", views), shadow_depth, writes<float>("shares", pixels)},
      .variants = {filter(2, "four taps, weighted as a bilinear filter"), filter(3, "a box of two texels"),
                   filter(7, "a box of six texels")},
      .oracle = expected_shares,
      .inputs = inputs(),
      .mutants = mutants(),
      .cost = cost_of(3),
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
  };
}

}  // namespace assay::shadow_lookup
