#pragma once
#include "harness/kernel.h"

namespace assay::deferred_lighting {

bool has_surface(float depth);

// A texel of `radiance` unpacked.
Layout texel_layout();
Bytes unpack_texels(std::span<const std::byte>);

// The radiance that leaves each pixel's surface towards the eye: emission, ambient light that the surroundings let in,
// and each light's share; with the error that fp32 may make of it, then either neighbouring half.
// "clustered_radiance" is of the lights that the pixel's cell lists; answers named after variants that shade primaries
// are those of each pixel's sources, and "..._shadowed" those of what the shadow atlas lets through. There a texel is
// undecided where rounding may tip a comparison of depths.
Answer expected_radiance(const Case&);

// How wide the oracle's interval is at each judged pixel and channel, relative to its middle, halves apart: what the
// bound is worth. Channels under 1e-3 are left out.
std::vector<double> relative_widths(const Case&);

}  // namespace assay::deferred_lighting
