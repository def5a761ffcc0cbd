#pragma once
#include "harness/shadow_maps.h"
#include "kernels/shadow_lookup/layout.h"

namespace assay::shadow_lookup {

// What a case is made of.
struct Setup {
  shadowing::Atlas atlas;
  std::vector<LightRecord> lights = {};
  std::vector<Receiver> receivers = {};

  // A light of a kind, with the next `views` of the atlas.
  uint32_t add_light(uint32_t kind, const glm::dvec3& position, const glm::dvec3& direction, uint32_t first_view,
                     uint32_t views);
  void receive(uint32_t light, const glm::dvec3& position, const glm::dvec3& normal, double dither = 0);
};
Case to_case(const Setup&);

Case typical(Extent);  // a floor, a wall and things between them and lights of all kinds
Inputs inputs();
std::vector<HardCase> hard_cases();
std::vector<Mutant> mutants();

}  // namespace assay::shadow_lookup
