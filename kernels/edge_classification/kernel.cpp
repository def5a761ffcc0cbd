#include "harness/kernel.h"

#include "harness/groups.h"
#include "kernels/edge_classification/inputs.h"
#include "kernels/edge_classification/oracle.h"

namespace assay::edge_classification {

namespace {

Groups per_tile(const Case& c) { return spread_groups(tiles(c)); }
Groups per_2_tiles(const Case& c) { return spread_groups((tiles(c) + 1) / 2); }
Groups per_32_tiles(const Case& c) { return spread_groups((tiles(c) + 31) / 32); }
Groups per_256_tiles(const Case& c) { return {static_cast<uint32_t>((tiles(c) + 255) / 256)}; }
Groups once(const Case&) { return {1}; }

Cost cost(const Case& c) {
  return {.bytes_read = (samples(c) + gradients(c)) * sizeof(uint),
          .bytes_written = tiles(c) * (sizeof(uvec2) + 2 * sizeof(uint)) + 2 * (sizeof(uint) + sizeof(DispatchArgs)),
          .operations = samples(c) + 4 * gradients(c)};  // a comparison a material; two differences, two comparisons
}

}  // namespace

Kernel describe() {
  const std::vector<Pass> list = {Clear{"tile_counts"}, Dispatch{"append.comp", per_256_tiles},
                                  Dispatch{"args.comp", once}};
  return {
      .name = "edge_classification",
      .source = "Pettineo 2016, MSAA Edge Detection and Tile Classification",
      .default_variant = "ballot",
      .params = layout_of<EdgeParams>(),
      .ports = {reads<uint>("materials", samples), reads<uint>("gradients", gradients),
                writes<uvec2>("edge_mask", tiles), writes<uint>("tile_counts", fixed(2)),
                writes<uint>("edge_tiles", tiles), writes<uint>("plain_tiles", tiles),
                writes<DispatchArgs>("args", fixed(2))},
      .variants = {{.name = "shared_atomic",
                    .passes = {Clear{"tile_counts"}, Dispatch{"mark_shared.comp", per_tile},
                               Dispatch{"args.comp", once}},
                    .note = "a group a tile, a shared atomic an edge pixel, an append a tile"},
                   {.name = "ballot",
                    .passes = {Dispatch{"mark_ballot.comp", per_2_tiles}, list[0], list[1], list[2]},
                    .needs = {Feature::subgroup_ballot},
                    .subgroup_min = 4,
                    .note = "two tiles a group, the mask joined from ballots; lists in a pass of their own"},
                   {.name = "tile_per_subgroup",
                    .passes = {Dispatch{"mark_subgroup.comp", per_32_tiles}, list[0], list[1], list[2]},
                    .needs = {Feature::subgroup_ballot},
                    .subgroup_min = 4,
                    .note = "a subgroup walks its tile, no shared memory; lists in a pass of their own"}},
      .oracle = classify,
      .inputs = inputs(),
      .bounds = {exact("edge_mask", "integers only"), same_set("edge_tiles", "tiles append in any order"),
                 same_set("plain_tiles", "tiles append in any order"), exact("tile_counts", "integers only"),
                 exact("args", "integers only")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
  };
}

}  // namespace assay::edge_classification
