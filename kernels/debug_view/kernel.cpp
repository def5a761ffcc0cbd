#include "harness/commands.h"
#include "kernels/debug_view/inputs.h"
#include "kernels/debug_view/layout.h"
#include "kernels/debug_view/oracle.h"

namespace assay::debug_view {
namespace {

Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }
Groups none() { return {0, 0, 0}; }
uint32_t view_of(const Case& c) { return c.params<ViewParams>().view; }
// The views that need more than the visibility have a pass of their own, and its inputs are bound for that view alone.
bool has_own_pass(const Case& c) {
  const uint32_t view = view_of(c);
  return view == kViewTile || view == kViewShader || view == kViewClusters || view == kViewRate ||
         view == kViewPrimary || view == kViewShadows;
}
Dispatch for_view(const char* shader, uint32_t view) {
  return {.shader = shader, .groups = [view](const Case& c) { return view_of(c) == view ? per_pixel(c) : none(); }};
}
Groups per_run(const Case& c) { return {ceil_div(c.extent.width, 16 * kRunPixels), ceil_div(c.extent.height, 16), 1}; }
uint64_t surfaces(const Case& c) { return c.params<ViewParams>().surfaces; }
uint64_t materials(const Case& c) { return c.params<ViewParams>().materials; }
uint64_t list_entries(const Case& c) { return tiles(c) * workloads(c); }
uint64_t shown_workloads(const Case& c) { return view_of(c) == kViewWorkload ? workloads(c) : 0; }
uint64_t shaders(const Case& c) { return c.params<ViewParams>().shaders; }
uint64_t shown_cells(const Case& c) {
  const ClusterGrid g = c.params<ViewParams>().grid;
  return view_of(c) == kViewClusters ? uint64_t{g.columns} * g.rows * g.slices : 0;
}
uint64_t slice_edges(const Case& c) { return uint64_t{c.params<ViewParams>().grid.slices} + 1; }
uint64_t shown_slots(const Case& c) { return view_of(c) == kViewShader ? surfaces(c) : 0; }
uint64_t shown_rows(const Case& c) { return view_of(c) == kViewWave ? command_rows(shaders(c)) : 0; }
Extent shown_rates(const Case& c) { return view_of(c) == kViewRate ? tiles_of(c.extent, kCellSide) : Extent{1, 1}; }
Extent shown_copies(const Case& c) { return view_of(c) == kViewPrimary ? c.extent : Extent{1, 1}; }
uint64_t shown_tiles(const Case& c) { return view_of(c) == kViewPrimary ? tile_count(c.extent, kVrcsTileSide) : 0; }
Extent shown_atlas(const Case& c) {
  const auto p = c.params<ViewParams>();
  return p.view == kViewShadows && p.shadow_width && p.shadow_height ? Extent{p.shadow_width, p.shadow_height}
                                                                     : Extent{1, 1};
}
uint64_t shown_shadows(const Case& c) { return view_of(c) == kViewShadows ? c.params<ViewParams>().shadow_views : 0; }
Port sized(Port port, Extent (*extent)(const Case&)) {
  port.extent = extent;
  return port;
}
uint64_t waves(const Case& c) { return view_of(c) == kViewWave ? command_waves(c.extent, shaders(c)) : 0; }
uint64_t entries(const Case& c) { return waves(c) * kWaveSize; }

// What the view's own pass reads beside the visibility.
uint64_t bytes_of_view(const Case& c) {
  const uint64_t scene = surfaces(c) * sizeof(SurfaceRecord) + materials(c) * sizeof(uint32_t);
  switch (view_of(c)) {
    case kViewTile:
      return scene + (tiles(c) + kHeatColours) * sizeof(uint32_t);
    case kViewShader:
      return shown_slots(c) * sizeof(SurfaceSlot) + shaders(c) * sizeof(uint32_t);
    case kViewClusters:
      return scene + pixels(c) * sizeof(float) + shown_cells(c) * sizeof(uvec2) +
             (slice_edges(c) + kHeatColours) * sizeof(uint32_t);
    case kViewRate:
      return scene + pixel_count(shown_rates(c)) + kVrcsColours * sizeof(uint32_t);
    case kViewPrimary:
      return scene + pixels(c) + (shown_tiles(c) + kVrcsColours) * sizeof(uint32_t);
    case kViewShadows:
      return pixel_count(shown_atlas(c)) * sizeof(float) + shown_shadows(c) * sizeof(ShadowView);
    case kViewWorkload:
      return scene + list_entries(c) * sizeof(uint32_t) +
             workloads(c) * (sizeof(WorkloadCount) + sizeof(DispatchArgs) + sizeof(uint32_t));
    case kViewWave:
      return scene + (entries(c) + waves(c)) * sizeof(uint32_t) +
             shown_rows(c) * (sizeof(CommandRow) + sizeof(DispatchArgs));
    default:
      return scene;
  }
}

Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * sizeof(uvec2) + bytes_of_view(c),
          .bytes_written = pixels(c) * sizeof(uint32_t),
          .operations = pixels(c) * 3};
}

