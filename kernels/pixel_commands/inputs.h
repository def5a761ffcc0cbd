#pragma once
#include "harness/oracle.h"
#include "kernels/pixel_commands/layout.h"

namespace assay::pixel_commands {

Inputs inputs();
Case typical(Extent);  // 64 materials of 8 shaders on some hundred surfaces
Case frame(const FrameInputs&);

// A screen to fill: surface_slots and what covers each pixel.
struct Screen {
  Extent extent = {};
  std::vector<SurfaceSlot> slots = {};
  std::vector<uvec2> visibility = {};   // nothing at first
  std::vector<uint8_t> copy_bits = {};  // empty: the case has none
  CommandParams params = {};            // extent, surfaces and capacity are set by to_case
};
Screen screen_of(Extent, uint shaders, uint materials);
// Room for all padded, where params.waves is 0.
Case to_case(const Screen&);
Case with_params(Case, const std::function<void(CommandParams&)>& change);
Case with_capacity(Case, uint64_t entries);  // in whole waves, rounded down

std::vector<HardCase> hard_cases();
std::vector<Mutant> mutants();

}  // namespace assay::pixel_commands
