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
// Records and receivers of the decals that reach the view, and the atlas of their pictures.
void append_decals(const Scene&, const Camera&, const ClipRows&, Gathered&);
// Records of all particles, and the order of those that are seen.
void append_particles(const Scene&, const Camera&, const ClipRows&, Gathered&);
// Where a decal may be found, relative to the camera, world axes: its box and what shaders' positions may be off.
ClusterItem reach_of(const DecalRecord&, const ReceiverRecord*);
// What a position rebuilt from a depth, and how an item lies to it, may be off by in floats, of the lengths involved:
// gather_clusters.cpp and gather_decals.cpp count under 32 u each, twice that is given.
constexpr double kPositionSlack = 64 * 0x1p-24;

}  // namespace assay::scene
