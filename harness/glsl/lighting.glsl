// The one shading model, for surfaces, particles and the forward baselines alike: Lambert and GGX (Walter et al. 2007)
// with height-correlated Smith (Heitz 2014) and Schlick's Fresnel (1994), lit by punctual lights. Its bounds are in
// kernels/deferred_lighting/README.md. The includer draws in no port; lights and surfaces are arguments.
#ifndef HARNESS_GLSL_LIGHTING
#define HARNESS_GLSL_LIGHTING
#include "harness/formats/lighting.h"

const float kInversePi = 0.318309886184;

struct Surface {
  vec3 position;  // relative to the camera, metres
  vec3 normal;    // unit
  vec3 to_eye;    // unit
  vec3 albedo;    // of the diffuse lobe
  vec3 f0;        // reflectance at normal incidence
  vec3 sheen;     // added to the albedo at grazing light
  vec3 wrap;      // how far past the terminator diffuse light reaches, a cosine
  vec3 unwrap;    // 1 / (1 + wrap)^2
  float through;  // share of diffuse light that comes out on the other side
  float alpha;    // GGX: perceptual roughness squared
  float n_dot_v;
  float smith_v;  // sqrt(alpha^2 + (1 - alpha^2) n_dot_v^2)
};

struct Incoming {
  vec3 direction;  // towards the light, unit
  vec3 radiance;   // irradiance of a surface across it
};

bool is_finite(float v) { return (floatBitsToUint(v) & 0x7f800000u) != 0x7f800000u; }
vec3 unit_or_shorter(vec3 v) { return v * inversesqrt(max(dot(v, v), kShortestVector * kShortestVector)); }

float smith_root(float cosine, float alpha) {
  const float a2 = alpha * alpha;
  return sqrt(a2 + (1.0 - a2) * cosine * cosine);
}

// `metallic` of skin is its thickness, 1 being too thick to scatter (formats/gbuffer.h).
Surface make_surface(vec3 position, vec3 normal, vec3 to_eye, vec3 base_colour, float metallic, float roughness,
                     uint features) {
  Surface s;
  s.position = position;
  s.normal = normal;
  s.to_eye = to_eye;
  const bool skin = (features & kFeatureSkin) != 0u;
  s.wrap = skin ? (1.0 - metallic) * vec3(kSkinWrapRed, kSkinWrapGreen, kSkinWrapBlue) : vec3(0.0);
  s.unwrap = 1.0 / ((1.0 + s.wrap) * (1.0 + s.wrap));
  const float metal = skin ? 0.0 : metallic;
  s.albedo = base_colour * (1.0 - metal);
  s.f0 = kDielectricReflectance * (1.0 - metal) + base_colour * metal;
  s.sheen = (features & kFeatureCloth) != 0u ? kClothSheen * base_colour : vec3(0.0);
  s.through = (features & kFeatureSubsurface) != 0u ? kLeafThrough : 0.0;
#if defined(MUTANT_9201)  // the highlight of a mirror has no width
  const float rough = roughness;
#else
  const float rough = max(roughness, kMinimumRoughness);
#endif
#ifdef MUTANT_9202  // perceptual roughness taken for GGX's
  s.alpha = rough;
#else
  s.alpha = rough * rough;
#endif
  s.n_dot_v = max(dot(normal, to_eye), kLeastNormalDotView);
  s.smith_v = smith_root(s.n_dot_v, s.alpha);
  return s;
}

// 1 - (d / range)^4, at least 0. No range, or one that is no number, is unlimited.
float range_window(float distance2, float range) {
  if (!(range > 0.0)) return 1.0;
  const float q = distance2 / (range * range);
#ifdef MUTANT_9203  // the square for the fourth power
  return q < 1.0 ? 1.0 - q : 0.0;
#else
  return q < 1.0 ? 1.0 - q * q : 0.0;
#endif
}

float cone_window(float cosine, LightRecord light) {
  const float t = cosine * light.cone_scale + light.cone_offset;
  if (!is_finite(t) || t <= 0.0) return 0.0;
  const float edge = min(t, 1.0);
#ifdef MUTANT_9204  // linear
  return edge;
#else
  return edge * edge;
#endif
}

