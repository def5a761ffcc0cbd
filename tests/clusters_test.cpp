// The cells of a view: their slices, and that the bounds of a light hold all that it lights.
#include "harness/clusters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/oracle.h"
#include "harness/scene/scene.h"

namespace assay::tests {
namespace {

// Reversed depths round each boundary fall where the depths themselves do, decided by exact products.
TEST(Clusters, SlicesInReversedDepthAreTheDepthsSlices) {
  const struct {
    double near, far;
    uint32_t slices;
    float near_plane;
  } grids[] = {{0.3, 300, 24, 0.1f}, {0.1, 1000, 24, 0.05f}, {1, 4096, 24, 1}, {0.05, 10000, 32, 0.013f}};
  for (const auto& g : grids) {
    const auto z = slice_edges(g.near, g.far, g.slices), d = reversed_slice_edges(z, g.near_plane);
    for (uint32_t k = 0; k <= g.slices; ++k) {
      EXPECT_GE(double{z[k]}, g.near * std::pow(g.far / g.near, double{1} * k / g.slices) * (1 - 1e-15));
      float at = d[k];
      for (int i = 0; i < 300; ++i) at = std::nextafter(at, HUGE_VALF);
      for (int i = 0; i < 600; ++i, at = std::nextafter(at, 0.0f)) {
        const bool beyond = double{at} * double{z[k]} <= double{g.near_plane};  // near_plane / at >= z
        ASSERT_EQ(at <= d[k], beyond) << "edge " << k << ", float " << i;
      }
    }
  }
}

TEST(Clusters, AnEdgeAtTheEyeIsTheLargestFloat) {
  EXPECT_EQ(reversed_slice_edges({0, 1}, 0.1f), (std::vector<float>{std::numeric_limits<float>::max(), 0.1f}));
}

TEST(Clusters, GridsStayWithinTheFormats) {
  for (const Extent e : {Extent{1, 1}, {1, 16384}, {1280, 720}, {3840, 2160}, {7680, 4320}, {16384, 16384}})
    for (const Extent cell : {coarse_cell(e), fine_cell(e)}) {
      const ClusterGrid g = grid_over(e, cell, 24);
      EXPECT_LE(g.columns, kMaxClusterColumns);
      EXPECT_LE(g.rows, kMaxClusterRows);
      EXPECT_GE(g.columns * g.cell_width, e.width);
      EXPECT_GE(g.rows * g.cell_height, e.height);
    }
  const ClusterGrid coarse = grid_over({1920, 1080}, coarse_cell({1920, 1080}), 24);
  EXPECT_EQ(glm::uvec2(coarse.columns, coarse.rows), glm::uvec2(16, 8));
  const ClusterGrid fine = grid_over({3840, 2160}, fine_cell({3840, 2160}), 24);
  EXPECT_EQ(glm::uvec2(fine.columns, fine.rows), glm::uvec2(120, 68));
}

// In the item's own coordinates: the point is inside, edges included.
bool holds(const ClusterItem& item, const glm::dvec3& at) {
  const glm::dmat3 axes = {glm::dvec3(item.a), glm::dvec3(item.b), glm::dvec3(item.c)};
  const glm::dvec3 q = glm::inverse(axes) * (at - glm::dvec3(item.origin));
  if (item.shape == kShapeBox) return std::fabs(q.x) <= 1 && std::fabs(q.y) <= 1 && std::fabs(q.z) <= 1;
  return q.z >= 0 && q.z <= 1 && std::fabs(q.x) <= q.z && std::fabs(q.y) <= q.z;
}

// Points at the very end of a light's range and cone, and moved by what a float position may be off.
TEST(Clusters, TheBoundsOfALightHoldAllThatItLights) {
  Pcg32 rng(20260127);
  const auto direction = [&] {
    const double z = rng.range(-1, 1), a = rng.range(0, 6.2831853), r = std::sqrt(1 - z * z);
    return glm::dvec3(r * std::cos(a), r * std::sin(a), z);
  };
  uint32_t pyramids = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const double far = std::pow(10, rng.range(-1, 4));
    scene::Light light = {.kind = trial % 4 ? scene::LightKind::spot : scene::LightKind::point,
                          .position = glm::dvec3(0, 0, -far) + direction() * far * 0.5,
                          .direction = glm::vec3(direction()),
                          .range = static_cast<float>(std::pow(10, rng.range(-1, 2)))};
    light.outer_rad = static_cast<float>(trial % 3 ? rng.range(0.001, 0.3) : rng.range(0.01, 1.57));
    light.inner_rad = static_cast<float>(light.outer_rad * rng.unit());
    scene::Scene s = scene::bare();
    s.lights = {light};
    const scene::Camera camera;  // at the origin, along -z: view space is (x, -y, -z)
    scene::Gathered g = gather(s, camera, {640, 360});
    append_clusters(camera, {640, 360}, {40, 45}, 24, g);
    if (g.lights.empty()) continue;
    const ClusterItem& item = g.cluster_items.at(0);
    pyramids += item.shape == kShapePyramid;
    const LightRecord& r = g.lights[0];
    const double cosine = r.kind == kLightSpot ? -double{r.cone_offset} / double{r.cone_scale} : -1;
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 axis(r.direction), aside = normalize(cross(axis, direction()));
      const double c = i % 2 ? cosine : rng.range(cosine, 1), distance = double{r.range} * (i % 3 ? 1 : rng.unit());
      const glm::dvec3 lit =
          glm::dvec3(r.position) + (axis * c + aside * std::sqrt(std::max(0.0, 1 - c * c))) * distance;
      const glm::dvec3 seen = lit + direction() * (20 * 0x1p-24 * length(lit));
      EXPECT_TRUE(holds(item, {seen.x, -seen.y, -seen.z})) << "light " << trial << ", point " << i;
    }
  }
  EXPECT_GT(pyramids, 100u);
}

}  // namespace
}  // namespace assay::tests
