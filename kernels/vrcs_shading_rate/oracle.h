// The rates that a luma image asks for.
#pragma once
#include <functional>

#include "harness/kernel.h"
#include "kernels/vrcs_shading_rate/layout.h"

namespace assay::vrcs_shading_rate {

inline Extent cells_of(Extent picture) { return tiles_of(picture, kCellSide); }

enum class Estimator { sobel, first_difference, second_difference, second_and_slope };
const char* name_of(Estimator);

// A pixel's luma, 0..255, by column and row of the picture.
using Codes = std::function<int(int64_t x, int64_t y)>;

// Squared errors of 2x1, 1x2 and 2x2 over a tile of `side` pixels, in squared codes (README, How), and its mean luma,
// in codes; exact.
struct Errors {
  double across = 0, down = 0, both = 0, mean = 0;
};
Errors errors_of(Estimator, Extent picture, uint32_t side, uint32_t column, uint32_t row, const Codes&);

// Of each cell the rates that rounding allows, by estimator and tile: "sobel_2", "sobel_8", ...
Answer rates(const Case&);

}  // namespace assay::vrcs_shading_rate
