#include "kernels/debug_view/inputs.h"
#include "kernels/debug_view/layout.h"
#include "kernels/debug_view/oracle.h"

namespace assay::debug_view {
namespace {

Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }
Groups per_run(const Case& c) { return {ceil_div(c.extent.width, 16 * kRunPixels), ceil_div(c.extent.height, 16), 1}; }
uint64_t surfaces(const Case& c) { return c.params<ViewParams>().surfaces; }
uint64_t materials(const Case& c) { return c.params<ViewParams>().materials; }
uint64_t list_entries(const Case& c) { return tiles(c) * workloads(c); }
uint64_t shown_workloads(const Case& c) { return c.params<ViewParams>().view == kViewWorkload ? workloads(c) : 0; }

Cost cost(const Case& c) {
  const uint64_t read = pixels(c) * sizeof(uvec2) + surfaces(c) * sizeof(SurfaceRecord) +
                        (materials(c) + tiles(c) + kHeatColours + list_entries(c)) * sizeof(uint32_t) +
                        workloads(c) * (sizeof(WorkloadCount) + sizeof(DispatchArgs) + sizeof(uint32_t));
  return {.bytes_read = read, .bytes_written = pixels(c) * sizeof(uint32_t), .operations = pixels(c) * 3};
}

std::vector<Pass> with_workloads(Dispatch paint) {
  return {std::move(paint),
          Dispatch{.shader = "workload.comp", .indirect = "workload_args", .repeat = shown_workloads}};
}

}  // namespace

Kernel describe() {
  return {
      .name = "debug_view",
      .source = "Lazarek, Hammer 2025: debug visualisations, indirect dispatch over workload tiles",
      .default_variant = "pixel",
      .params = layout_of<ViewParams>(),
      .ports = {reads_image("visibility", Format::rg32_uint, {"visibility.visibility"}),
                reads<SurfaceRecord>("surfaces", surfaces, {"scene.surfaces"}),
                reads<uint32_t>("material_colours", materials), reads<uint32_t>("heat_colours", fixed(kHeatColours)),
                reads<uint32_t>("masks", tiles, {"tile_classification.masks"}),
                reads<uint32_t>("workload_tiles", list_entries, {"tile_classification.workload_tiles"}),
                reads<WorkloadCount>("workload_counts", workloads, {"tile_classification.workload_counts"}),
                reads<DispatchArgs>("workload_args", workloads, {"tile_classification.workload_args"}),
                reads<uint32_t>("workload_colours", workloads), writes<uint32_t>("image", pixels)},
      .variants = {{.name = "pixel",
                    .passes = with_workloads({.shader = "pixel.comp", .groups = per_pixel}),
                    .note = "a thread a pixel"},
                   {.name = "run",
                    .passes = with_workloads({.shader = "run.comp", .groups = per_run}),
                    .note = "a thread a run of pixels, looking up only what changed"}},
      .oracle = expected_image,
      .inputs = {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller},
      .bounds = {exact("image", "integers only, one owner a pixel and dispatch")},
      .mutants = {{"common.glsl", 1, "the instanced bit stays in the index", "flags"},
                  {"common.glsl", 2, "surfaces share their triangles' colours", "same_triangle_other_surface"},
                  {"paint.glsl", 3, "partial tiles are not counted in a row", "odd_extent_tile"},
                  {"paint.glsl", 4, "&& for || : borders are dots", "odd_extent_tile"},
                  {"paint.glsl", 5, "<= for < : the chip is a pixel too large", "odd_extent_tile"},
                  {"paint.glsl", 6, "the highest feature is not counted", "every_feature"},
                  {"pixel.comp", 7, "the last column is not on the screen", "odd_extent_material"},
                  {"run.comp", 8, "a run's colour is kept when only the triangle changes",
                   "same_surface_other_triangle"},
                  {"run.comp", 9, "a run's colour is kept across the tile view's lines", "every_feature"},
                  {"workload.comp", 10, "<= for < : one stale entry is painted", "stale_entries"},
                  {"workload.comp", 11, "every workload runs over the first one's list", "lists_disjoint"},
                  {"workload.comp", 12, "a group leaves its tile after the first pixels", "few_groups_a_tile"},
                  {"workload.comp", 13, "columns beyond the right edge are painted", "last_column_only"},
                  {"workload.comp", 14, "every workload in the first one's colour", "lists_disjoint"}},
      .cost = cost,
      .typical = typical,
      .extents = {{256, 256}, {1280, 720}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::debug_view
