#include "kernels/material_features/inputs.h"
#include "kernels/material_features/layout.h"
#include "kernels/material_features/oracle.h"

namespace assay::material_features {
namespace {

Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }
uint64_t surfaces(const Case& c) { return c.params<FeatureParams>().surfaces; }
uint64_t materials(const Case& c) { return c.params<FeatureParams>().materials; }

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(FeatureParams{f.extent.width, f.extent.height, f.scene.surfaces, f.scene.materials});
  return c;
}

Cost cost(const Case& c) {
  return {.bytes_read =
              pixels(c) * sizeof(uvec2) + surfaces(c) * sizeof(SurfaceRecord) + materials(c) * sizeof(MaterialRecord),
          .bytes_written = pixels(c) * sizeof(uint32_t),
          .operations = pixels(c) * 3};  // mask, two range checks
}

}  // namespace

Kernel describe() {
  return {
      .name = "material_features",
      .source = "Lazarek, Hammer 2025: feature bits for tile classification, uniform data permutation",
      .default_variant = "plain",
      .params = layout_of<FeatureParams>(),
      .ports = {reads_image("visibility", Format::rg32_uint, {"visibility.visibility"}),
                reads<SurfaceRecord>("surfaces", surfaces, {"scene.surfaces"}),
                reads<MaterialRecord>("materials", materials, {"scene.materials"}), writes<uint>("features", pixels)},
      .variants = {{.name = "plain",
                    .passes = {Dispatch{"plain.comp", per_pixel}},
                    .note = "each pixel follows its own indices"},
                   {.name = "uniform",
                    .passes = {Dispatch{"uniform.comp", per_pixel}},
                    .needs = {Feature::subgroup_ballot},
                    .note = "one lookup for a wave of one surface"},
                   {.name = "scalarised",
                    .passes = {Dispatch{"scalarised.comp", per_pixel}},
                    .needs = {Feature::subgroup_ballot},
                    .note = "one lookup for each distinct surface of a wave"}},
      .oracle = expected_features,
      .inputs = {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller},
      .bounds = {exact("features", "integers only, one owner a pixel")},
      .mutants = {{"common.glsl", 1, "the last column is not on the screen", "odd_extent"},
                  {"common.glsl", 2, "the instanced bit stays in the index", "flags"},
                  {"common.glsl", 3, "the flipped bit stays in the index", "flags"},
                  {"common.glsl", 4, "the triangle taken for the surface", "one_group"},
                  {"common.glsl", 5, "< for <= : the last surface is out of range", "last_surface"},
                  {"common.glsl", 6, "a material out of range is clamped", "material_out_of_range"},
                  {"common.glsl", 7, "columns for rows in the output", "wide"},
                  {"uniform.comp", 8, "every wave taken for uniform", "one_lane_differs"},
                  {"uniform.comp", 9, "uniformity of the triangle, not the surface", "same_triangle_other_surface"},
                  {"scalarised.comp", 10, "the bits of other lanes' surfaces are kept", "one_lane_differs"},
                  {"scalarised.comp", 11, "the loop ends after the first surface", "every_pixel_another_surface"}},
      .cost = cost,
      .typical = typical,
      .extents = {{256, 256}, {1280, 720}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::material_features
