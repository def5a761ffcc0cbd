// Pixel commands (formats/pixel_commands.h) of a visibility buffer, made on the CPU for cases.
#pragma once
#include "harness/formats/pixel_commands.h"
#include "harness/oracle.h"

namespace assay::deferred_texturing {

struct Lists {
  std::vector<uint> entries, commands;
  std::vector<CommandRow> rows;
  std::vector<DispatchArgs> args;
  uint32_t waves = 0;
};

// Of a surface: its material, and its slot among `shaders`; kUnregistered: its pixels are not listed.
struct Listing {
  Extent extent;
  const std::vector<uvec2>& visibility;
  const std::vector<SurfaceSlot>& slots;  // a surface
  const std::vector<uint8_t>& copy_bits;  // a pixel, or empty
  uint32_t shaders = 0;
  uint32_t tiles_with_room = ~0u;  // tiles from here on go to the overflow
  // Put before a wave's own entries, where there is padding for it: an entry that no list should hold.
  std::vector<uint> stale = {};
};
Lists lists_of(const Listing&);

}  // namespace assay::deferred_texturing
