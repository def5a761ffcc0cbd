// Particles as quads of the view: where a pixel sees them, and which pixels may.
#pragma once
#include <optional>

#include "harness/bounded.h"
#include "kernels/particles/layout.h"

namespace assay::particles {

// Which particles there are to draw (layout.h, kFarthest and kSmallest).
bool is_drawn(const ParticleRecord&);

// Corner -1 or 1 along either axis, or any place on the quad.
glm::dvec3 position(const ParticleRecord&, const glm::dvec2& at);

struct View {
  ParticlesParams params;
  Extent extent;
  double grid = 256;  // sub-pixel positions a pixel
};
// Through a pixel's centre.
Ball ray_of(const ParticlesParams&, uint32_t x, uint32_t y);

// A pixel's place on a quad.
struct Place {
  Interval x, y;       // along right and up
  Interval depth;      // metres
  bool known = false;  // false: the quad is seen edge on, and the place may be any
};

struct Quad {
  ParticleRecord record;
  Ball normal;
  bool whole_screen = false;  // it surely reaches before the near plane
  bool clipped = false;       // the sides of the view may cut it
  double moved = 0;           // how far its edges may be from where they are, pixels
  // Pixels that it may cover: first, and one past the last.
  uint32_t x_first = 0, y_first = 0, x_end = 0, y_end = 0;
};
std::optional<Quad> quad_of(const View&, const ParticleRecord&);  // none: it is not drawn
Place place_of(const View&, const Quad&, uint32_t x, uint32_t y);

// How often a pixel of that place may be covered. Away from the edges once; where the sides of the view cut the
// triangles, pixels on their common edge may lie in either, both or none.
struct Times {
  int least = 1, most = 1;
};
Times times_covered(const View&, const Quad&, uint32_t x, uint32_t y);

}  // namespace assay::particles
