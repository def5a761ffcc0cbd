// Parameters of the pixel commands; the structs that other kernels read are in harness/formats/pixel_commands.h.
#ifndef PIXEL_COMMANDS_LAYOUT_H
#define PIXEL_COMMANDS_LAYOUT_H
#include "harness/formats/pixel_commands.h"
#include "harness/formats/scene.h"
#include "harness/formats/visibility.h"
#include "harness/formats/workloads.h"
#include "harness/shared.h"
SHARED_BEGIN(pixel_commands)

SHARED_CONST uint kMaxShaders = 64u;      // slots; a surface of a later one is unlisted
SHARED_CONST uint kMaxMaterials = 4096u;  // likewise
SHARED_CONST uint kTilePixels = kTileSide * kTileSide;
SHARED_CONST uint kSmallestWaveLog2 = 3u;
SHARED_CONST uint kLargestWaveLog2 = 7u;
SHARED_CONST uint kTileWords = kTilePixels / 32u + 3u;  // of tile_groups (tile_list.glsl)

struct CommandParams {
  uint width;  // pixels
  uint height;
  uint surfaces;              // entries of surface_slots; a surface index at or above it is unlisted
  uint shaders;               // visible; above kMaxShaders counts as that
  uint materials;             // visible; above kMaxMaterials counts as that
  uint wave_log2;             // of the entries a wave, held to 3..7; kWaveSize in the frame
  uint waves_per_group_log2;  // of the consumer's workgroup, at most kCommandBuckets - 1; kWavesPerGroup in the frame
  uint waves;                 // capacity of the lists
  uint reserved;              // entries of the capacity that count as taken and are not addressed: another view's
  uint copies;                // not 0: pixels have copy bits; 0: that image is not looked at, and has one texel
};

#ifdef __cplusplus
SHARED_LAYOUT(CommandParams, width, height, surfaces, shaders, materials, wave_log2, waves_per_group_log2, waves,
              reserved, copies);
#endif
SHARED_END
#endif
