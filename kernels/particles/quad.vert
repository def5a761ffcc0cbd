#version 460
// A particle's two triangles. Those of a quad that reaches before the near plane are the whole screen: its fragments
// find their place on it themselves, and nothing has to be clipped there.
#include "kernels/particles/common.glsl"
#define SIDE out
#include "kernels/particles/passed.glsl"

const vec4 kNowhere = vec4(0.0, 0.0, 0.0, 1.0);  // six vertices there have no area

vec4 position(ParticleRecord p, vec2 at) {
  // What the corners' w may be off by, and some: 2 x 10^-6 of the coordinates, 34 u.
  const float slack = 2e-6 * (largest(p.centre) + largest(p.right) + largest(p.up));
  const float middle = dot(params.clip_w, p.centre),
              reach = abs(dot(params.clip_w, p.right)) + abs(dot(params.clip_w, p.up));
  if (middle + reach < params.near_plane - slack) return kNowhere;
#ifdef MUTANT_2  // quads through the near plane are left out
  if (middle - reach < params.near_plane + slack) return kNowhere;
#else
  if (middle - reach < params.near_plane + slack) return vec4(at, 0.5, 1.0);
#endif
  const vec3 point = particle_position(p, at);
  const float w = dot(params.clip_w, point);
  return vec4(dot(params.clip_x, point), dot(params.clip_y, point), 0.5 * w, w);
}

void main() {
  const uint vertex = gl_VertexIndex % kVertices;
  entry_particle = uvec2(gl_VertexIndex / kVertices, order[gl_VertexIndex / kVertices]);
  gl_Position = kNowhere;
  row_x = row_y = normal = albedo = vec3(0.0);
  centre_normal = 0.0;
  opacity_softness = vec2(0.0);
  if (entry_particle.y >= params.particles) return;
  const ParticleRecord p = particles[entry_particle.y];
  if (!is_drawn(p)) return;
  gl_Position = position(p, corner(vertex < 3u ? vertex : vertex == 3u ? 0u : vertex - 2u));
  row_x = cross(p.up, p.centre);
  row_y = cross(p.centre, p.right);
  normal = cross(p.right, p.up);
  centre_normal = dot(p.centre, normal);
  albedo = p.albedo;
  opacity_softness = vec2(min(p.opacity, 1.0), p.softness);
}
