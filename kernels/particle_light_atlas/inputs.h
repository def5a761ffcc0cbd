// Cases for the particles' lighting.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "harness/particles.h"
#include "harness/shadow_maps.h"
#include "kernels/particle_light_atlas/layout.h"

namespace assay::particle_light_atlas {

// Particles with their rectangles, and what lights them, seen by a view of 90 degrees along -z, 256 pixels a side.
struct Scene {
  explicit Scene(uint32_t side);

  // Of rectangles of a size from 1 to 3: the upper half of the atlas is of 32x32, then a quarter each.
  ParticleRegion region(uint32_t size) const;
  // In the size's next free place; whether there was one, else the particle has none.
  bool add(const ParticleRecord&, uint32_t size);
  // Cells of so many pixels with slices at these depths, and in each `lights_in(cell)`.
  void add_cells(uint32_t pixels, const std::vector<float>& depths,
                 const std::function<std::vector<uint32_t>(uint32_t)>& lights_in);
  // Views of the first eight lights.
  void add_shadows(Pcg32&, const glm::dvec3& seen);

  ParticleLightParams params = {};
  std::vector<ParticleRecord> particles = {};
  std::vector<uint32_t> rects = {}, blocks = {};
  uint32_t placed[4] = {};
  std::vector<LightRecord> lights = {};
  std::vector<uvec2> cells = {};
  std::vector<uint32_t> entries = {};
  std::vector<float> slice_edges = {};
  shadowing::Atlas shadows = shadowing::Atlas({1, 1});
};
// Without a grid there will be one whose cells list all lights, or of many about eight each.
Case to_case(Scene);

// An atlas as wide as the extent, full of puffs of every size, among 60 lights.
Case typical(Extent);
Inputs inputs();
Case in_frame(const FrameInputs&);
std::vector<HardCase> hard_cases();

}  // namespace assay::particle_light_atlas
