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

#include "harness/glsl/interpolation/shown.glsl"

bool clip_sample_at(uvec2 pixel, out Shown t) {
  const uint i = pixel.y * params.width + pixel.x;
  if (i >= params.clip_samples) return false;
  const ClipSample s = clip_samples[i];
  t.triangle.corners = vec3[3](s.v0, s.v1, s.v2);
  place(t.triangle, s.pixel, s.viewport);
  t.flipped = false;
  return true;
}

bool triangle_at(uvec2 pixel, out Shown t) {
  if (params.clip_samples > 0u) return clip_sample_at(pixel, t);
  return shown_at(pixel, texelFetch(visibility, ivec2(pixel), 0).xy, t);
}

TangentFrame frame_at(Shown t, vec3 weights) {
  if (params.clip_samples > 0u) return TangentFrame(vec3(0, 0, 1), vec3(1, 0, 0), false);
  const VertexAttributes v[3] =
      VertexAttributes[3](attributes[t.vertices.x], attributes[t.vertices.y], attributes[t.vertices.z]);
  return frame_of(surfaces[t.surface], t.flipped, v, weights);
}
