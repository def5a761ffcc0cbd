// The tangent frame of a pixel as the oracle knows it.
#pragma once
#include "kernels/attribute_interpolation/triangle.h"

namespace assay::attribute_interpolation {

// A unit vector; where not `determined`, any.
struct Direction {
  bool determined = false;
  Few<RoundedDouble, 3> xyz;
};
struct TangentFrame {
  Direction normal, tangent;
  bool left_handed = false;
};
TangentFrame frame_of(const SeenTriangle&, const Hit&);
// x and y in Lambert's azimuthal projection.
Few<RoundedDouble, 2> lambert(const Direction&);

}  // namespace assay::attribute_interpolation
