// The visibility buffer as lists of pixels for one texturing shader each (Lazarek, Hammer 2025, material compute
// dispatch). An entry is a pixel; a wave is kWaveSize entries, of one material and one tile save in the overflow; a
// command is a run of 2^k waves that lie side by side. harness/glsl/pixel_commands.glsl is the consuming side.
#ifndef FORMATS_PIXEL_COMMANDS_H
#define FORMATS_PIXEL_COMMANDS_H
#include "harness/formats/features.h"
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// Bits of an entry. An invalid one fills a wave up; its other bits are zero.
SHARED_CONST uint kEntryCoordinateBits = 14u;  // x in bits 0..13, y in bits 14..27: screens up to 16384 x 16384
SHARED_CONST uint kEntryCopyShift = 28u;       // the shaded pixel is also copied: horizontally, vertically, diagonally
SHARED_CONST uint kEntryInvalid = 0x80000000u;

// Bits of a texel of the copy-bits image (variable-rate shading; Fuller, Hammer 2025), and of an entry from
// kEntryCopyShift on.
SHARED_CONST uint kCopyHorizontal = 1u;
SHARED_CONST uint kCopyVertical = 2u;
SHARED_CONST uint kCopyDiagonal = 4u;
SHARED_CONST uint kCopyBits = 7u;
SHARED_CONST uint kCopyDuplicate =
    0x80u;  // of the image only: not a primary, another pixel's copy fills it; not listed

// The wave that entries are padded to, and the workgroup that consumes them: several waves, for groups under 64 threads
// are slow where a CPU runs them.
SHARED_CONST uint kWaveSize = 32u;
SHARED_CONST uint kWavesPerGroup = 2u;
SHARED_CONST uint kCommandThreads = kWaveSize * kWavesPerGroup;

// Rows, kCommandRows a visible shader (slot): row = slot * kCommandRows + kind * kCommandBuckets + k, then the
// overflow. Commands of bucket k have 2^k waves; what a tile has beyond is further commands of the last bucket, which
// holds a full tile of one material. More buckets would be more dispatches, and almost all of them empty.
SHARED_CONST uint kCommandBuckets = 6u;
SHARED_CONST uint kUniformLists = 0u;    // kind: all pixels of a wave's material in the tile have one surface
SHARED_CONST uint kDivergentLists = 1u;  // kind: one material, several surfaces
SHARED_CONST uint kOverflowRow = 2u * kCommandBuckets;  // waves of any materials and tiles, for want of room
SHARED_CONST uint kCommandRows = kOverflowRow + 1u;

// A row's list. Of the overflow: its first wave and its number of waves, without commands.
struct CommandRow {
  uint first;  // in `commands`
  uint count;  // commands
};

// Of a shader slot.
struct ShaderCommands {
  uint first;            // wave where its padded waves begin
  uint pixels;           // that it shades
  uint padded_tiles;     // tiles below this are in the padded lists, the others in the overflow
  uint overflow_first;   // wave where its overflow begins
  uint overflow_pixels;  // those beyond the capacity included
};

// Of a shader slot and a tile, slot * tiles + tile. Waves and pixels before are those of the slot's tiles below.
struct TileCommands {
  uint pixels;
  uint waves;  // uniform ones in bits 0..15, divergent ones above; in this order they lie in the list
  uint pixels_before;
  uint waves_before;
};

// Of a padded wave: its material slot, and the first wave of that material's run in the tile.
struct WaveMaterial {
  uint material;
  uint first;
};

struct CommandStatus {
  uint pixels;    // in lists
  uint waves;     // padded, of the lists as they are
  uint overflow;  // pixels in unpadded waves, for want of room
  uint unlisted;  // pixels with a surface that no visible shader or material takes, or that there is not
  uint lost;      // pixels beyond the capacity; 0 where it holds every pixel unpadded
  uint wanted;    // entries that would have padded everything, saturated
};

#ifdef __cplusplus
SHARED_LAYOUT(CommandRow, first, count);
SHARED_LAYOUT(ShaderCommands, first, pixels, padded_tiles, overflow_first, overflow_pixels);
SHARED_LAYOUT(TileCommands, pixels, waves, pixels_before, waves_before);
SHARED_LAYOUT(WaveMaterial, material, first);
SHARED_LAYOUT(CommandStatus, pixels, waves, overflow, unlisted, lost, wanted);
#endif
SHARED_END
#endif
