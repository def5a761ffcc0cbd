// The frame by cells of clusters and by brute force: the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "harness/formats/cluster_lists.h"
#include "tests/drawn.h"

namespace assay::tests {
namespace {

using frame::Options;
using frame::Result;

// What lights light and decals cover they do so through their cells: the picture of all of them by brute force, bit for
// bit, as long as no list was full.
void expect_same_light(const scene::Scene& s, Extent size) {
  const std::string radiance = "deferred_lighting.radiance", status = "cluster_lists.list_status";
  Options o = {.size = size, .clusters = "none", .goals = {radiance}, .warm_up = false};
  const Result shadowed = draw(s, o);
  for (const std::string clusters : {"coarse", "fine"}) {
    o.clusters = clusters;
    EXPECT_EQ(draw(s, o).downloads.at(radiance), shadowed.downloads.at(radiance)) << clusters << ", with shadows";
  }
  o.clusters = "none", o.shadows = false;
  const Result all = draw(s, o);
  EXPECT_NE(all.downloads.at(radiance), shadowed.downloads.at(radiance)) << "no shadow is seen";
  EXPECT_FALSE(all.downloads.contains(status)) << "nobody needs lists of cells";
  for (const std::string clusters : {"coarse", "fine"})
    for (const std::string variant : {"clustered", "clustered_scalarised"}) {
      o.clusters = clusters, o.variants["deferred_lighting"] = variant;
      const Result some = draw(s, o);
      EXPECT_EQ(some.downloads.at(radiance), all.downloads.at(radiance)) << clusters << ", " << variant;
      const auto counts = words<ClusterListStatus>(some.downloads.at(status)).at(0);
      EXPECT_EQ(counts.dropped_lights, 0u);
      EXPECT_EQ(counts.dropped_decals, 0u);
      EXPECT_GT(counts.entries, 0u);
    }
  o.clusters = "fine", o.variants["deferred_lighting"] = "clustered";
  for (const std::string culler : {"hexahedra_raster", "hexahedra_hi_z", "two_pass_raster", "smaller_list"}) {
    o.variants["cluster_voxelization"] = culler;
    EXPECT_EQ(draw(s, o).downloads.at(radiance), all.downloads.at(radiance)) << culler;
  }
  o.variants["decal_atlas_sampling"] = "gradient";
  EXPECT_EQ(draw(s, o).downloads.at(radiance), all.downloads.at(radiance)) << "decals without a list of tiles";
}

TEST(FrameClusters, LightThroughClustersIsLightByBruteForce) {
  expect_same_light(scene::small(), {320, 180});
  expect_same_light(scene::default_scene(), {333, 187});
}

// By every way of finding and reading them.
TEST(FrameClusters, DecalsThroughClustersAreDecalsByBruteForce) {
  const std::string colour = "decal_atlas_sampling.base_roughness", normal = "decal_atlas_sampling.normal";
  for (const scene::Scene& s : {scene::small(), scene::default_scene()}) {
    Options o = {.size = {333, 187}, .clusters = "none", .goals = {colour, normal}, .warm_up = false};
    const Result all = draw(s, o);
    Options bare = o;
    bare.goals = {"deferred_texturing.base_roughness"};
    EXPECT_NE(draw(s, bare).downloads.at(bare.goals[0]), all.downloads.at(colour)) << "no decal is seen";
    for (const std::string clusters : {"coarse", "fine"})
      for (const std::string variant : {"gradient", "scalarised", "bitfield", "tiles"}) {
        o.clusters = clusters, o.variants = {{"decal_atlas_sampling", variant}, {"decal_tiles", "per_pixel"}};
        const Result some = draw(s, o);
        for (const std::string& port : {colour, normal})
          EXPECT_EQ(some.downloads.at(port), all.downloads.at(port)) << clusters << ", " << variant << ", " << port;
      }
  }
}

// A hall of lights that all reach everything: more than 256 in each cell.
TEST(FrameClusters, FullListsOfCellsAreTold) {
  scene::Scene s = scene::small();
  for (uint32_t i = 0; i < 300; ++i) s.lights.push_back({.kind = scene::LightKind::point, .intensity = 0.01f});
  const Result r = draw(s, {.size = {64, 36}, .warm_up = false});
  EXPECT_TRUE(std::ranges::any_of(
      r.notes, [](const std::string& note) { return note.find("found no room") != std::string::npos; }));
}

TEST(FrameClusters, UnknownClustersAreNamed) {
  EXPECT_THROW(draw(scene::bare(), {.size = {8, 8}, .clusters = "some"}), std::invalid_argument);
}

}  // namespace
}  // namespace assay::tests
