// A pixel's material under decals, in intervals.
#pragma once
#include "harness/filter_oracle.h"
#include "kernels/decal_atlas_sampling/layout.h"

namespace assay::decal_atlas_sampling {

struct SurfacePoint {
  Interval distance;                        // view depth
  Intervals3 position, d_dx, d_dy;          // relative to the camera; of the position, a pixel
  bool finite_dx = true, finite_dy = true;  // false: the derivatives are no numbers
};

struct BlendedMaterial {
  Intervals3 base;  // linear
  Ball normal;
  Interval roughness;
  bool normal_touched = false;  // it may have been encoded again
  bool undecided = false;       // a decal's box may or may not hold the pixel
};

enum class Filtering { trilinear, taps };

struct Atlas {
  TextureFilter albedo, normal, roughness;
  uint32_t width, height, levels;
  float border;  // texels
};

// A decal onto `m`, whose receiver, where it has one, is there.
void apply(BlendedMaterial& m, const DecalRecord&, const ReceiverRecord*, SurfacePoint, const Atlas&, Filtering);

}  // namespace assay::decal_atlas_sampling
