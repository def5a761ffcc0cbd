// Cases put together from sheets: rectangles of the screen, each a surface of two triangles with UVs at its corners.
#pragma once
#include "harness/oracle.h"
#include "kernels/deferred_texturing/layout.h"
#include "kernels/deferred_texturing/lists.h"

namespace assay::deferred_texturing {

struct Rectangle {
  uint32_t x = 0, y = 0, width = 1, height = 1;  // pixels
};

// Of a pixel, in double: what attribute interpolation would have stored.
struct Frame {
  glm::dvec3 normal = {0, 0, 1}, tangent = {1, 0, 0};
  bool left_handed = false, front_facing = true;
};
struct Interpolated {
  glm::dvec2 weights = {}, d_dx = {}, d_dy = {};  // of the second and third vertex
  Frame frame = {};
};
// How a sheet lies in space.
struct Shape {
  std::array<double, 4> depths = {1, 1, 1, 1};  // clip w of its corners
  double bulge = 0;                             // its normals lean outwards by this much at the corners
  bool mirrored = false;                        // by the transform from the mesh's space
};
struct Encoded {
  uint barycentrics;
  uvec2 derivatives, tangent_frame;
};
Encoded encode(const Interpolated&);

struct Builder {
  Extent extent = {};
  std::vector<uvec2> visibility = {};
  std::vector<SurfaceRecord> surfaces = {};
  std::vector<MaterialRecord> materials = {};
  std::vector<uint> indices = {};
  std::vector<vec3> positions = {};
  std::vector<VertexAttributes> vertices = {};
  std::vector<uint> barycentrics = {};
  std::vector<uvec2> derivatives = {}, tangent_frame = {};
  std::vector<Texture> textures = {};
  std::vector<uint8_t> copy_bits = {};
  uint32_t tiles_with_room = ~0u;
  std::vector<uint> stale = {};
  std::vector<uint32_t> hidden_classes = {};  // registered nowhere, whatever shows them
  bool registers_unseen = false;              // classes that no pixel shows, as where something hides them

  explicit Builder(Extent);
  uint32_t add_material(const MaterialRecord&);
  // Corners: UV at left top, right top, left bottom, right bottom. Returns the surface. Its mesh, of two triangles, and
  // the attributes of its pixels are of one shape: what is stored is what interpolation would find.
  uint32_t add_sheet(const Rectangle&, uint32_t material, const std::array<vec2, 4>& corners, const Frame& = {},
                     const Shape& = {});
  // Bits above the index, for every pixel that shows the surface.
  void flag_surface(uint32_t surface, uint32_t bits);
  // What is stored of a pixel, whatever its mesh says.
  void set(uint32_t x, uint32_t y, const Interpolated&);
  Case finish(std::string name = {}) const;
};

// UVs from 0,0 at the left top, this much a pixel.
std::array<vec2, 4> uv_by_pixel(const Rectangle&, vec2 per_pixel, vec2 origin = vec2(0));
MaterialRecord plain_material(uint32_t shader = kShaderOpaque);  // white, no textures
uint32_t texture_name(uint32_t array, uint32_t layer);

using TexelFunction = std::function<uint32_t(uint32_t x, uint32_t y, uint32_t layer, uint32_t channel)>;
// With a chain of levels, each the mean of four texels of the last; or level 0 alone.
Texture texture_of(Format, Extent, uint32_t layers, const TexelFunction&, bool chain = true);
Texture constant_texture(Format, const std::array<uint32_t, 4>& texel);
// Every level of one colour, another each: rgb from `colour(level)`.
Texture levels_texture(Format, Extent, const std::function<uint32_t(uint32_t level, uint32_t channel)>&);

}  // namespace assay::deferred_texturing
