// What sampling a scene's image may give: mip chains made here from the images alone, filtered in double, with the room
// that Vulkan leaves to a sampler as a range.
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <map>
#include <vector>

#include "harness/scene/scene.h"

namespace assay::tests {

struct Range {
  double low = 0, high = 0;
  bool holds(double v) const { return low <= v && v <= high; }  // false for NaN
  Range widened(double by) const { return {low - by, high + by}; }
};
Range operator*(const Range& a, const Range& b);
Range operator*(double a, const Range& b);
Range hull(const Range& a, const Range& b);
Range mix(const Range& a, const Range& b, double t);  // t in 0..1
using RangedTexel = std::array<Range, 4>;

// What a sampler may do otherwise than the formulas (Vulkan 1.3, "Texel Filtering" and "Scale Factor Operation"). The
// defaults are those of a device with 8 bits of weights, 4 of levels, that filters 8-bit texels in 8 bits.
struct SamplerRoom {
  double weight = 1.0 / 256;                // of a texel coordinate: a step of 2^-subTexelPrecisionBits
  double level = 2.0 / 16;                  // lambda itself and its fraction are each rounded to 2^-mipmapPrecisionBits
  double value = 3.0 / 255;                 // three lerps (u, v, levels), each truncated to a code
  double value_srgb = 3.0 / (255 * 12.92);  // of linear values that keep sRGB's codes apart: its least slope
  double texel_srgb = 0.5 / 255;            // a decoded texel, on the sRGB side (Direct3D 11's; Vulkan names none)
};

struct Footprint {
  glm::dvec2 uv, per_x, per_y;                    // and its change a pixel
  glm::dvec2 uv_error = {}, gradient_error = {};  // by which each may be off, absolute
};

// Levels of detail that the footprint may have in an image: lambda before clamping. An axis's rho lies between the
// larger of its derivatives and sqrt(2) times their sum.
Range level_of_detail(const Footprint&, uint32_t width, uint32_t height, const SamplerRoom&);

class Filter {
 public:
  explicit Filter(const scene::Scene& s, const SamplerRoom& room = {}) : scene_(s), room_(room) {}
  // Every channel's extremes over what the footprint allows; white for kNone. Repeats at the edges.
  RangedTexel sample(uint32_t image, bool srgb, const Footprint&);
  // A texel of a level, linear: the mean of what it covers, and where rounding to 8 bits may have put it.
  RangedTexel texel(uint32_t image, bool srgb, uint32_t level, int64_t x, int64_t y);
  uint32_t levels(uint32_t image) const;

 private:
  struct Level {
    uint32_t width = 0, height = 0;
    std::vector<float> linear;  // RGBA, empty of the first level, which is the image; float's error is counted
  };
  double value(uint32_t image, bool srgb, const Level&, uint32_t x, uint32_t y, uint32_t channel) const;
  const Level& level(uint32_t image, bool srgb, uint32_t index);
  RangedTexel sample_level(uint32_t image, bool srgb, uint32_t index, const Footprint&);

  const scene::Scene& scene_;
  SamplerRoom room_;
  std::map<std::pair<uint32_t, bool>, std::vector<Level>> chains_;
};

double srgb_to_linear(double);
double linear_to_srgb(double);

}  // namespace assay::tests
