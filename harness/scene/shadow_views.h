// The views of a light that casts shadows: how large its tiles should be, and what each sees.
#pragma once
#include <optional>

#include "harness/scene/scene.h"
#include "harness/scene/shadow_packing.h"

namespace assay::scene {

constexpr double kWidestSpot_rad = 1.3962634;  // 80 degrees: what a cone shines on beyond has no shadow

// World coordinates to the clip space of a tile, as ShadowCaster's rows.
struct LightView {
  glm::dvec4 x, y, z, w;
  double farthest = 1e300;  // w beyond which the light does not reach
  double bias = 0;          // ShadowView's
};

// Nothing of a light that casts none. `bounds`: the scene's.
std::optional<TileWish> wish_of(const Light&, uint32_t number, const Camera&, Extent, const Bounds& bounds);
// As many as the wish has, for tiles of that side.
std::vector<LightView> views_of(const Light&, const Camera&, Extent, const Bounds& bounds, uint32_t side);

}  // namespace assay::scene
