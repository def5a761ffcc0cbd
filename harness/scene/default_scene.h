// Inside of the built-in scene `default`: textures, then materials, then the hall, its lights, decals and particles.
#pragma once
#include <array>
#include <vector>

#include "harness/scene/builtin.h"

namespace assay::scene::builtin {

// Images of one look. surface: occlusion in R, roughness in G, metallic in B, height in A.
struct Finish {
  uint32_t base = kNone, normal = kNone, surface = kNone;
};

struct Looks {
  Finish stone, brick, marble, plaster, wood, metal, moss, sand, fabric, skin, rune;
  uint32_t leaves, fern, blades, bars, lattice, rings;  // base colours with holes
  uint32_t glow;                                        // emission of `rune`
  uint32_t layer_mask, wet_mask, thickness;             // R
  uint32_t weave, scan;                                 // details
};
Looks paint_looks(Scene&);

// Materials by shader class, and round again past the last.
struct Palette {
  std::array<std::vector<uint32_t>, kShaderClasses> of_class = {};
  uint32_t operator()(uint32_t shader, uint32_t i) const { return of_class[shader][i % of_class[shader].size()]; }
};
Palette add_default_materials(Scene&, const Looks&);

// The hall runs along z from +28 to -28 in eight bays of 7 m, 20 m wide, with two rows of columns between nave and
// aisles. `middle` of a bay counts from the front.
constexpr uint32_t kBays = 8;
constexpr double kBayLength_m = 7, kHallWidth_m = 20, kWallHeight_m = 9, kColumnX_m = 4.5;
inline double middle(uint32_t bay) { return 24.5 - kBayLength_m * bay; }

void add_building(Scene&, const Palette&);   // floors, walls, vault, columns
void add_furniture(Scene&, const Palette&);  // banners, fences, obelisks, growths, plants
void add_default_lights(Scene&);             // 300
void add_default_decals(Scene&);             // 1000, a fifth of them on what stands in the hall
void add_default_particles(Scene&);          // 2000

}  // namespace assay::scene::builtin
