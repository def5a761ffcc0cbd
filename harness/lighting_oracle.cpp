#include "harness/lighting_oracle.h"

namespace assay::shading {

namespace {

const Interval kOverPi = bounded::rounded(exactly(1 / 3.14159265358979323846), 1);
// The lobes' factors are 2e11 at most (D 8e4, V 3e6), times the length of a direction that should be 1. Past these an
// infinity may appear on the way to a finite answer.
constexpr double kMayOverflow = 1e16, kLongDirection = 1e10;
constexpr double kFar = 1e18;  // metres; its square still is a float

bool finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
Interval one_minus(Interval a) { return exactly(1) - a; }
Colour colour(const vec3& v) { return {exactly(v.x), exactly(v.y), exactly(v.z)}; }
Colour colour(Interval i) { return {i, i, i}; }
constexpr Colour kBlack = {};

// Dielectrics reflect kDielectricReflectance and scatter their base colour; metals reflect it and scatter nothing.
Colour albedo(const OracleSurface& s, Interval metallic) { return s.base_colour * one_minus(metallic); }
Colour normal_reflectance(const OracleSurface& s, Interval metallic) {
  return colour(exactly(kDielectricReflectance) * one_minus(metallic)) + s.base_colour * metallic;
}
bool is_skin(const OracleSurface& s) { return (s.features & kFeatureSkin) != 0; }
Interval metalness(const OracleSurface& s) { return is_skin(s) ? exactly(0) : s.metallic; }

// Smith's root, sqrt(alpha^2 + (1 - alpha^2) cosine^2).
Interval smith(Interval cosine, Interval alpha) {
  const Interval a2 = square(alpha);
  return square_root(a2 + one_minus(a2) * cosine * cosine);
}

Interval range_window(Interval distance2, float range) {
  if (!(range > 0)) return exactly(1);
  const Interval q = distance2 / bounded::rounded(exactly(double{range} * double{range}), 1);
  const Interval window = at_least(one_minus(square(q)), 0);
  // A range so small that a device may take it for 0, unlimited.
  return range < 0x1p-126f ? hull(window, exactly(1)) : window;
}

Interval cone_window(Interval cosine, const LightRecord& light) {
  if (!finite(light.direction) || !std::isfinite(light.cone_scale) || !std::isfinite(light.cone_offset))
    return exactly(0);
  const Interval t = cosine * exactly(light.cone_scale) + exactly(light.cone_offset);
  const auto magnitude = [](Interval i) { return std::max(std::fabs(i.low), std::fabs(i.high)); };
  if (std::max(magnitude(t), magnitude(cosine)) > 1e37) return {0, 1};
  return square(clamped(t, 0, 1));
}

struct Arriving {
  Ball direction;
  Colour radiance;
};

Arriving arriving(const Ball& position, const LightRecord& light) {
  const vec3 &d = light.direction, &p = light.position;
  if (light.kind == kLightDirectional) return {{-glm::dvec3(d), 0}, colour(light.colour)};
  const Ball to_light = Ball{glm::dvec3(p), 0} - position;
  const Interval distance2 = at_least(length_squared(to_light), double{kShortestVector} * kShortestVector * (1 - 1e-6));
  const Ball direction = normalised(to_light, kShortestVector);
  const double least = double{kLeastLightDistance} * kLeastLightDistance;
  const Interval least2 = bounded::rounded(exactly(least), 1);
  Interval share =
      range_window(distance2, light.range) / hull(at_least(distance2, least2.low), at_least(distance2, least2.high));
  if (light.kind == kLightSpot) share = share * cone_window(-dot(direction, {glm::dvec3(d), 0}), light);
  if (reach(to_light) > kFar) share.low = 0;  // its square may overflow, which puts the light out
  return {direction, colour(light.colour) * share};
}

// D V of Walter et al. 2007 and Heitz 2014.
Interval microfacets(const OracleSurface& s, Interval alpha, Interval n_dot_v, Interval n_dot_l, const Ball& half) {
  const Interval sine2 = length_squared(cross(s.normal, half)), cosine = dot(s.normal, half);
  const Interval a2 = square(alpha);
  const Interval sum = sine2 + square(alpha * cosine);
  const Interval k = alpha / Interval{std::max(sum.low, a2.low), std::max(sum.high, a2.high)};
  const Interval shadowing = exactly(0.5) / (n_dot_l * smith(n_dot_v, alpha) + n_dot_v * smith(n_dot_l, alpha));
  return square(k) * kOverPi * shadowing;
}

Colour diffuse(const OracleSurface& s, Interval n_dot_l) {
  const Interval lit = at_least(n_dot_l, 0);
  Colour share = colour(lit);
  if (is_skin(s)) {
    const double wraps[] = {kSkinWrapRed, kSkinWrapGreen, kSkinWrapBlue};
    for (size_t i = 0; i < 3; ++i) {
      const Interval wrap = one_minus(s.metallic) * exactly(wraps[i]);
      share[i] = at_least(n_dot_l + wrap, 0) * (exactly(1) / square(exactly(1) + wrap));
    }
  }
  if ((s.features & kFeatureSubsurface) != 0) share = share + colour(exactly(kLeafThrough) * at_least(-n_dot_l, 0));
  return albedo(s, metalness(s)) * share * kOverPi;
}

// The part that light from the front alone has: both lobes of the half vector, times n.l.
Colour glossy(const OracleSurface& s, const Ball& direction, Interval n_dot_l) {
  const Interval alpha = square(at_least(s.roughness, kMinimumRoughness));
  const Interval n_dot_v = at_least(dot(s.normal, s.to_eye), kLeastNormalDotView);
  const Interval lit = at_least(n_dot_l, 0);
  const Ball half = normalised(direction + s.to_eye, kShortestVector);
  const Interval grazing = one_minus(clamped(dot(s.to_eye, half), 0, 1));
  const Interval fifth = square(square(grazing)) * grazing;
  const Colour f0 = normal_reflectance(s, metalness(s));
  Colour fresnel = kBlack;
  for (size_t i = 0; i < 3; ++i) fresnel[i] = f0[i] + one_minus(f0[i]) * fifth;
  Colour sum = fresnel * microfacets(s, alpha, n_dot_v, lit, half);
  if ((s.features & kFeatureCloth) != 0) sum = sum + s.base_colour * (exactly(kClothSheen) * fifth * kOverPi);
  return sum * lit;
}

bool sheds_light(const LightRecord& light) {
  const bool directional = light.kind == kLightDirectional;
  return light.kind <= kLightSpot && finite(light.colour) && finite(directional ? light.direction : light.position);
}

}  // namespace

Interval unorm8(uint32_t code) { return bounded::rounded(exactly(code / 255.0), 3); }

Colour shade(const OracleSurface& s, const LightRecord& light, Interval visible) {
  if (!sheds_light(light)) return kBlack;
  // Of a direction so long, sums of products overflow to whatever they meet: no light, or any.
  if (light.kind == kLightDirectional && glm::length(glm::dvec3(light.direction)) > kLongDirection)
    return colour(light.colour) * Interval{0, bounded::kInfinite};
  Arriving in = arriving(s.position, light);
  if (visible.low < 1) in.radiance = in.radiance * visible;
  const Interval n_dot_l = dot(s.normal, in.direction);
  double most = 0;
  for (const Interval& i : in.radiance) most = std::max({most, std::fabs(i.low), std::fabs(i.high)});
  if (most == 0) return kBlack;
  Colour sum = diffuse(s, n_dot_l);
  if (n_dot_l.high > 0) sum = sum + glossy(s, in.direction, n_dot_l);
  sum = sum * in.radiance;
  // Light so bright that a device may find an infinity on the way drops it.
  if (most > kMayOverflow)
    for (Interval& i : sum) i = hull(i, exactly(0));
  return sum;
}

Colour shade_ambient(const OracleSurface& s, const vec3& ambient) {
  return colour(ambient) * (albedo(s, metalness(s)) + normal_reflectance(s, metalness(s)));
}

}  // namespace assay::shading
