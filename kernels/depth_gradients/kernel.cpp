#include "harness/kernel.h"

#include "kernels/depth_gradients/inputs.h"
#include "kernels/depth_gradients/oracle.h"

namespace assay::depth_gradients {

namespace {

Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }
Count counted(uint GradientParams::*member) {
  return [member](const Case& c) { return uint64_t{c.params<GradientParams>().*member}; };
}
Port only_in(const std::string& variant, Port p) {
  p.only_in = {variant};
  return p;
}

// The visibility buffer and each vertex, index and record once; a texel of the output a pixel.
Cost cost(const Case& c) {
  const auto p = c.params<GradientParams>();
  return {.bytes_read = pixels(c) * 8 + uint64_t{p.vertices} * sizeof(vec3) + uint64_t{p.indices} * sizeof(uint) +
                        uint64_t{p.surfaces} * sizeof(SurfaceRecord),
          .bytes_written = pixels(c) * 4,
          .operations = pixels(c) * 110};
}

}  // namespace

Kernel describe() {
  Bound held_to = between({"gradients"}, "exact plane, running error of the formula, nearest half (README, Bounds)");
  held_to.unpack = unpack_gradient();
  Port gradients = writes_image("gradients", Format::rg16_float);
  gradients.view = Format::r32_uint;
  return {
      .name = "depth_gradients",
      .source = "Pettineo 2016, Decals; Lazarek, Hammer 2025, Deferred Attribute Interpolation",
      .default_variant = "analytic",
      .params = layout_of<GradientParams>(),
      .ports = {only_in("analytic", reads_image("visibility", Format::rg32_uint, {"visibility.visibility"})),
                only_in("analytic", reads<vec3>("positions", counted(&GradientParams::vertices), {"scene.positions"})),
                only_in("analytic", reads<uint>("indices", counted(&GradientParams::indices), {"scene.indices"})),
                only_in("analytic",
                        reads<SurfaceRecord>("surfaces", counted(&GradientParams::surfaces), {"scene.surfaces"})),
                only_in("differences", reads_image("depth", Format::d32_float, {"visibility.depth"})), gradients},
      .variants = {{.name = "analytic",
                    .passes = {Dispatch{"analytic.comp", per_pixel}},
                    .constants = {{"SPLIT_PRODUCTS", {0, 1}}},
                    .note = "from the plane of the triangle that is seen"},
                   {.name = "differences",
                    .passes = {Dispatch{"differences.comp", per_pixel}},
                    .baseline = true,
                    .note = "the lesser difference to the neighbours' depths"}},
      .oracle = gradients_of,
      .inputs = inputs(),
      .bounds = {held_to},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .errors = error_table(),
  };
}

}  // namespace assay::depth_gradients
