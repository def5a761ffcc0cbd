// What interpolation finds at a pixel: as attribute_interpolation stored it, or, with INTERPOLATES, worked out on the
// spot by the same code.
#ifndef DEFERRED_TEXTURING_ATTRIBUTES
#define DEFERRED_TEXTURING_ATTRIBUTES
#include "kernels/deferred_texturing/footprint.glsl"

#ifdef INTERPOLATES
#include "harness/glsl/interpolation/compensated.glsl"
#include "harness/glsl/interpolation/frame.glsl"
READS(5, vec3, positions);

SurfaceAttributes attributes_at(uvec2 pixel, Visible visible, SurfaceRecord s) {
  Triangle t;
  VertexAttributes v[3];
  for (uint k = 0u; k < 3u; ++k) {
    const uint vertex = vertex_of(s, visible.triangle, k);
    t.corners[k] = corner_of(s, positions[vertex]);
    v[k] = vertices[vertex];
  }
  place(t, pixel, uvec2(params.width, params.height));
  const Interpolated i = interpolate_compensated(t);
#ifdef MUTANT_30  // the first vertex's frame for all of the triangle
  const TangentFrame f = frame_of(s, visible.flipped, v, vec3(1, 0, 0));
#else
  const TangentFrame f = frame_of(s, visible.flipped, v, i.weights);
#endif
#ifdef MUTANT_31  // a mirror does not turn the handedness
  const bool left_handed = f.left_handed;
#else
  const bool left_handed = f.left_handed != visible.flipped;
#endif
#ifdef MUTANT_32  // facing without regard to a mirror
  const bool front_facing = !i.clockwise;
#else
  const bool front_facing = i.clockwise == visible.flipped;
#endif
#ifdef MUTANT_33  // the way down changes as the way across does
  const vec4 d = i.derivatives.xyxy;
#else
  const vec4 d = i.derivatives;
#endif
  return SurfaceAttributes(i.weights, vec3(-d.x - d.y, d.xy), vec3(-d.z - d.w, d.zw), f.normal, f.tangent,
                           left_handed ? -1.0 : 1.0, front_facing);
}
#else
READS(5, uint, barycentrics);
READS(6, uvec2, derivatives);
READS(7, uvec2, tangent_frame);

SurfaceAttributes attributes_at(uvec2 pixel, Visible visible, SurfaceRecord s) {
  const uint i = pixel_number(pixel);
  return decode_attributes(barycentrics[i], derivatives[i], tangent_frame[i]);
}
#endif
#endif
