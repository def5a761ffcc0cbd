#include "kernels/material_features/oracle.h"

#include "harness/oracle.h"
#include "kernels/material_features/layout.h"

namespace assay::material_features {

Answer expected_features(const Case& c) {
  const auto visibility = c.input<uvec2>("visibility");
  const auto surfaces = c.input<SurfaceRecord>("surfaces");
  const auto materials = c.input<MaterialRecord>("materials");
  std::vector<uint32_t> features(visibility.size(), 0);
  for (size_t i = 0; i < visibility.size(); ++i) {
    const uint32_t surface = visibility[i].y % (1u << 30);  // without the two flags
    if (surface >= surfaces.size()) continue;
    const uint32_t material = surfaces[surface].material;
    if (material < materials.size()) features[i] = materials[material].features;
  }
  return {{"features", expect_all(features)}};
}

}  // namespace assay::material_features
