// Cases for the shadow atlas, put together caster by caster.
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "harness/raster/mesh.h"
#include "kernels/shadow_atlas/inputs.h"

namespace assay::shadow_atlas {

using raster::Mesh;

// Looks along -z from the origin, y up. A spot sees half_width metres either side at a metre's distance, `first` being
// its near plane; a sun sees half_width everywhere, depth is 1 at `first` metres along -z and 0 at `last`.
struct LightView {
  bool is_sun = false;
  double half_width = 1, first = 0.125, last = 64;
  glm::dmat4 clip() const;  // multiplies from the left
  // The point seen at x, y of the tile, 0..1 from its first texel's corner, at this distance along -z.
  vec3 at(double x, double y, double distance) const;
};

constexpr LightView kFlat = {.is_sun = true, .half_width = 1, .first = 0, .last = 1};  // depth is 1 - distance

constexpr uint32_t kBeyond = 0xffffffffu;  // a tile of no list

struct Look {
  bool moving = false;
  MaterialRecord material = {vec4(1), kNoTexture, 0.5f, 0, 0};  // kMaterialMasked: cut
};
struct Placed {
  uint32_t tile = 0;  // of the list that it is drawn for
  LightView light = {};
  glm::dmat4 place = glm::dmat4(1);
};

class Builder {
 public:
  Builder(uint32_t width, uint32_t height) : extent{width, height} {}
  // Their number in the list.
  uint32_t add_still_tile(const ShadowTile&);
  uint32_t add_tile(const ShadowTile&);
  // In both lists, at the same number if it is always so.
  uint32_t add_both(const ShadowTile&);
  // One command, an instance a caster.
  void add(const Mesh&, const Look&, const std::vector<Placed>&);
  uint32_t add_texture(Texture);
  Case finish() const;
  Extent extent;

 private:
  struct Draw {
    DrawCommand command;
    uint32_t range;
  };
  std::vector<ShadowTile> still_tiles_, tiles_;
  std::vector<vec3> positions_;
  std::vector<VertexAttributes> attributes_;
  std::vector<uint32_t> indices_;
  std::vector<ShadowCaster> casters_;
  std::vector<MaterialRecord> materials_;
  std::vector<Draw> draws_;
  std::vector<Texture> textures_;
};

// Over all of the tile at this distance, and half a tile beyond each side.
Mesh cover(const LightView&, double distance);
Look masked_look(float factor, float cutoff, uint32_t texture = kNoTexture);

}  // namespace assay::shadow_atlas
