// Where a decal's rectangle of the atlas is sampled, and over how much of it; isotropic and trilinear. No tap leaves
// the rectangle and its border: levels end where their alignment ends, for the atlas has no more of them, and coordinates
// keep half the footprint away from the border's sides.
#ifndef DECAL_ATLAS_SAMPLING_SAMPLE
#define DECAL_ATLAS_SAMPLING_SAMPLE
#include "kernels/decal_atlas_sampling/common.glsl"

#ifdef SAMPLE_BLOCKS
layout(binding = 10) uniform sampler2DArray atlas_blocks[3];
#define atlas atlas_blocks
#else
layout(binding = 10) uniform sampler2DArray atlas[3];
#endif

struct Sample {
  vec4 albedo;  // linear, coverage
  vec3 normal;  // tangent space
  float roughness;
};

struct Footprint {
  vec2 uv;
  vec2 d_dx;
  vec2 d_dy;
};

// NaN is no less than anything, for integers are compared.
float usable(float x) {
  return (floatBitsToUint(x) & 0x7fffffffu) < floatBitsToUint(kLargestGradient) ? x : kLargestGradient;
}
vec2 usable(vec2 v) { return vec2(usable(v.x), usable(v.y)); }

vec2 atlas_size() { return vec2(textureSize(atlas[kAtlasAlbedo], 0).xy); }

// Texels that a device takes into account at most, by derivatives in texels.
float widest_rho(vec2 d_dx, vec2 d_dy) {
  return kWidestRho * max(abs(d_dx.x) + abs(d_dx.y), abs(d_dy.x) + abs(d_dy.y));
}

// Level l takes in half a texel of its own to either side, 2^l / 2 of the first level's, and 2^l <= max(1, 2 rho).
vec2 held_inside(vec2 uv, vec4 scale_bias, float rho) {
  const float last = float(1u << (textureQueryLevels(atlas[kAtlasAlbedo]) - 1)) * 0.5;
#ifdef MUTANT_4  // coordinates go up to the rectangle's sides
  const vec2 inset = vec2(0.0);
#elif defined(MUTANT_5)  // half a texel of the first level, whatever the level is
  const vec2 inset = max(kInset * 0.5 - params.atlas_border, 0.0) / atlas_size();
#else
  const vec2 inset = max(kInset * min(max(rho, 0.5), last) - params.atlas_border, 0.0) / atlas_size();
#endif
  const vec2 half_size = 0.5 * abs(scale_bias.xy), centre = scale_bias.zw + 0.5 * scale_bias.xy;
  const vec2 room = max(half_size - inset, 0.0);
  return min(max(uv, centre - room), centre + room);
}

vec3 normal_of(vec2 xy) {
  const vec2 n = 2.0 * xy - 1.0;
  return vec3(n, sqrt(max(1.0 - dot(n, n), 0.0)));
}

#if defined(SAMPLE_LEVEL)
// The level worked out here: the longer derivative, by Euclid.
Sample sample_of(DecalRecord d, Footprint f) {
  const vec2 size = atlas_size(), dx = f.d_dx * size, dy = f.d_dy * size;
#ifdef MUTANT_6  // only the way across is minified
  const float level = 0.5 * log2(max(dot(dx, dx), 1e-12));
#else
  const float level = 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1e-12));
#endif
  const vec3 at = vec3(held_inside(f.uv, d.scale_bias, widest_rho(dx, dy)), float(d.page));
  return Sample(textureLod(atlas[kAtlasAlbedo], at, level), normal_of(textureLod(atlas[kAtlasNormal], at, level).rg),
                textureLod(atlas[kAtlasRoughness], at, level).r);
}
#elif defined(SAMPLE_TAPS)
// Samples side by side along the longer derivative, each as wide as the shorter, or as its share of the longer
// (McCormack et al. 1999, Feline). Four turns.
Sample sample_of(DecalRecord d, Footprint f) {
  const vec2 size = atlas_size(), dx = f.d_dx * size, dy = f.d_dy * size;
  const float x2 = dot(dx, dx), y2 = dot(dy, dy);
  const bool is_x = x2 >= y2;
  const float taps = float(kAnisotropicTaps);
  const float width = sqrt(max(min(x2, y2), max(x2, y2) / (taps * taps)));
  const float level = log2(max(width, 1e-6));
#ifdef MUTANT_7  // along the shorter
  const vec2 along = is_x ? f.d_dy : f.d_dx;
#else
  const vec2 along = is_x ? f.d_dx : f.d_dy;
#endif
  vec4 albedo = vec4(0.0);
  vec2 xy = vec2(0.0);
  float roughness = 0.0;
  for (uint i = 0u; i < kAnisotropicTaps; ++i) {
    const vec2 uv = f.uv + along * ((float(i) + 0.5) / taps - 0.5);
    const vec3 at = vec3(held_inside(uv, d.scale_bias, kWidestRho * width), float(d.page));
    albedo += textureLod(atlas[kAtlasAlbedo], at, level) / taps;
    xy += textureLod(atlas[kAtlasNormal], at, level).rg / taps;
    roughness += textureLod(atlas[kAtlasRoughness], at, level).r / taps;
  }
  return Sample(albedo, normal_of(xy), roughness);
}
#else
Sample sample_of(DecalRecord d, Footprint f) {
  const vec2 size = atlas_size();
  const vec3 at = vec3(held_inside(f.uv, d.scale_bias, widest_rho(f.d_dx * size, f.d_dy * size)), float(d.page));
  return Sample(textureGrad(atlas[kAtlasAlbedo], at, f.d_dx, f.d_dy),
                normal_of(textureGrad(atlas[kAtlasNormal], at, f.d_dx, f.d_dy).rg),
                textureGrad(atlas[kAtlasRoughness], at, f.d_dx, f.d_dy).r);
}
#endif
#endif
