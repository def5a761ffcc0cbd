// Cases for the cluster voxelization.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/cluster_voxelization/oracle.h"

namespace assay::cluster_voxelization {

// As many decals as lights, a sixteenth as many probes: 256 lights in 16x8x24 cells, from 1920 pixels on 4096, at 3840
// in 120x68x24 cells, columns of 32 pixels.
Case typical(Extent);
Inputs inputs();
std::vector<Mutant> mutants();
// Listed pairs over touching ones, by item, size and grid (numerics.md 3.2).
ErrorTable error_table();

// ---- For hard.cpp and errors.cpp

struct Scene {
  uint columns = 16, rows = 8, slices = 24;
  double slope_x = 1, slope_y = 0.5625;  // of the screen's edges
  double near = 0.3, far = 300;
  bool extended = true;  // the first slice begins at the eye, the last ends 10^5 m away
  std::vector<ClusterItem> lights = {}, decals = {}, probes = {};
  // By column and row, least and greatest reversed depth; where empty, from the near plane to infinity.
  std::vector<vec2> depth_ranges = {};

  Case to_case() const;
  std::vector<float> edges() const;
};
ClusterItem box(const glm::dvec3& at, const glm::dmat3& axes);
// `axis`: from the apex to the base's centre; the base has `across` times its length on either side.
ClusterItem pyramid(const glm::dvec3& apex, const glm::dvec3& axis, double across);
glm::dmat3 rotation(Pcg32&);
// Numerics.md 3.2: item of about `radius` metres, in view where centre; aspect of a box; half angle of a spot in
// degrees.
ClusterItem random_box(Pcg32&, const Scene&, double radius, double aspect);
ClusterItem random_spot(Pcg32&, const Scene&, double radius, double half_angle_deg);
// `n` lights and decals, a sixteenth as many probes, in 16x8x24 cells or, fine, 120x68x24.
Scene many(uint n, bool fine);
std::vector<HardCase> hard_cases();
std::vector<HardCase> raster_cases();

}  // namespace assay::cluster_voxelization
