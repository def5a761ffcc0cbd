// Sizes of the pixel-command lists in the frame, for the kernel that makes them and those that consume them.
#pragma once
#include <algorithm>

#include "harness/formats/pixel_commands.h"
#include "harness/kernel.h"

namespace assay {

// Waves that the lists hold: what Lazarek and Hammer 2025 spend on pixel commands and counters, 57 MiB at 3840x2160 and
// by pixel elsewhere, less the counters; at least every pixel unpadded, with a wave of each shader's overflow unfilled.
// `entries` holds kWaveSize a wave, `commands` one a wave, `wave_materials` likewise.
inline uint64_t command_waves(Extent e, uint64_t shaders) {
  constexpr uint64_t kBytes = 57u << 20, kPixels = uint64_t{3840} * 2160;
  const uint64_t bytes = pixel_count(e) * kBytes / kPixels;
  const uint64_t counters = shaders * tile_count(e, kTileSide) * sizeof(TileCommands);
  const uint64_t padded = bytes > counters ? (bytes - counters) / (kWaveSize * sizeof(uint)) : 0;
  const uint64_t unpadded = pixel_count(e) / kWaveSize + 1 + shaders;
  return std::max(padded, unpadded);
}
// `args` and `command_rows`.
inline uint64_t command_rows(uint64_t shaders) { return shaders * kCommandRows; }

}  // namespace assay
