// The oracle's triangle of a pixel, and its weights by every formula that has a bound.
#pragma once
#include <optional>

#include "harness/interpolation_oracle.h"
#include "kernels/attribute_interpolation/layout.h"

namespace assay::attribute_interpolation {

using namespace interpolation;

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

struct SeenTriangle : ShownTriangle {  // without a surface: a clip sample
  Few<const VertexAttributes*, 3> attributes = {};
};
std::optional<SeenTriangle> triangle_at(const Scene&, uint64_t pixel);

// Formulas by their bound. `paired` is the compensated one, or pairs of floats where that is ill-conditioned.
enum class Formula { compensated, paired, edges };
inline constexpr std::initializer_list<Formula> kFormulas = {Formula::compensated, Formula::paired, Formula::edges};
const char* name_of(Formula);
Hit hit(const SeenTriangle&, Formula);
TangentFrame frame_of(const SeenTriangle&, const Hit&);
// x and y in Lambert's azimuthal projection.
Few<RoundedDouble, 2> lambert(const Direction&);

}  // namespace assay::attribute_interpolation