// What arrives at a position from a light; nothing (or no number) from one of a kind that does not exist.
Incoming light_at(vec3 position, LightRecord light) {
  if (light.kind == kLightDirectional) return Incoming(-light.direction, light.colour);
  const vec3 to_light = light.position - position;
  const float distance2 = max(dot(to_light, to_light), kShortestVector * kShortestVector);
  const vec3 direction = to_light * inversesqrt(distance2);
#ifdef MUTANT_9205  // no least distance
  float share = range_window(distance2, light.range) / distance2;
#else
  float share = range_window(distance2, light.range) / max(distance2, kLeastLightDistance * kLeastLightDistance);
#endif
  if (light.kind == kLightSpot) share *= cone_window(-dot(direction, light.direction), light);
#ifndef MUTANT_9206  // an unknown kind shines as a point
  if (light.kind > kLightSpot) share = 0.0;
#endif
  return Incoming(direction, light.colour * share);
}

// D and V of the microfacets, without Fresnel. With sine and cosine of the angle between normal and half vector, D =
// alpha^2 / (pi (sine^2 + alpha^2 cosine^2)^2). The sine is a cross product: 1 - cosine^2 would cancel, and leaves
// no digit of an alpha^2 of 4e-6 (Karis, Lagarde; Filament's documentation, 2018). The sum is alpha^2 at least, for
// unit vectors.
float microfacets(Surface s, vec3 h, float n_dot_l) {
  const vec3 across = cross(s.normal, h);
  const float scaled_cosine = s.alpha * dot(s.normal, h);
#ifdef MUTANT_9207  // the form that cancels
  const float cosine = dot(s.normal, h);
  const float sum = cosine * cosine * (s.alpha * s.alpha - 1.0) + 1.0;
#else
  const float sum = dot(across, across) + scaled_cosine * scaled_cosine;
#endif
  const float k = s.alpha / max(sum, s.alpha * s.alpha);
  const float smith_l = smith_root(n_dot_l, s.alpha);
#ifdef MUTANT_9208  // each root with its own cosine
  const float visibility = 0.5 / (n_dot_l * smith_l + s.n_dot_v * s.smith_v);
#else
  const float visibility = 0.5 / (n_dot_l * s.smith_v + s.n_dot_v * smith_l);
#endif
  return k * k * kInversePi * visibility;
}

// Light that leaves towards the eye, of what comes in.
vec3 reflected(Surface s, Incoming light) {
  const float n_dot_l = dot(s.normal, light.direction);
  // Wrapped diffuse light, normalised (Green 2004; the square keeps its energy): with no wrap max(n_dot_l, 0).
  const vec3 wrapped = max(vec3(n_dot_l) + s.wrap, 0.0) * s.unwrap;
  vec3 sum = s.albedo * (wrapped + s.through * max(-n_dot_l, 0.0)) * kInversePi;
#ifdef MUTANT_9209  // light from behind shines
  if (n_dot_l != 0.0) {
#else
  if (n_dot_l > 0.0) {
#endif
    const vec3 h = unit_or_shorter(light.direction + s.to_eye);
    const float v_dot_h = clamp(dot(s.to_eye, h), 0.0, 1.0);
#ifdef MUTANT_9210  // Fresnel of the normal's angle
    const float c = 1.0 - clamp(dot(s.normal, h), 0.0, 1.0);
#else
    const float c = 1.0 - v_dot_h;
#endif
    const float c5 = c * c * (c * c) * c;
    const vec3 fresnel = s.f0 + (1.0 - s.f0) * c5;
    // The sheen is Burley's (2012): (1 - v.h)^5 times a tint.
    sum += (s.sheen * c5 * kInversePi + microfacets(s, h, n_dot_l) * fresnel) * n_dot_l;
  }
  return sum * light.radiance;
}

// Of one light, of which the share `visible` arrives. A contribution that is no finite number (the light was none, or
// overflows) is dropped.
vec3 shade(Surface s, LightRecord light, float visible) {
  Incoming incoming = light_at(s.position, light);
  incoming.radiance *= visible;
  const vec3 c = reflected(s, incoming);
#ifdef MUTANT_9211
  return c;
#else
  return is_finite(c.r + c.g + c.b) ? c : vec3(0.0);
#endif
}

// Under equal radiance from everywhere: both lobes, the specular one as if it were rough.
vec3 shade_ambient(Surface s, vec3 ambient) { return ambient * (s.albedo + s.f0); }

// What an image of halves may hold: NaN is 0.
vec3 storable(vec3 radiance) {
  const vec3 r = radiance;
  return vec3(r.r > 0.0 ? min(r.r, kGreatestRadiance) : 0.0, r.g > 0.0 ? min(r.g, kGreatestRadiance) : 0.0,
              r.b > 0.0 ? min(r.b, kGreatestRadiance) : 0.0);
}
#endif
