// Materials sampled, and what each shader class (formats/material.h) makes of its own: a step a class. A shader holds
// the steps that it asks for, HAS_CLOTH for one or HAS_EVERY_CLASS.
#ifndef DEFERRED_TEXTURING_CLASSES
#define DEFERRED_TEXTURING_CLASSES
#ifdef HAS_EVERY_CLASS
#define HAS_MASKED
#define HAS_TWO_LAYER
#define HAS_EMISSIVE_DETAIL
#define HAS_CLOTH
#define HAS_SKIN
#define HAS_WET
#define HAS_FOLIAGE
#endif
#include "kernels/deferred_texturing/footprint.glsl"
#define TEXTURES_SLOT 8
#include "harness/glsl/textures.glsl"

struct Layer {
  vec3 base;        // linear
  float roughness;  // perceptual
  vec3 normal;      // tangent space, of any length
  float metallic;
  vec3 emissive;  // radiance
  float occlusion;
  float height;
};

vec4 sampled(uint name, Footprint f) { return texture_with_gradients(name, f.uv, f.d_dx, f.d_dy); }

// glTF 2.0's metallic-roughness material; the normal's z is derived.
Layer layer_of(MaterialRecord m, Footprint f) {
  const vec4 surface = sampled(m.metallic_roughness_texture, f);
  Layer l;
  l.base = m.base_colour.rgb * sampled(m.base_texture, f).rgb;
#ifdef MUTANT_8  // metallic and roughness change places
  l.roughness = m.roughness * surface.b;
  l.metallic = m.metallic * surface.g;
#else
  l.roughness = m.roughness * surface.g;
  l.metallic = m.metallic * surface.b;
#endif
  l.height = surface.a;
  l.emissive = m.emissive * sampled(m.emissive_texture, f).rgb;
#ifdef MUTANT_9  // the strength is a factor
  l.occlusion = m.occlusion_strength * sampled(m.occlusion_texture, f).r;
#else
  const float strength = m.occlusion_strength > 0.0 ? min(m.occlusion_strength, 1.0) : 0.0;  // NaN is 0
  l.occlusion = 1.0 + strength * (sampled(m.occlusion_texture, f).r - 1.0);
#endif
  l.normal = vec3(0, 0, 1);
  if (m.normal_texture != kNoTexture) {
    const vec2 xy = 2.0 * sampled(m.normal_texture, f).rg - 1.0;
#ifdef MUTANT_10  // z is scaled too
    l.normal = m.normal_scale * vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
#else
    l.normal = vec3(m.normal_scale * xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
#endif
  }
  return l;
}

// The one texture that a class reads beside its layers': the detail, at its own scale, or the mask.
vec4 extra_of(uint shader, MaterialRecord m, Footprint f) {
  const bool is_detail = shader == kShaderEmissiveDetail || shader == kShaderCloth;
  if (!is_detail && shader != kShaderTwoLayer && shader != kShaderSkin && shader != kShaderWet) return vec4(1);
#if !(defined(HAS_EMISSIVE_DETAIL) || defined(HAS_CLOTH)) || defined(MUTANT_11)  // the detail's scale is forgotten
  const float scale = 1.0;
#else
  const float scale = is_detail ? m.detail_scale : 1.0;
#endif
  return sampled(is_detail ? m.detail_texture : m.mask_texture,
                 footprint(scale * f.uv, scale * f.d_dx, scale * f.d_dy));
}

#ifdef HAS_TWO_LAYER
// Mishkinis 2013, Advanced Terrain Texture Splatting: of two heights raised by their shares, the higher wins, and where
// they differ by less than `depth` they mix. The upper layer's weight.
float upper_weight(float lower_height, float upper_height, float mask, float depth) {
#ifdef MUTANT_12  // heights do not count
  const float lower = 1.0 - mask, upper = mask;
#else
  const float lower = lower_height + (1.0 - mask), upper = upper_height + mask;
#endif
  const float base = max(lower, upper) - depth;
  const float a = max(lower - base, 0.0), b = max(upper - base, 0.0);
#ifdef MUTANT_13  // the lower layer on top
  return a / (a + b);
#else
  return b / (a + b);
#endif
}
// As integers, for which NaN has a place too: beyond the largest, or below zero.
float usable_depth(float depth) {
  return intBitsToFloat(
      clamp(floatBitsToInt(depth), floatBitsToInt(kLeastBlendDepth), floatBitsToInt(kLargestBlendDepth)));
}
void blend_layers(inout Layer l, Layer top, float mask, float depth) {
  const float w = upper_weight(l.height, top.height, mask, usable_depth(depth));
  l.base = mix(l.base, top.base, w);
  l.roughness = mix(l.roughness, top.roughness, w);
  l.normal = mix(l.normal, top.normal, w);
  l.metallic = mix(l.metallic, top.metallic, w);
  l.emissive = mix(l.emissive, top.emissive, w);
  l.occlusion = mix(l.occlusion, top.occlusion, w);
}
#endif

#ifdef HAS_EMISSIVE_DETAIL
void add_detail(inout Layer l, vec3 detail) {
  l.base *= detail;
#ifndef MUTANT_15  // emission without its detail
  l.emissive *= detail;
#endif
}
#endif

#ifdef HAS_CLOTH
// Threads that stand high are as smooth as the material; between them the cloth is rough.
#ifdef MUTANT_16  // threads are rough and gaps smooth
void weave(inout Layer l, float height) { l.roughness = mix(l.roughness, 1.0, height); }
#else
void weave(inout Layer l, float height) { l.roughness = mix(1.0, l.roughness, height); }
#endif
#endif

#ifdef HAS_SKIN
// Skin is no metal: the channel holds its thickness (formats/gbuffer.h).
#ifdef MUTANT_17  // thickness of metal
void thicken(inout Layer l, float thickness) { l.metallic *= thickness; }
#else
void thicken(inout Layer l, float thickness) { l.metallic = thickness; }
#endif
#endif

#ifdef HAS_WET
// Lagarde 2013, Water drop 3b, Physically based wet surfaces: rough dielectrics are porous, and water in their pores
// darkens and smooths them.
void soak(inout Layer l, float wetness) {
  const float porosity = clamp((l.roughness - 0.5) / 0.4, 0.0, 1.0);
#ifdef MUTANT_18  // metal has pores
  const float soaked = mix(1.0, 0.2, porosity);
#else
  const float soaked = mix(1.0, 0.2, (1.0 - l.metallic) * porosity);
#endif
  l.base *= mix(1.0, soaked, wetness);
#ifndef MUTANT_19  // water does not smooth
  l.roughness *= mix(1.0, soaked, 0.5 * wetness);
#endif
}
#endif

#ifdef HAS_FOLIAGE
// O'Neill 2014, PCG: the output permutation as a hash.
uint hash(uint x) {
  x = x * 747796405u + 2891336453u;
  x = ((x >> ((x >> 28) + 4u)) ^ x) * 277803737u;
  return x >> 22 ^ x;
}
void tint(inout Layer l, uint surface) {
  l.base *= mix(kFoliageTint, vec3(1), float(hash(surface) >> 24) / 255.0);
}
#endif

// `shader` is a constant of a class's own shader.
Layer layer_of_class(uint shader, MaterialRecord m, Footprint f, uint surface) {
#ifdef HAS_TWO_LAYER
#ifdef MUTANT_14  // one layer too many
  const bool has_top = shader == kShaderTwoLayer && m.layer <= params.materials;
#else
  const bool has_top = shader == kShaderTwoLayer && m.layer < params.materials;
#endif
  // A loop, of one turn or two, that holds the code of a layer once.
  Layer l, top;
  MaterialRecord record = m;
  for (uint i = 0u; i < (has_top ? 2u : 1u); ++i) {
    top = layer_of(record, f);
    if (i == 0u) l = top;
    if (has_top) record = materials[m.layer];
  }
#else
  Layer l = layer_of(m, f);
#endif
  const vec4 extra = extra_of(shader, m, f);
  switch (shader) {
#ifdef HAS_TWO_LAYER
    case kShaderTwoLayer:
      if (has_top) blend_layers(l, top, extra.r, m.blend_depth);
      break;
#endif
#ifdef HAS_EMISSIVE_DETAIL
    case kShaderEmissiveDetail: add_detail(l, extra.rgb); break;
#endif
#ifdef HAS_CLOTH
    case kShaderCloth: weave(l, extra.r); break;
#endif
#ifdef HAS_SKIN
    case kShaderSkin: thicken(l, extra.r); break;
#endif
#ifdef HAS_WET
    case kShaderWet: soak(l, extra.r); break;
#endif
#ifdef HAS_FOLIAGE
#ifdef MUTANT_20  // all instances have one tint
    case kShaderFoliage: tint(l, m.features); break;
#else
    case kShaderFoliage: tint(l, surface); break;
#endif
#endif
  }
  return l;
}
#endif
