// Inside of the gather: one file a subject.
#pragma once
#include <map>

#include "harness/scene/scene.h"

namespace assay::scene {

// Appends a mesh's vertices once, and each of its parts' indices once.
struct Merger {
  const Scene& scene;
  Gathered& to;
  std::map<uint32_t, uint32_t> vertex_offsets = {};                      // by mesh
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> first_indices = {};  // by mesh and part

  uint32_t vertex_offset(uint32_t m) {
    const auto [it, is_new] = vertex_offsets.try_emplace(m, static_cast<uint32_t>(to.positions.size()));
    if (is_new) {
      const Mesh& mesh = scene.meshes[m];
      to.positions.insert(to.positions.end(), mesh.positions.begin(), mesh.positions.end());
      to.attributes.insert(to.attributes.end(), mesh.attributes.begin(), mesh.attributes.end());
    }
    return it->second;
  }
  uint32_t first_index(uint32_t m, uint32_t p) {
    const auto [it, is_new] = first_indices.try_emplace({m, p}, static_cast<uint32_t>(to.indices.size()));
    if (is_new) {
      const Part& part = scene.meshes[m].parts[p];
      const auto first = scene.meshes[m].indices.begin() + part.first_index;
      to.indices.insert(to.indices.end(), first, first + part.index_count);
    }
    return it->second;
  }
};

uint32_t material_flags(const Material&);
// Material records, their array textures, shader classes and slots, from the surfaces gathered so far.
void append_materials(const Scene&, Gathered&);
// The scene's own, or the one that a scene without any gets.
std::vector<Light> lights_of(const Scene&, const Camera&);
void append_lights(const Scene&, const Camera&, const ClipRows&, Gathered&);
// Records and receivers of the decals that reach the view, and the atlas of their pictures.
void append_decals(const Scene&, const Camera&, const ClipRows&, Gathered&);
// Views of the lights gathered that cast shadows, the casters of the tiles that are to be drawn, and their meshes.
void append_shadows(const Scene&, const Camera&, Extent, const ShadowRequest&, Merger&);
// Records of all particles, and the order of those that are seen.
void append_particles(const Scene&, const Camera&, const ClipRows&, Gathered&);
// Where a decal may be found, relative to the camera, world axes: its box and what shaders' positions may be off.
ClusterItem reach_of(const DecalRecord&, const ReceiverRecord*);
// What a position rebuilt from a depth, and how an item lies to it, may be off by in floats, of the lengths involved:
// gather_clusters.cpp and gather_decals.cpp count under 32 u each, twice that is given.
constexpr double kPositionSlack = 64 * 0x1p-24;

}  // namespace assay::scene
