// Which triangle a pixel of the visibility buffer shows, and where its corners are. The includer binds `positions`,
// `indices` and `surfaces`, and its params have width, height and the counts of the three: vertices, indices, surfaces.
// An index at or past a count is taken for the last.
#ifndef HARNESS_GLSL_INTERPOLATION_SHOWN
#define HARNESS_GLSL_INTERPOLATION_SHOWN
#include "harness/formats/visibility.h"
#include "harness/glsl/interpolation/triangle.glsl"

struct Shown {
  Triangle triangle;
  bool flipped;  // the transform mirrors
  uint surface;
  uvec3 vertices;
};

uint clamped(uint i, uint count) { return min(i, count - 1u); }

// `texel`: the visibility buffer's. False where it shows nothing, or there is nothing.
bool shown_at(uvec2 pixel, uvec2 texel, out Shown t) {
#ifdef MUTANT_9113  // no surface where only one word is all ones
  if (texel.y == kVisibilityNone) return false;
#else
  if (texel == uvec2(kVisibilityNone)) return false;
#endif
  if (params.surfaces == 0u || params.indices == 0u || params.vertices == 0u) return false;
#ifdef MUTANT_9114  // the instanced bit stays in the index
  t.surface = clamped(texel.y & ~kVisibilityFlipped, params.surfaces);
#else
  t.surface = clamped(texel.y & kVisibilitySurfaceMask, params.surfaces);
#endif
  const SurfaceRecord s = surfaces[t.surface];
  for (uint k = 0u; k < 3u; ++k) {
    const uint index = indices[clamped(s.first_index + 3u * texel.x + k, params.indices)];
#ifdef MUTANT_9115  // the vertex offset is not added
    t.vertices[k] = clamped(index, params.vertices);
#else
    t.vertices[k] = clamped(index + s.vertex_offset, params.vertices);
#endif
    t.triangle.corners[k] = corner_of(s, positions[t.vertices[k]]);
  }
  place(t.triangle, pixel, uvec2(params.width, params.height));
  t.flipped = (texel.y & kVisibilityFlipped) != 0u;
  return true;
}
#endif
