// What an edge pixel is, and the inputs that say so. Loads of an invocation: at most 2 * 10 a pixel.
#include "harness/glsl/ports.glsl"
#include "kernels/edge_classification/layout.h"
#include "harness/glsl/tiles.glsl"

READS(0, uint, materials);
READS(1, uint, gradients);
PARAMS(EdgeParams);

uint edge_tiles_across() { return ceil_div(params.width, kEdgeTileSide); }
uint edge_tile_count() { return edge_tiles_across() * ceil_div(params.height, kEdgeTileSide); }

// Two snorm16, x in the low half; -32768 and -32767 are both -1.
ivec2 decode_gradient(uint bits) {
#ifdef MUTANT_1  // the sign is lost
  return ivec2(bits & 0xffffu, bits >> 16);
#else
  return max(ivec2(bitfieldExtract(int(bits), 0, 16), bitfieldExtract(int(bits), 16, 16)), ivec2(-32767));
#endif
}

struct Surface {
  uint material;
  ivec2 gradient;  // 0 where materials alone count
};

Surface surface_of(uint place) {
  Surface surface = Surface(materials[place], ivec2(0));
  if (params.gradients != 0u) surface.gradient = decode_gradient(gradients[place]);
  return surface;
}

// Whether two samples lie on surfaces to be shaded apart.
bool differ(Surface a, Surface b) {
  if (a.material != b.material) return true;
  const uvec2 apart = uvec2(abs(a.gradient - b.gradient));
#if defined(MUTANT_2)  // the threshold itself is an edge
  return apart.x >= params.threshold || apart.y >= params.threshold;
#elif defined(MUTANT_3)  // the second component is forgotten
  return apart.x > params.threshold;
#else
  return apart.x > params.threshold || apart.y > params.threshold;
#endif
}

// The i-th pixel of an 8x8 tile, row by row; false outside the screen.
bool is_edge(uint tile, uint i) {
  const uvec2 extent = uvec2(params.width, params.height);
  const uint across = edge_tiles_across();
  const uvec2 at = uvec2(tile % across, tile / across) * kEdgeTileSide + uvec2(i % kEdgeTileSide, i / kEdgeTileSide);
  if (!on_screen(at, extent)) return false;
  const uint samples = clamp(params.samples, 1u, kMaxSamples);
  const uint place = (at.y * extent.x + at.x) * samples;
  const Surface first = surface_of(place);
#ifdef MUTANT_4  // the last sample is not looked at
  for (uint s = 1u; s + 1u < samples; ++s)
#else
  for (uint s = 1u; s < samples; ++s)
#endif
    if (differ(first, surface_of(place + s))) return true;
  if (params.neighbours == 0u) return false;
#ifdef MUTANT_5  // at the right edge of the screen, the neighbour is the next row's first pixel
  if (at.x + 1u < extent.x || at.y + 1u < extent.y) {
#else
  if (at.x + 1u < extent.x) {
#endif
    if (differ(first, surface_of(place + samples))) return true;
  }
  return at.y + 1u < extent.y && differ(first, surface_of(place + samples * extent.x));
}
