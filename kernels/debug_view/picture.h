// A case as its author thinks of it.
#pragma once
#include "harness/oracle.h"
#include "kernels/debug_view/layout.h"

namespace assay::debug_view {

struct List {  // of a workload
  std::vector<uint32_t> tiles = {};
  uint32_t counted = 0;
  DispatchArgs args = {};
  uint32_t colour = 0;
};

struct WaveLists {  // as pixel commands leave them
  std::vector<uint32_t> entries = {}, commands = {};
  std::vector<CommandRow> rows = {};
  std::vector<DispatchArgs> args = {};
};

struct Picture {
  Extent extent = {};
  uint32_t view = kViewMaterial;
  std::vector<uvec2> visibility = {};
  std::vector<uint32_t> surface_materials = {};
  std::vector<uint32_t> material_colours = {};
  std::vector<uint32_t> masks = {};
  std::vector<List> lists = {};
  std::vector<SurfaceSlot> slots = {};  // of the surfaces; of the shader view alone
  std::vector<uint32_t> shader_colours = {};
  WaveLists waves = {};  // of the wave view alone
  // Of the clusters view alone.
  ClusterGrid grid = {};
  std::vector<float> depth = {}, slice_edges = {};
  std::vector<uvec2> cells = {};
  // Of the rate and the primary view.
  std::vector<uint8_t> rates = {}, copy_bits = {};
  std::vector<uint32_t> vrcs_tiles = {};
  // Of the shadows view alone.
  Extent atlas = {};
  std::vector<float> shadow_depth = {};
  std::vector<ShadowTile> shadow_tiles = {};

  uvec2& at(uint32_t x, uint32_t y) { return visibility[size_t{y} * extent.width + x]; }
  uint32_t tile_total() const { return static_cast<uint32_t>(tile_count(extent, kTileSide)); }
};

// Nothing visible, masks zero, n surfaces over m materials in turn.
Picture empty_picture(Extent, uint32_t view, uint32_t surfaces, uint32_t materials);
// Every pixel another (surface, triangle) than its neighbours.
Picture busy_picture(Extent, uint32_t view);
// The list as classification would write it.
List list_of(std::vector<uint32_t> tiles, uint32_t colour, uint32_t groups_per_tile = 32);
// The pixels, each once, dealt out to rows of `shaders` slots: waves of all buckets, filled in part, and an overflow.
WaveLists wave_lists(Extent, uint32_t shaders, std::span<const uvec2> pixels, Pcg32&);
// Depths over all of 5 slices, and cells of 12 x 20 pixels of up to `most` items of each kind.
void add_cells(Picture&, Pcg32&, uint32_t most);
// Rates, the unknown among them, copy bits of all kinds, and tiles of every flag and count.
void add_vrcs(Picture&, Pcg32&);
// Depths of all kinds in an atlas of so many texels, and tiles of 1 to 32 texels in it that do not overlap.
void add_shadows(Picture&, Pcg32&, Extent atlas);
Case to_case(const Picture&);

}  // namespace assay::debug_view
