// What the lists must hold, stated over pixels: sorted, grouped, and laid out one after the other.
#pragma once
#include "harness/kernel.h"
#include "kernels/pixel_commands/layout.h"

namespace assay::pixel_commands {

uint32_t live_shaders(const Case&);  // slots that are looked at
uint32_t wave_size(const Case&);
uint64_t tiles(const Case&);

struct Demand {                       // capacities, in entries, 2^32 and over included
  uint64_t unpadded = 0, wanted = 0;  // the least that loses no pixel; the least that pads everything
};
Demand demand_of(const Case&);

// Everything exact. The entries of a run are given in scan order, and may stand in any where the bound is same_set.
Answer list_pixels(const Case&);

}  // namespace assay::pixel_commands
