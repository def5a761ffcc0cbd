#include "kernels/visibility/scene_builder.h"

#include <algorithm>
#include <glm/gtc/matrix_access.hpp>

namespace assay::visibility {

glm::dmat4 View::clip() const {
  const double side = std::min(extent.width, extent.height);
  glm::dmat4 m(0);
  m[0][0] = side / extent.width;    // x
  m[1][1] = -side / extent.height;  // y down
  m[2][3] = -1;                     // w: distance along -z
  return m;
}

vec3 View::at(double x, double y, double distance) const {
  const double side = std::min(extent.width, extent.height);
  return vec3((2 * x - extent.width) / side * distance, (extent.height - 2 * y) / side * distance, -distance);
}

SceneBuilder::SceneBuilder(Extent e) : view{e} {}

void SceneBuilder::add(const Mesh& mesh, const Look& look, const std::vector<glm::dmat4>& places) {
  std::vector<SurfaceRecord> surfaces;
  for (const glm::dmat4& place : places) {
    const glm::dmat4 clip = view.clip() * place;
    SurfaceRecord s = {};
    s.clip_x = vec4(glm::row(clip, 0)), s.clip_y = vec4(glm::row(clip, 1)), s.clip_w = vec4(glm::row(clip, 3));
    s.world_x = vec4(glm::row(place, 0)), s.world_y = vec4(glm::row(place, 1)), s.world_z = vec4(glm::row(place, 2));
    if (glm::determinant(place) < 0) s.flags |= kSurfaceFlipped;
    surfaces.push_back(s);
  }
  add_draw(mesh, look, std::move(surfaces));
}

void SceneBuilder::add_rows(const Mesh& mesh, const Look& look, const glm::dmat4& clip) {
  SurfaceRecord s = {};
  s.clip_x = vec4(glm::row(clip, 0)), s.clip_y = vec4(glm::row(clip, 1)), s.clip_w = vec4(glm::row(clip, 3));
  s.world_x = vec4(1, 0, 0, 0), s.world_y = vec4(0, 1, 0, 0), s.world_z = vec4(0, 0, 1, 0);
  add_draw(mesh, look, {s});
}

void SceneBuilder::add_draw(const Mesh& mesh, const Look& look, std::vector<SurfaceRecord> surfaces) {
  DrawCommand d = {};
  d.index_count = static_cast<uint32_t>(mesh.indices.size());
  d.instance_count = static_cast<uint32_t>(surfaces.size());
  d.first_index = static_cast<uint32_t>(indices_.size());
  d.vertex_offset = static_cast<uint32_t>(positions_.size());
  d.first_instance = static_cast<uint32_t>(surfaces_.size());
  const bool flipped = !surfaces.empty() && (surfaces[0].flags & kSurfaceFlipped) != 0;
  const uint32_t flags = look.material.flags;
  const uint32_t facing = (flags & kMaterialDoubleSided) != 0 ? kFacingBoth
                          : flipped                           ? kFacingCullFront
                                                              : kFacingCullBack;
  for (SurfaceRecord& s : surfaces) {
    s.material = static_cast<uint32_t>(materials_.size());
    s.flags |= flags | (look.instanced ? kSurfaceInstanced : 0);
    s.first_index = d.first_index, s.triangle_count = d.index_count / 3, s.vertex_offset = d.vertex_offset;
    s.mesh = static_cast<uint32_t>(draws_.size());
  }
  draws_.push_back({d, ((flags & kMaterialMasked) != 0 ? 3u : 0u) + facing});
  materials_.push_back(look.material);
  positions_.insert(positions_.end(), mesh.positions.begin(), mesh.positions.end());
  attributes_.insert(attributes_.end(), mesh.attributes.begin(), mesh.attributes.end());
  indices_.insert(indices_.end(), mesh.indices.begin(), mesh.indices.end());
  surfaces_.insert(surfaces_.end(), surfaces.begin(), surfaces.end());
}

uint32_t SceneBuilder::add_texture(Texture t) {
  textures_.push_back(std::move(t));
  return static_cast<uint32_t>(textures_.size() - 1);
}

Case SceneBuilder::finish(std::string name) const {
  Case c;
  c.name = std::move(name);
  c.extent = view.extent;
  VisibilityParams params = {};
  params.near_plane = kNear;
  SceneCounts& n = params.scene;
  std::vector<DrawCommand> commands;
  for (uint32_t bucket = 0; bucket < kDrawBuckets; ++bucket) {
    n.bucket_first[bucket] = static_cast<uint32_t>(commands.size());
    for (const Draw& d : draws_)
      if (d.bucket == bucket) commands.push_back(d.command);
  }
  n.bucket_first[kDrawBuckets] = n.draws = static_cast<uint32_t>(commands.size());
  n.vertices = static_cast<uint32_t>(positions_.size()), n.indices = static_cast<uint32_t>(indices_.size());
  n.surfaces = static_cast<uint32_t>(surfaces_.size()), n.materials = static_cast<uint32_t>(materials_.size());
  c.set_params(params);
  c.set_input("positions", positions_);
  c.set_input("attributes", attributes_);
  c.set_input("indices", indices_);
  c.set_input("surfaces", surfaces_);
  c.set_input("draws", commands);
  c.set_input("materials", materials_);
  c.textures["textures"] = textures_;
  return c;
}

}  // namespace assay::visibility
