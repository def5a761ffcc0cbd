// What every variant binds, and all of a texel but its loop over the lights and its encoding. SHADOWED: lights with
// views in the shadow atlas shed what it lets through.
#include "harness/glsl/particle_surface.glsl"
#include "harness/glsl/particles.glsl"
#include "harness/glsl/ports.glsl"
#include "harness/glsl/radiance_encodings.glsl"
#include "kernels/particle_light_atlas/layout.h"
#include "harness/glsl/tiles.glsl"

READS(0, ParticleRecord, particles);
READS(1, uint, rects);
READS(2, uint, blocks);
READS(3, ParticleRectCounts, counts);
READS(4, LightRecord, lights);
layout(binding = 6, rg16_snorm) uniform writeonly restrict image2D direction;
PARAMS(ParticleLightParams);
#ifdef SHADOWED
READS(14, ShadowView, shadow_views);
layout(binding = 15) uniform texture2D shadow_depth;
#define SHADOW_VIEWS params.shadow_views
#define SHADOW_EXTENT uvec2(params.shadow_width, params.shadow_height)
#define SHADOW_FILTER 3
#include "harness/glsl/shadows.glsl"
#endif

const uint kTexels = kLightBlockSide * kLightBlockSide;  // of a block
layout(local_size_x = kTexels * kLightGroupBlocks) in;

uint light_count() { return min(params.lights, kMostLights); }

// A texel that is to be lit.
struct Texel {
  bool is_one;
  uint particle;
  uvec2 in_rect;
  uint side;  // of the rectangle
  uvec2 at;   // in the atlas
};

// Texels of a block in Morton order: four in a row are one texel of `direction`.
uvec2 in_block(uint i) {
  uvec2 at = uvec2(i, i >> 1u) & 0x15u;
  at = (at | at >> 1u) & 0x33u;
  return (at | at >> 2u) & 0x07u;
}

// The thread's. Whatever the words hold, it is within a rectangle of a particle within the atlas, or none.
Texel texel_of_thread() {
  const uint thread = gl_LocalInvocationID.x, i = spread_group() * kLightGroupBlocks + thread / kTexels;
#ifdef MUTANT_1  // the last block is left out
  if (i + 1u >= min(counts[0].blocks, params.blocks)) return Texel(false, 0u, uvec2(0u), 0u, uvec2(0u));
#else
  if (i >= min(counts[0].blocks, params.blocks)) return Texel(false, 0u, uvec2(0u), 0u, uvec2(0u));
#endif
  const uint particle = blocks[i] >> kLightBlockBits, block = blocks[i] & ((1u << kLightBlockBits) - 1u);
  Texel t = Texel(particle < params.particles, particle, uvec2(0u), 0u, uvec2(0u));
  if (!t.is_one) return t;
  const LightRect rect = light_rect(rects[particle]);
  const uint across = rect.side / kLightBlockSide;
#ifdef MUTANT_2  // blocks that the rectangle does not have
  t.is_one = rect.side != 0u && all(lessThanEqual(rect.corner + rect.side, uvec2(params.side)));
#else
  t.is_one = block < across * across && all(lessThanEqual(rect.corner + rect.side, uvec2(params.side)));
#endif
  if (!t.is_one) return t;
  t.side = rect.side;
  t.in_rect = uvec2(block % across, block / across) * kLightBlockSide + in_block(thread % kTexels);
  t.at = rect.corner + t.in_rect;
  return t;
}

struct Lit {
  Surface surface;
  vec3 radiance;  // so far
  vec3 towards;   // sum of the directions that it comes from, each times its luminance
  float dither;
};

bool is_within(vec3 v) { return all(lessThanEqual(abs(v), vec3(kMostReach))); }  // no NaN is

Lit start(Texel t) {
  ParticleRecord p = particles[t.particle];
  if (!is_within(p.centre) || !is_within(p.right) || !is_within(p.up))
    p.centre = p.right = p.up = vec3(0.0);
#ifdef MUTANT_5  // a texel's corner for its centre
  const vec2 at = place_on_quad(t.in_rect, t.side) - 1.0 / float(t.side);
#else
  const vec2 at = place_on_quad(t.in_rect, t.side);
#endif
  Lit lit;
  lit.surface = particle_surface(p, particle_position(p, at));
#ifdef MUTANT_6  // no ambient light
  lit.radiance = vec3(0.0);
#else
  lit.radiance = shade_ambient(lit.surface, params.ambient);
#endif
  lit.towards = vec3(0.0);
#ifdef SHADOWED
  lit.dither = shadow_dither(t.at, params.frame);
#endif
  return lit;
}

void add_light(inout Lit lit, uint light) {
  if (light >= light_count()) return;
  const LightRecord l = lights[light];
#ifdef SHADOWED
  const vec3 c = shade(lit.surface, l, shadow_at(l, lit.surface.position, vec3(0.0), lit.dither));
#else
  const vec3 c = shade(lit.surface, l, 1.0);
#endif
  lit.radiance += c;
#ifdef MUTANT_7  // all lights count the same
  const float weight = 1.0;
#else
  const float weight = min(dot(c, vec3(kLuminanceRed, kLuminanceGreen, kLuminanceBlue)), kMostWeight);
#endif
  if (weight > 0.0) lit.towards += weight * light_at(lit.surface.position, l).direction;
}

// Of the four texels of one of `direction`, whose threads are neighbours; all threads of the group come here.
shared vec3 towards[kTexels * kLightGroupBlocks];
void store_direction(Texel t, vec3 own) {
  const uint thread = gl_LocalInvocationID.x;
  towards[thread] = own;
  barrier();
  if (!t.is_one || thread % 4u != 0u) return;
#ifdef MUTANT_8  // of the first of them
  const vec3 sum = towards[thread];
#else
  const vec3 sum = (towards[thread] + towards[thread + 1u]) + (towards[thread + 2u] + towards[thread + 3u]);
#endif
  imageStore(direction, ivec2(t.at / 2u), vec4(encode_octahedral(sum), 0.0, 0.0));
}
