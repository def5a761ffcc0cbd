// The shadow lookup in double, with what fp32 may make of it: for the oracles of every kernel that includes
// harness/glsl/shadows.glsl. Host only.
#pragma once
#include <span>

#include "harness/bounded.h"
#include "harness/formats/light.h"
#include "harness/formats/shadow.h"

namespace assay::shadowing {

struct Map {
  std::span<const ShadowView> views;
  Extent extent;                  // of the atlas, texels
  std::span<const float> depths;  // its rows
};

// The share of a light that arrives, filtered by so many taps a side. A comparison or a choice that rounding can tip
// makes it an interval that holds all outcomes.
Interval share_of(const Map&, uint32_t taps, const LightRecord&, const Ball& position, const Ball& normal,
                  float dither);

// Of a pixel in a frame, as floats have it exactly.
float dither_of(uint32_t x, uint32_t y, uint32_t frame);

}  // namespace assay::shadowing
