// Scenes of one tilted quad each, loaded from glTF made here: one of each kind of material that a texturing pass may
// get wrong. Lit by a spot and a point light; the camera looks at the quad's middle from 3 m.
#pragma once
#include <string>
#include <vector>

#include "harness/scene/scene.h"

namespace assay::tests {

// masked, double_sided (seen from behind), tangentless (mirrored UVs and a normal map), uvless (textured all the same),
// textureless.
const std::vector<std::string>& small_scene_names();
scene::Scene small_scene(const std::string& name);

}  // namespace assay::tests
