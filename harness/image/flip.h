// How far a picture is off another, as a viewer sees it: FLIP, of pictures (Andersson et al. 2020, "FLIP: A Difference
// Evaluator for Alternating Images") and of radiance (Andersson et al. 2021, "Visualizing and Communicating Errors in
// Rendered Images"); and PSNR.
#pragma once
#include <glm/vec3.hpp>

#include "harness/image/image.h"

namespace assay::image {

struct Pixels {  // linear Rec. 709, rows top to bottom
  uint32_t width = 0, height = 0;
  std::vector<glm::vec3> rgb;
};
Pixels linear_of(const Rgba8&);  // alpha is left out
// R, G and B, or those of a layer, the only one or "radiance"; std::runtime_error where there are none.
Pixels linear_of(const Layers&);

// A screen of 3840 pixels and 0.7 m seen from 0.7 m: pixels a degree.
constexpr double kPixelsADegree = 67.0206432765823;

struct Flip {
  std::vector<float> map;  // 0..1 a pixel
  double mean = 0;
  // Of radiance: exposures from `start` to `stop`, in stops, each through ACES' curve; the map is their maximum.
  uint32_t exposures = 1;
  double start = 0, stop = 0;
};
// Both of the same size and finite, else std::runtime_error.
Flip flip(const Pixels& reference, const Pixels& test, double pixels_a_degree = kPixelsADegree);  // of colours in 0..1
Flip flip_hdr(const Pixels& reference, const Pixels& test, double pixels_a_degree = kPixelsADegree);

// dB, infinite where they are equal: of 8-bit codes over 255; of radiance over the reference's largest value.
double psnr(const Rgba8& reference, const Rgba8& test);
double psnr(const Pixels& reference, const Pixels& test);

}  // namespace assay::image
