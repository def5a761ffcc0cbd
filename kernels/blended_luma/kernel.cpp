#include "harness/kernel.h"

#include "kernels/blended_luma/inputs.h"
#include "kernels/blended_luma/layout.h"
#include "kernels/blended_luma/oracle.h"

namespace assay::blended_luma {

namespace {

Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }

Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * (8 + 2) + kHalfCodesSide * kHalfCodesSide,
          .bytes_written = pixels(c) * 2,
          .operations = pixels(c) * 8};
}

}  // namespace

Kernel describe() {
  Port half_codes = reads_image("half_codes", Format::r8_uint, {"vrcs_deblock.half_codes"});
  half_codes.extent = [](const Case&) { return Extent{kHalfCodesSide, kHalfCodesSide}; };
  Port radiance = reads_image("radiance", Format::rgba16_float, {"particles.radiance"});
  radiance.view = Format::rg32_uint;  // words: halves as they are
  return {
      .name = "blended_luma",
      .source = "Fuller, Hammer 2025, luma of opaque and of blended surfaces",
      .default_variant = "per_pixel",
      .params = layout_of<LumaParams>(),
      .ports = {radiance,
                half_codes,
                {.name = "luma",
                 .use = Use::updates,
                 .kind = PortKind::image,
                 .format = Format::rg8_unorm,
                 .producers = {"vrcs_deblock.luma"}}},
      .variants = {{.name = "per_pixel",
                    .passes = {Dispatch{"per_pixel.comp", per_pixel}},
                    .note = "a thread a pixel"}},
      .oracle = lumas,
      .inputs = inputs(),
      .bounds = {exact("luma", "codes by table, weights in whole numbers")},
      .mutants = {{"per_pixel.comp", 1, "the last column left out", "one_pixel"},
                  {"per_pixel.comp", 2, "of the transposed pixel", "odd_extent"},
                  {"per_pixel.comp", 3, "red becomes the blended luma, green the opaque one", "one_pixel"},
                  {"per_pixel.comp", 4, "red becomes the blended luma too", "one_pixel"},
                  {"per_pixel.comp", 5, "the picture's red and green swapped", "one_pixel"},
                  {"per_pixel.comp", 6, "alpha for blue", "one_pixel"},
                  {"harness/glsl/luma.glsl", 9731, "luma's red and blue swapped", "one_pixel"}},
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::blended_luma
