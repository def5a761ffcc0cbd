// Where particles' light lies in the atlas (harness/formats/particle.h), for the kernels that share it. Host only.
#pragma once
#include "harness/kernel.h"

namespace assay {

// The atlas of a frame: the smallest, of a power of two a side, in whose regions each particle finds a rectangle, of
// 8x8 if no larger one; a half of it is of 32x32, a quarter of 16x16 and one of 8x8. None without particles; 4096 a
// side hold 65,536.
ParticleAtlas particle_atlas_of(uint32_t particles);

// Rectangles of one size, 1 to kRectSizes: rows of slots, one below the other. Sides are cut down to whole slots, and
// regions to the atlas, those of large rectangles first.
struct ParticleRegion {
  uint32_t side = 0, row = 0;  // texels
  uint32_t across = 0, slots = 0;
  uint32_t first = 0;  // its first slot's number, those of small rectangles before
};
ParticleRegion particle_region(const ParticleAtlas&, uint32_t size);
uint32_t all_particle_slots(const ParticleAtlas&);
uint32_t most_particle_blocks(const ParticleAtlas&, uint32_t particles);  // of 8x8 texels, that can be lit

}  // namespace assay
