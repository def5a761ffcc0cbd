// Inside of the gather: one file a subject.
#pragma once
#include "harness/scene/scene.h"

namespace assay::scene {

uint32_t material_flags(const Material&);
// Material records, their array textures, shader classes and slots, from the surfaces gathered so far.
void append_materials(const Scene&, Gathered&);
// The scene's own, or the one that a scene without any gets.
std::vector<Light> lights_of(const Scene&, const Camera&);
void append_lights(const Scene&, const Camera&, const ClipRows&, Gathered&);

}  // namespace assay::scene
