// A particle's light at a place on it, by each of the ways that variants have. What leaves a white one.
#pragma once
#include "kernels/particles/quads.h"

namespace assay::particles {

using Colour = Intervals3;
enum class Filter { bilinear, b_spline, catmull_rom };

struct Atlas {
  std::span<const uint32_t> words;  // two a texel of kLightRgba16
  uint32_t side = 0, encoding = 0;
};
// None of a rectangle that is none or reaches out of the atlas.
std::optional<Colour> from_atlas(const Atlas&, uint32_t rect, Filter, const Place&);

// A white, rough particle that light passes through, of a place on it.
Colour lit(const ParticleRecord&, const Ball& position, const vec3& ambient, std::span<const LightRecord>);
// Linear over the two triangles of the quad's corners.
Colour from_corners(const std::array<Colour, 4>&, const Place&);

}  // namespace assay::particles
