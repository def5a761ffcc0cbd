#version 460
// Each pixel's surface, and the place on the first particle that is as far across and down it, lit by all lights: the
// sums that deferred_lighting and particle_light_atlas round as they store them.
#include "kernels/deferred_lighting/common.glsl"
#include "harness/glsl/particle_surface.glsl"
#include "harness/glsl/particles.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
READS(8, ParticleRecord, particles);
WRITES(9, vec3, as_surface);
WRITES(10, vec3, as_particle);

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  store_background(pixel);
  Lit lit = start(pixel, depth_at(pixel));
  const ParticleRecord p = particles[0];
  const Surface s = particle_surface(p, particle_position(p, place_on_quad(pixel, params.width)));
  vec3 sum = shade_ambient(s, params.ambient);
  for (uint i = 0u; i < light_count(); ++i) {
    lit.radiance += lit_by(lit, lights[i]);
    sum += shade(s, lights[i], 1.0);
  }
  as_surface[pixel.y * params.width + pixel.x] = lit.radiance;
  as_particle[pixel.y * params.width + pixel.x] = sum;
}
