// A picture with particles before it, made by hand, for the cases.
#pragma once
#include "harness/oracle.h"
#include "kernels/particles/layout.h"

namespace assay::particles {

struct Air {
  Extent extent = {};
  ParticlesParams params = {};
  std::vector<vec4> radiance = {};
  std::vector<float> depth = {};
  std::vector<ParticleRecord> particles = {};
  std::vector<uint32_t> order = {};
  std::vector<uint32_t> rects = {};
  uint32_t side = 0;              // of the atlas
  std::vector<uvec2> atlas = {};  // of encodings of a word its upper is not used
  std::vector<LightRecord> lights = {};

  glm::dvec3 ray(double x, double y) const;        // to view depth 1, through (x, y) in pixels
  void add(const ParticleRecord&, uint32_t rect);  // at the end of the order
};

// 90 degrees across, looking along -z; a wall at a view depth, a picture of many hues, an atlas without particles: its
// texels vary by half an octave from one to the next. No lights.
Air air(Extent, double wall_m = 10);
Case to_case(const std::string& name, const Air&);

// Rays that look elsewhere by so many radians, or a point that does.
glm::dvec3 turned(const glm::dvec3&, double about_y, double about_x);
void set_clip_rows(ParticlesParams&, Extent);

// A disc that faces the viewer, `right` to the right.
ParticleRecord facing(const glm::dvec3& centre, double radius);
// A word of formats/particle.h: which square of so many texels (8, 16, 32), counted in those.
uint32_t rect(uint32_t side, uint32_t column, uint32_t row);
// Radiance as the params' encoding says.
uvec2 encoded(const glm::dvec3&, uint32_t encoding);

void set_atlas(Case&, uint32_t encoding, const std::vector<uvec2>& texels);

// A plume's particles, farthest first, over all of the view, each with a rectangle.
void add_plume(Air&, Pcg32&, uint32_t count, double nearest_m, double farthest_m, double radius_m);
void add_lights(Air&, Pcg32&, uint32_t count);

}  // namespace assay::particles