// Of a variant's own shader for the views without a pass of their own: unless the view has one, `groups`.
std::vector<Pass> passes(const char* shader, Groups (*groups)(const Case&)) {
  return {
      Dispatch{.shader = shader, .groups = [groups](const Case& c) { return has_own_pass(c) ? none() : groups(c); }},
      for_view("tile.comp", kViewTile),
      for_view("shader.comp", kViewShader),
      for_view("clusters.comp", kViewClusters),
      for_view("rate.comp", kViewRate),
      for_view("primary.comp", kViewPrimary),
      for_view("shadows.comp", kViewShadows),
      Dispatch{.shader = "workload.comp", .indirect = "workload_args", .repeat = shown_workloads},
      Dispatch{.shader = "wave.comp", .indirect = "command_args", .repeat = shown_rows}};
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
                reads<uint32_t>("material_colours", materials),
                reads<uint32_t>("heat_colours", fixed(kHeatColours)),
                reads<uint32_t>("masks", tiles, {"tile_classification.masks"}),
                reads<uint32_t>("workload_tiles", list_entries, {"tile_classification.workload_tiles"}),
                reads<WorkloadCount>("workload_counts", workloads, {"tile_classification.workload_counts"}),
                reads<DispatchArgs>("workload_args", workloads, {"tile_classification.workload_args"}),
                reads<uint32_t>("workload_colours", workloads),
                reads<SurfaceSlot>("surface_slots", shown_slots, {"scene.surface_slots"}),
                reads<uint32_t>("shader_colours", shaders),
                reads<uint32_t>("entries", entries, {"pixel_commands.entries"}),
                reads<uint32_t>("commands", waves, {"pixel_commands.commands"}),
                reads<CommandRow>("command_rows", shown_rows, {"pixel_commands.command_rows"}),
                reads<DispatchArgs>("command_args", shown_rows, {"pixel_commands.args"}),
                reads_image("depth", Format::d32_float, {"visibility.depth"}),
                reads<uvec2>("cells", shown_cells, {"cluster_lists.cells"}),
                reads<float>("slice_edges", slice_edges, {"scene.slice_edges"}),
                sized(reads_image("rates", Format::r8_uint, {"vrcs_shading_rate.rates"}), shown_rates),
                sized(reads_image("copy_bits", Format::r8_uint, {"vrcs_coordinates.copy_bits"}), shown_copies),
                reads<uint32_t>("vrcs_tiles", shown_tiles, {"vrcs_coordinates.tiles"}),
                reads<uint32_t>("vrcs_colours", fixed(kVrcsColours)),
                sized(reads_image("shadow_depth", Format::d32_float, {"shadow_atlas.depth"}), shown_atlas),
                reads<ShadowView>("shadow_views", shown_shadows, {"scene.shadow_views"}),
                writes<uint32_t>("image", pixels)},
      .variants = {{.name = "pixel", .passes = passes("pixel.comp", per_pixel), .note = "a thread a pixel"},
                   {.name = "run",
                    .passes = passes("run.comp", per_run),
                    .note = "a thread a run of pixels, looking up only what changed"}},
      .oracle = expected_image,
      .inputs = {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller},
      .bounds = {exact("image", "integers only, one owner a pixel and dispatch")},
      .mutants = {{"common.glsl", 1, "the instanced bit stays in the index", "flags"},
                  {"common.glsl", 2, "surfaces share their triangles' colours", "same_triangle_other_surface"},
                  {"tile.comp", 3, "partial tiles are not counted in a row", "odd_extent_tile"},
                  {"tile.comp", 4, "&& for || : borders are dots", "odd_extent_tile"},
                  {"tile.comp", 5, "<= for < : the chip is a pixel too large", "odd_extent_tile"},
                  {"tile.comp", 6, "the highest feature is not counted", "every_feature"},
                  {"pixel.comp", 7, "the last column is not on the screen", "odd_extent_material"},
                  {"run.comp", 8, "a run's colour is kept when only the triangle changes",
                   "same_surface_other_triangle"},
                  {"run.comp", 9, "a run's colour is kept when only the surface changes",
                   "same_triangle_other_surface"},
                  {"workload.comp", 10, "<= for < : one stale entry is painted", "stale_entries"},
                  {"workload.comp", 11, "every workload runs over the first one's list", "lists_disjoint"},
                  {"workload.comp", 12, "a group leaves its tile after the first pixels", "few_groups_a_tile"},
                  {"workload.comp", 13, "columns beyond the right edge are painted", "last_column_only"},
                  {"workload.comp", 14, "every workload in the first one's colour", "lists_disjoint"},
                  {"shader.comp", 15, "the material's slot taken for the shader's", "slots"},
                  {"shader.comp", 16, "> for >= : one slot too many", "slots"},
                  {"wave.comp", 17, "columns beyond the right edge are painted", "waves_off_screen"},
                  {"wave.comp", 18, "the rows' waves share their colours", "waves"},
                  {"wave.comp", 19, "a colour a workgroup", "waves"},
                  {"clusters.comp", 20, "one item is none", "cells"},
                  {"clusters.comp", 21, "lights alone are counted", "cells"},
                  {"rate.comp", 22, "pairs across and down swapped", "rates"},
                  {"rate.comp", 23, "a rate a pixel", "rates"},
                  {"primary.comp", 24, "partial tiles are not counted in a row", "primaries"},
                  {"primary.comp", 25, "224 primaries are all of a tile", "primaries"},
                  {"primary.comp", 26, "whoever is copied by nobody is a duplicate", "primaries"},
                  {"shadows.comp", 27, "doublings of depth alone", "shadows"},
                  {"shadows.comp", 28, "the atlas over the whole picture", "shadows"},
                  {"shadows.comp", 29, "a tile ends a texel late", "shadows"},
                  {"shadows.comp", 30, "tiles share their colours", "shadows"}},
      .cost = cost,
      .typical = typical,
      .extents = {{256, 256}, {1280, 720}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::debug_view
