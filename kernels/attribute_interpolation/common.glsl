// What every variant binds, which triangle a pixel shows, and where its corners are.
#include "harness/glsl/interpolation/frame.glsl"
#include "harness/glsl/ports.glsl"
#include "kernels/attribute_interpolation/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform utexture2D visibility;
READS(1, vec3, positions);
READS(2, VertexAttributes, attributes);
READS(3, uint, indices);
READS(4, SurfaceRecord, surfaces);
READS(5, ClipSample, clip_samples);
PARAMS(AttributeParams);

struct Seen {
  Triangle triangle;
  bool has_attributes;
  bool flipped;  // the transform mirrors
  uint surface;
  uvec3 vertices;
};

uint clamped(uint i, uint count) { return min(i, count - 1u); }

bool clip_sample_at(uvec2 pixel, out Seen t) {
  const uint i = pixel.y * params.width + pixel.x;
  if (i >= params.clip_samples) return false;
  const ClipSample s = clip_samples[i];
  t.triangle.corners = vec3[3](s.v0, s.v1, s.v2);
  place(t.triangle, s.pixel, s.viewport);
  t.has_attributes = false;
  t.flipped = false;
  return true;
}

bool triangle_at(uvec2 pixel, out Seen t) {
  if (params.clip_samples > 0u) return clip_sample_at(pixel, t);
  const uvec2 shown = texelFetch(visibility, ivec2(pixel), 0).xy;
#ifdef MUTANT_3
  if (shown.y == kVisibilityNone) return false;
#else
  if (shown == uvec2(kVisibilityNone)) return false;
#endif
  if (params.surfaces == 0u || params.indices == 0u || params.vertices == 0u) return false;
#ifdef MUTANT_4
  t.surface = clamped(shown.y & ~kVisibilityFlipped, params.surfaces);
#else
  t.surface = clamped(shown.y & kVisibilitySurfaceMask, params.surfaces);
#endif
  const SurfaceRecord s = surfaces[t.surface];
  for (uint k = 0u; k < 3u; ++k) {
    const uint index = indices[clamped(s.first_index + 3u * shown.x + k, params.indices)];
#ifdef MUTANT_5
    t.vertices[k] = clamped(index, params.vertices);
#else
    t.vertices[k] = clamped(index + s.vertex_offset, params.vertices);
#endif
    t.triangle.corners[k] = corner_of(s, positions[t.vertices[k]]);
  }
  place(t.triangle, pixel, uvec2(params.width, params.height));
  t.has_attributes = true;
  t.flipped = (shown.y & kVisibilityFlipped) != 0u;
  return true;
}

TangentFrame frame_at(Seen t, vec3 weights) {
  if (!t.has_attributes) return TangentFrame(vec3(0, 0, 1), vec3(1, 0, 0), false);
  const VertexAttributes v[3] =
      VertexAttributes[3](attributes[t.vertices.x], attributes[t.vertices.y], attributes[t.vertices.z]);
  return frame_of(surfaces[t.surface], t.flipped, v, weights);
}
