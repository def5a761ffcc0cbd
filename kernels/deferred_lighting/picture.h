// G-buffers made by hand, for the cases, and what their pixels' rates make of them.
#pragma once
#include <array>
#include <functional>

#include "harness/light_records.h"
#include "harness/shadow_maps.h"
#include "kernels/deferred_lighting/layout.h"

namespace assay::deferred_lighting {

struct Picture {
  Extent extent = {};
  LightingParams params = {};
  std::vector<float> depth = {};
  std::vector<uint32_t> base = {}, normal = {}, emissive = {}, features = {};
  std::vector<uint16_t> metal = {};
  std::vector<LightRecord> lights = {};
  // Cells of params.grid, with the lights of each; empty: to_case makes some.
  std::vector<float> slice_edges = {};
  std::vector<uvec2> cells = {};
  std::vector<uint32_t> entries = {};
  // What covers each pixel, and the rate of each cell of 2x2; empty: to_case makes some, covered where there is depth.
  std::vector<uvec2> visibility = {};
  std::vector<uint8_t> rates = {};
  // How depth changes over itself, halves; empty: to_case takes the lesser differences.
  std::vector<std::array<uint16_t, 2>> gradients = {};
  shadowing::Atlas atlas = shadowing::Atlas({1, 1});

  size_t at(uint32_t x, uint32_t y) const { return size_t{y} * extent.width + x; }
  glm::dvec3 ray(double x, double y) const;                     // to view depth 1, through (x, y) in pixels
  glm::dvec3 position(uint32_t x, uint32_t y) const;            // of the pixel's surface
  void place(uint32_t x, uint32_t y, double view_depth);        // sets the depth
  void face(uint32_t x, uint32_t y, const glm::dvec3& normal);  // sets the normal
  void lean(uint32_t x, uint32_t y, const glm::dvec3& normal);  // sets the gradient, of a plane
  void face_eye(uint32_t x, uint32_t y) { face(x, y, -ray(x + 0.5, y + 0.5)); }
};

// 90 degrees across, looking along -z; a grey wall of medium roughness 3 m away that faces the camera.
Picture wall(Extent, double view_depth = 3);
// A hall with balls of every roughness and some metals, as a frame might have it, of triangles of 25x23 pixels.
Picture hall(Extent);
Case to_case(const std::string& name, const Picture&);
// Cells of so many pixels with slices at these depths, and in each `lights_in(cell)` of the picture's lights.
void add_cells(Picture&, Extent cell, const std::vector<float>& depths,
               const std::function<std::vector<uint32_t>(uint32_t)>& lights_in);

// A triangle for each 5x7 pixels where there is depth, so that seams run through cells.
std::vector<uvec2> covered_by_depth(const Picture&);
// The inputs that say which pixels are shaded and which copied, in frame params.frame.
void set_primaries(Case&, const Picture&);

uint32_t octahedral_code(const glm::dvec3&);
uint32_t base_code(uint32_t red, uint32_t green, uint32_t blue, uint32_t roughness);  // bytes
inline uint16_t metal_code(uint32_t metallic, uint32_t occlusion) {
  return static_cast<uint16_t>(metallic | occlusion << 8);
}

// Views of its lights, a row of tiles each, up to eight of them; what casts is random and lies between.
void add_shadows(Picture&, Pcg32&);
// Of the hall, in which its first three lights are a sun, a point and a spot; its balls cast.
void add_hall_shadows(Picture&);
// Lights of every kind about the picture's surfaces, bright enough to be seen.
void add_lights(Picture&, Pcg32&, uint32_t count, double reach);

}  // namespace assay::deferred_lighting
