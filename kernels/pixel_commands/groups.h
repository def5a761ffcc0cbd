// The oracle's first half: a screen's pixels by tile, shader and material.
#pragma once
#include <vector>

#include "harness/kernel.h"
#include "kernels/pixel_commands/layout.h"

namespace assay::pixel_commands {

struct Group {  // pixels of one shader and material in one tile
  uint shader = 0, material = 0;
  bool divergent = false;          // of several surfaces
  uint64_t first = 0, pixels = 0;  // in Grouped.entries
};

struct Grouped {
  std::vector<uint> entries = {};        // tile after tile, group after group, within a group in scan order
  std::vector<Group> groups = {};        // of a tile: by shader, uniform ones first, ascending by material
  std::vector<size_t> first_group = {};  // of a tile; one more for the end
  uint64_t unlisted = 0;                 // covered pixels that no group takes
};

Grouped group_pixels(const Case&);

}  // namespace assay::pixel_commands
