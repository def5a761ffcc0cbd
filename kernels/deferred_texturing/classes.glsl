// Materials sampled, and what each shader class (formats/material.h) makes of its own: one function a class.
#ifndef DEFERRED_TEXTURING_CLASSES
#define DEFERRED_TEXTURING_CLASSES
#include "kernels/deferred_texturing/common.glsl"

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
  l.roughness = m.roughness * surface.g;
  l.metallic = m.metallic * surface.b;
  l.height = surface.a;
  l.emissive = m.emissive * sampled(m.emissive_texture, f).rgb;
  l.occlusion = 1.0 + m.occlusion_strength * (sampled(m.occlusion_texture, f).r - 1.0);
  l.normal = vec3(0, 0, 1);
  if (m.normal_texture != kNoTexture) {
    const vec2 xy = 2.0 * sampled(m.normal_texture, f).rg - 1.0;
    l.normal = vec3(m.normal_scale * xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
  }
  return l;
}

float mask_of(MaterialRecord m, Footprint f) { return sampled(m.mask_texture, f).r; }
vec3 detail_of(MaterialRecord m, Footprint f) {
  return sampled(m.detail_texture, footprint(m.detail_scale * f.uv, m.detail_scale * f.d_dx, m.detail_scale * f.d_dy))
      .rgb;
}

Layer opaque_layer(MaterialRecord m, Footprint f, uint surface) { return layer_of(m, f); }
Layer masked_layer(MaterialRecord m, Footprint f, uint surface) { return layer_of(m, f); }

// Mishkinis 2013, Advanced Terrain Texture Splatting: of two heights raised by their shares, the higher wins, and where
// they differ by less than `depth` they mix. The upper layer's weight.
float upper_weight(float lower_height, float upper_height, float mask, float depth) {
  const float lower = lower_height + (1.0 - mask), upper = upper_height + mask;
  const float base = max(lower, upper) - depth;
  const float a = max(lower - base, 0.0), b = max(upper - base, 0.0);
  return b / (a + b);
}
// As integers, for which NaN has a place too: beyond the largest, or below zero.
float usable_depth(float depth) {
  return intBitsToFloat(
      clamp(floatBitsToInt(depth), floatBitsToInt(kLeastBlendDepth), floatBitsToInt(kLargestBlendDepth)));
}
Layer two_layer_layer(MaterialRecord m, Footprint f, uint surface) {
  Layer l = layer_of(m, f);
  if (m.layer >= params.materials) return l;
  const Layer top = layer_of(materials[m.layer], f);
  const float w = upper_weight(l.height, top.height, mask_of(m, f), usable_depth(m.blend_depth));
  l.base = mix(l.base, top.base, w);
  l.roughness = mix(l.roughness, top.roughness, w);
  l.normal = mix(l.normal, top.normal, w);
  l.metallic = mix(l.metallic, top.metallic, w);
  l.emissive = mix(l.emissive, top.emissive, w);
  l.occlusion = mix(l.occlusion, top.occlusion, w);
  return l;
}

Layer emissive_detail_layer(MaterialRecord m, Footprint f, uint surface) {
  Layer l = layer_of(m, f);
  const vec3 detail = detail_of(m, f);
  l.base *= detail;
  l.emissive *= detail;
  return l;
}

Layer cloth_layer(MaterialRecord m, Footprint f, uint surface) {
  Layer l = layer_of(m, f);
  l.roughness = mix(1.0, l.roughness, detail_of(m, f).r);
  return l;
}

Layer skin_layer(MaterialRecord m, Footprint f, uint surface) {
  Layer l = layer_of(m, f);
  l.metallic = mask_of(m, f);
  return l;
}

// Lagarde 2013, Water drop 3b, Physically based wet surfaces: rough dielectrics are porous, and water in their pores
// darkens and smooths them.
Layer wet_layer(MaterialRecord m, Footprint f, uint surface) {
  Layer l = layer_of(m, f);
  const float wetness = mask_of(m, f);
  const float porosity = clamp((l.roughness - 0.5) / 0.4, 0.0, 1.0);
  const float soaked = mix(1.0, 0.2, (1.0 - l.metallic) * porosity);
  l.base *= mix(1.0, soaked, wetness);
  l.roughness *= mix(1.0, soaked, 0.5 * wetness);
  return l;
}

// O'Neill 2014, PCG: its output permutation as a hash of the surface.
uint hash(uint x) {
  x = x * 747796405u + 2891336453u;
  x = ((x >> ((x >> 28) + 4u)) ^ x) * 277803737u;
  return x >> 22 ^ x;
}
Layer foliage_layer(MaterialRecord m, Footprint f, uint surface) {
  Layer l = layer_of(m, f);
  l.base *= mix(kFoliageTint, vec3(1), float(hash(surface) >> 24) / 255.0);
  return l;
}
#endif
