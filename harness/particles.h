// Where particles' light lies in the atlas (harness/formats/particle.h), for the kernels that share it. Host only.
#pragma once
#include "harness/kernel.h"

namespace assay {

// The atlas of a frame: the smallest, of a power of two a side, in whose regions each particle finds a rectangle, of
// 8x8 if no larger one; a half of it is of 32x32, a quarter of 16x16 and one of 8x8. None without particles; 4096 a
// side hold 65,536.
inline ParticleAtlas particle_atlas_of(uint32_t particles) {
  if (particles == 0) return {};
  uint32_t side = 64;
  while (side < kMostAtlasSide && uint64_t{side} * side / 4 / (kLightBlockSide * kLightBlockSide) < particles)
    side *= 2;
  return {side, {side / 4, side / 4, side / 2}};
}

}  // namespace assay
