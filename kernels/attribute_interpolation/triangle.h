// The oracle's triangle of a pixel, and its weights by every formula that has a bound.
#pragma once
#include <optional>

#include "kernels/attribute_interpolation/layout.h"
#include "kernels/attribute_interpolation/rounded.h"

namespace assay::attribute_interpolation {

// A case's bytes as the oracle reads them.
struct Scene {
  AttributeParams params;
  std::span<const uvec2> visibility;
  std::span<const vec3> positions;
  std::span<const VertexAttributes> attributes;
  std::span<const uint> indices;
  std::span<const SurfaceRecord> surfaces;
  std::span<const ClipSample> clip_samples;
};
Scene scene_of(const Case&);

struct SeenTriangle {
  Few<vec3, 3> corners;         // clip x, y, w: floats, as the visibility draw has them
  Few<double, 3> flushed = {};  // of a corner: how much a device may have flushed away
  double half_width = 0, half_height = 0, offset_x = 0, offset_y = 0;  // pixels; exact
  const SurfaceRecord* surface = nullptr;                              // none: a clip sample
  Few<const VertexAttributes*, 3> attributes = {};
  bool flipped = false;
};
std::optional<SeenTriangle> triangle_at(const Scene&, uint64_t pixel);

// What a formula may answer. Where `determined` is false, the weights are anywhere in the simplex if clamped, the rest
// anything.
struct Hit {
  bool determined = false;
  bool clamped = true;  // the weights are kept in the simplex
  Few<RoundedDouble, 3> weights;
  Few<RoundedDouble, 4> derivatives;  // d lambda_1/dx, d lambda_2/dx, d lambda_1/dy, d lambda_2/dy
  bool clockwise = false;
};
// Formulas by their bound. `paired` is the compensated one, or pairs of floats where that is ill-conditioned.
enum class Formula { compensated, paired, edges };
inline constexpr std::initializer_list<Formula> kFormulas = {Formula::compensated, Formula::paired, Formula::edges};
const char* name_of(Formula);
Hit hit(const SeenTriangle&, Formula);

}  // namespace assay::attribute_interpolation
