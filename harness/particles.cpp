#include "harness/particles.h"

#include <algorithm>

namespace assay {

ParticleAtlas particle_atlas_of(uint32_t particles) {
  if (particles == 0) return {};
  uint32_t side = 64;
  while (side < kMostAtlasSide && uint64_t{side} * side / 4 / (kLightBlockSide * kLightBlockSide) < particles)
    side *= 2;
  return {side, {side / 4, side / 4, side / 2}};
}

ParticleRegion particle_region(const ParticleAtlas& atlas, uint32_t size) {
  const uint32_t width = std::min(atlas.side, kMostAtlasSide) / 32 * 32;
  uint32_t row = 0;
  ParticleRegion r;
  for (uint32_t k = kRectSizes; k > 0; --k) {
    const uint32_t side = 4u << k, high = std::min(atlas.rows[k - 1], width - row) / side, slots = width / side * high;
    if (k == size) r = {side, row, width / side, slots, 0};
    if (k < size) r.first += slots;
    row += high * side;
  }
  return r;
}

uint32_t all_particle_slots(const ParticleAtlas& atlas) {
  const ParticleRegion last = particle_region(atlas, kRectSizes);
  return last.first + last.slots;
}

uint32_t most_particle_blocks(const ParticleAtlas& atlas, uint32_t particles) {
  uint32_t blocks = 0;
  for (uint32_t k = 1; k <= kRectSizes; ++k)
    blocks += std::min(particle_region(atlas, k).slots, particles) << 2 * (k - 1);
  return blocks;
}

}  // namespace assay
