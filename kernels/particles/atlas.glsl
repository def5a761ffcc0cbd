// A particle's light out of the atlas; of one that has no rectangle ambient light alone.
#include "harness/glsl/particle_surface.glsl"
#include "harness/glsl/particles.glsl"
#include "kernels/particles/fragment.glsl"

READS(3, uint, rects);
layout(binding = 4) uniform texture2D atlas;

// A rectangle that does not lie in the atlas is none.
LightRect rect_of(uint word) {
  const LightRect r = light_rect(word);
#ifdef MUTANT_9  // whatever the atlas's size
  return r;
#else
  return all(lessThanEqual(r.corner + r.side, uvec2(params.atlas_side))) ? r : LightRect(uvec2(0), 0u);
#endif
}

// Texels past the rectangle's rim are those of the rim: what lies beside is another particle's.
vec3 texel(LightRect r, ivec2 at) {
#ifdef MUTANT_10  // the neighbours bleed in
  const ivec2 from = ivec2(r.corner) + at;
#else
  const ivec2 from = ivec2(r.corner) + clamp(at, ivec2(0), ivec2(r.side) - 1);
#endif
  return texelFetch(atlas, from, 0).rgb;
}

// In texels, a texel's centre at a whole number.
vec2 in_texels(LightRect r, vec2 at) {
#ifdef MUTANT_11  // half a texel off
  return (at * 0.5 + 0.5) * float(r.side);
#else
  return (at * 0.5 + 0.5) * float(r.side) - 0.5;
#endif
}

vec3 filtered(LightRect r, ivec2 first, vec2 f);

vec3 light_at(Place p) {
  const LightRect r = rect_of(rects[entry_particle.y]);
  if (r.side == 0u) {
#ifdef MUTANT_18  // it is black
    return vec3(0.0);
#else
    const ParticleRecord particle = particles[entry_particle.y];
    return shade_ambient(particle_surface(particle, particle.centre), params.ambient);
#endif
  }
  const vec2 at = in_texels(r, p.at), first = floor(at);
  return filtered(r, ivec2(first), at - first);
}
