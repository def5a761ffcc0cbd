#include "kernels/shadow_atlas/builder.h"

#include <glm/gtc/matrix_access.hpp>

namespace assay::shadow_atlas {

glm::dmat4 LightView::clip() const {
  glm::dmat4 m(0);
  m[0][0] = 1 / half_width;
  m[1][1] = -1 / half_width;  // y down
  if (is_sun) {
    m[2][2] = 1 / (last - first);
    m[3][2] = last / (last - first);
    m[3][3] = 1;
  } else {
    m[3][2] = first;
    m[2][3] = -1;
  }
  return m;
}

vec3 LightView::at(double x, double y, double distance) const {
  const double wide = half_width * (is_sun ? 1 : distance);
  return vec3((2 * x - 1) * wide, (1 - 2 * y) * wide, -distance);
}

uint32_t Builder::add_still_tile(const ShadowTile& t) {
  still_tiles_.push_back(t);
  return static_cast<uint32_t>(still_tiles_.size() - 1);
}

uint32_t Builder::add_tile(const ShadowTile& t) {
  tiles_.push_back(t);
  return static_cast<uint32_t>(tiles_.size() - 1);
}

uint32_t Builder::add_both(const ShadowTile& t) {
  add_still_tile(t);
  return add_tile(t);
}

void Builder::add(const Mesh& mesh, const Look& look, const std::vector<Placed>& placed) {
  DrawCommand d = {};
  d.index_count = static_cast<uint32_t>(mesh.indices.size());
  d.instance_count = static_cast<uint32_t>(placed.size());
  d.first_index = static_cast<uint32_t>(indices_.size());
  d.vertex_offset = static_cast<uint32_t>(positions_.size());
  d.first_instance = static_cast<uint32_t>(casters_.size());
  for (const Placed& p : placed) {
    const glm::dmat4 clip = p.light.clip() * p.place;
    const auto row = [&](int i) { return vec4(glm::row(clip, i)); };
    casters_.push_back({row(0), row(1), row(2), row(3), p.tile, static_cast<uint32_t>(materials_.size())});
  }
  const bool cut = (look.material.flags & kMaterialMasked) != 0;
  draws_.push_back({d, look.moving ? cut ? kShadowMovingMasked : kShadowMoving
                       : cut       ? kShadowStillMasked
                                   : kShadowStill});
  materials_.push_back(look.material);
  positions_.insert(positions_.end(), mesh.positions.begin(), mesh.positions.end());
  attributes_.insert(attributes_.end(), mesh.attributes.begin(), mesh.attributes.end());
  indices_.insert(indices_.end(), mesh.indices.begin(), mesh.indices.end());
}

uint32_t Builder::add_texture(Texture t) {
  textures_.push_back(std::move(t));
  return static_cast<uint32_t>(textures_.size() - 1);
}

Case Builder::finish() const {
  Case c;
  c.extent = extent;
  ShadowAtlasParams params = {};
  ShadowCounts& n = params.shadows;
  std::vector<DrawCommand> commands;
  for (uint32_t range = 0; range < kShadowDraws; ++range) {
    n.draw_first[range] = static_cast<uint32_t>(commands.size());
    for (const Draw& d : draws_)
      if (d.range == range) commands.push_back(d.command);
  }
  n.draw_first[kShadowDraws] = static_cast<uint32_t>(commands.size());
  n.width = extent.width, n.height = extent.height;
  n.still_tiles = static_cast<uint32_t>(still_tiles_.size()), n.tiles = static_cast<uint32_t>(tiles_.size());
  n.casters = static_cast<uint32_t>(casters_.size());
  params.scene.vertices = static_cast<uint32_t>(positions_.size());
  params.scene.indices = static_cast<uint32_t>(indices_.size());
  params.scene.materials = static_cast<uint32_t>(materials_.size());
  c.set_params(params);
  c.set_input("positions", positions_);
  c.set_input("attributes", attributes_);
  c.set_input("indices", indices_);
  c.set_input("casters", casters_);
  c.set_input("draws", commands);
  c.set_input("materials", materials_);
  c.set_input("still_tiles", still_tiles_);
  c.set_input("tiles", tiles_);
  c.textures["textures"] = textures_;
  // What earlier frames left is loud, of both images its own, and differs from texel to texel.
  std::vector<float> still(pixels(c)), depth(pixels(c));
  Pcg32 rng(5);
  for (float& f : still) f = static_cast<float>(rng.range(0.25, 0.5));
  for (float& f : depth) f = static_cast<float>(rng.range(0.5, 0.75));
  c.set_input("still", still);
  c.set_input("depth", depth);
  return c;
}

Mesh cover(const LightView& light, double distance) {
  Mesh m;
  raster::add_grid(m, 1, 1, [&](float u, float v) { return light.at(2 * u - 0.5, 2 * v - 0.5, distance); });
  return m;
}

Look masked_look(float factor, float cutoff, uint32_t texture) {
  Look look;
  look.material = {vec4(1, 1, 1, factor), texture, cutoff, kMaterialMasked, 0};
  return look;
}

}  // namespace assay::shadow_atlas
