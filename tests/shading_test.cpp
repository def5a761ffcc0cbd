// The tests' own shading, against what is known of it in closed form, and its error against floats.
#include "tests/shading.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "harness/oracle.h"

namespace assay::tests {
namespace {

using glm::dvec3;
using scene::Light;
using scene::LightKind;

constexpr double kPi = 3.14159265358979323846;

dvec3 direction(double polar, double turn) {
  return {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
}
Light lamp(const dvec3& at, float intensity = 1, float range = 0) {
  return {.kind = LightKind::point, .position = at, .intensity = intensity, .range = range};
}

// D is a distribution: over the hemisphere, its projected area is one.
TEST(Shading, GgxIsNormalised) {
  for (const double alpha : {0.05, 0.3, 1.0}) {
    double sum = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {  // over the polar angle, its tangent spaced evenly in its logarithm
      const auto angle = [&](double t) { return std::atan(alpha * std::exp(30 * t - 15)); };
      const double a = angle(i / double{steps}), b = angle((i + 1) / double{steps}), middle = (a + b) / 2;
      sum += ggx(std::cos(middle), alpha) * std::cos(middle) * 2 * kPi * std::sin(middle) * (b - a);
    }
    EXPECT_NEAR(sum, 1, 1e-3) << alpha;
  }
}

TEST(Shading, SpecularIsReciprocalAndBounded) {
  const auto angle = rc::gen::map(rc::gen::inRange(0, 1550), [](int i) { return i * 0.001; });
  const bool passed = rc::check("reciprocal", [&] {
    const Shaded s = {.base = dvec3(0.9, 0.5, 0.1), .roughness = 0.05 + *angle / 1.7, .metallic = *angle / 1.6};
    const dvec3 l = direction(*angle, 0), v = direction(*angle, *angle * 4);
    const dvec3 there = specular(s, l, v), back = specular(s, v, l);
    for (int c = 0; c < 3; ++c) RC_ASSERT(std::abs(there[c] - back[c]) <= 1e-9 * (1 + std::abs(there[c])));
  });
  EXPECT_TRUE(passed);
  // A furnace: of light from everywhere no more comes back than went in, and of a smooth mirror nearly all. At
  // roughness 1 D is 1 / pi and V 1 / (2 (n.l + n.v)), and what comes back is 1 - v ln((1 + v) / v) with v = n.v.
  for (const double roughness : {0.3, 0.6, 1.0})
    for (const double view : {0.1, 0.8, 1.4}) {
      const Shaded mirror = {.roughness = roughness, .metallic = 1};
      double sum = 0;
      const int n = 400;
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
          const double polar = (i + 0.5) / n * kPi / 2, turn = (k + 0.5) / n * 2 * kPi;
          sum += specular(mirror, direction(polar, turn), direction(view, 0)).x * std::cos(polar) * std::sin(polar) *
                 (kPi / 2 / n) * (2 * kPi / n);
        }
      const double v = std::cos(view);
      const double known = 1 - v * std::log((1 + v) / v);
      EXPECT_GE(sum, roughness == 1 ? known - 1e-4 : roughness == 0.3 ? 0.9 : 0.0) << roughness << " " << view;
      EXPECT_LE(sum, roughness == 1 ? known + 1e-4 : 1.001) << roughness << " " << view;
    }
}

TEST(Shading, HeadOnItIsTheTextbooksNumber) {
  Shaded s = {.base = dvec3(0.5, 0.25, 1), .roughness = 0.6, .metallic = 0};
  const double alpha = 0.36;
  const Lit lit = reflected(s, dvec3(0), {0, 0, 5}, lamp({0, 0, 2}, 8));
  // E = 8 / 4; albedo / pi, and D V F = 1 / (pi alpha^2) * 1/4 * 0.04.
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(lit.radiance[c], 2 * (s.base[c] / kPi + 0.04 / (4 * kPi * alpha * alpha)), 1e-12);
  s.metallic = 1;
  EXPECT_NEAR(reflected(s, dvec3(0), {0, 0, 5}, lamp({0, 0, 2}, 8)).radiance.x, 2 * 0.5 / (4 * kPi * alpha * alpha),
              1e-12);
  Light sun = {.kind = LightKind::directional, .direction = {0, 0, -1}, .intensity = static_cast<float>(kPi)};
  s = {.base = dvec3(1), .roughness = 1};
  EXPECT_NEAR(reflected(s, dvec3(0), {0, 0, 5}, sun).radiance.x, 1 + 0.01, 1e-6);
}

TEST(Shading, LightFallsOffAsGltfSays) {
  const Shaded s = {.base = dvec3(0.5), .roughness = 1};
  const dvec3 eye(0, 0, 20);
  const double near = reflected(s, dvec3(0), eye, lamp({0, 0, 1})).radiance.x;
  EXPECT_NEAR(reflected(s, dvec3(0), eye, lamp({0, 0, 3})).radiance.x * 9, near, 1e-12);
  EXPECT_NEAR(reflected(s, dvec3(0), eye, lamp({0, 0, 1}, 1, 2)).radiance.x, near * (1 - 1.0 / 16), 1e-12);
  EXPECT_EQ(reflected(s, dvec3(0), eye, lamp({0, 0, 2}, 1, 2)).radiance.x, 0);
  EXPECT_EQ(reflected(s, dvec3(0), eye, lamp({0, 0, -1})).radiance.x, 0);  // from behind
  Light spot = {.kind = LightKind::spot, .position = {0, 0, 1}, .inner_rad = 0.2f, .outer_rad = 0.6f};
  for (const auto& [angle, share] :
       {std::pair{0.1, 1.0}, {0.7, 0.0}, {std::acos((std::cos(0.2) + std::cos(0.6)) / 2), 0.25}}) {
    spot.direction = glm::vec3(-direction(angle, 1));
    EXPECT_NEAR(reflected(s, dvec3(0), eye, spot).radiance.x, near * share, 1e-6) << angle;
  }
}

TEST(Shading, FeaturesChangeTheDiffuseLobe) {
  const dvec3 eye = direction(1.2, kPi) * 3.0;
  Shaded plain = {.base = dvec3(0.6), .roughness = 0.8};
  const auto lit = [&](uint32_t features, const Light& light) {
    Shaded s = plain;
    s.features = features;
    s.metallic = features & kFeatureSkin ? 0.5 : 0;
    return reflected(s, dvec3(0), eye, light).radiance;
  };
  const Light front = lamp(direction(1.2, 0)), behind = lamp({0, 0, -1}), grazing = lamp(direction(1.6, 0));
  EXPECT_GT(lit(kFeatureCloth, front).x, lit(0, front).x);
  EXPECT_NEAR(lit(kFeatureSubsurface, behind).x, 0.5 * 0.6 / kPi, 1e-12);
  EXPECT_EQ(lit(0, grazing).x, 0);
  EXPECT_GT(lit(kFeatureSkin, grazing).x, lit(kFeatureSkin, grazing).z);  // red wraps farthest
  EXPECT_GT(lit(kFeatureSkin, grazing).z, 0);
}

// ---- The error -----------------------------------------------------------------------------------------------------

// The formulas once more, in floats, as a renderer would have them: position relative to the eye from a rounded ray.
glm::vec3 in_floats(const Shaded& s, const dvec3& position, const dvec3& eye, const Light& light) {
  using glm::vec3;
  const vec3 p(position - eye), n(s.normal), base(s.base), v = normalize(-p);
  const vec3 towards = vec3(light.position - eye) - p;
  const float d2 = dot(towards, towards), metal = static_cast<float>(s.metallic);
  const vec3 l = towards / std::sqrt(d2), h = normalize(l + v);
  const float rough = std::max(static_cast<float>(s.roughness), 0.045f), a = rough * rough;
  const float nl = dot(n, l), nv = std::max(dot(n, v), 1e-4f), vh = std::min(std::max(dot(v, h), 0.0f), 1.0f);
  if (nl <= 0) return vec3(0);
  const vec3 across = cross(n, h), f0 = 0.04f * (1 - metal) + base * metal;
  const float c = a * dot(n, h), k = a / (dot(across, across) + c * c);
  const float vis =
      0.5f / (nl * std::sqrt(a * a + (1 - a * a) * nv * nv) + nv * std::sqrt(a * a + (1 - a * a) * nl * nl));
  const vec3 f = f0 + (1.0f - f0) * std::pow(1 - vh, 5.0f);
  float share = 1 / d2;
  if (light.range > 0) {
    const float q = d2 / (light.range * light.range);
    share *= std::max(0.0f, 1 - q * q);
  }
  if (light.kind == LightKind::spot) {
    const float inner = std::cos(light.inner_rad), outer = std::cos(light.outer_rad),
                scale = 1 / std::max(0.001f, inner - outer);
    const float t = std::min(std::max(dot(-l, light.direction) * scale - outer * scale, 0.0f), 1.0f);
    share *= t * t;
  }
  return (base * (1 - metal) / 3.14159265f + k * k / 3.14159265f * vis * f) * nl * light.colour * light.intensity *
         share;
}

TEST(Shading, FloatsStayWithinTheError) {
  Pcg32 rng(20260102);
  const auto unit = [&] { return rng.below(1 << 20) * 0x1p-19 - 1; };
  std::vector<double> widths;
  for (int i = 0; i < 20000; ++i) {
    const dvec3 eye(unit() * 100, unit() * 10, unit() * 100);
    const dvec3 position = eye + dvec3(unit(), unit(), unit()) * std::exp(unit() * 3 + 1);
    Shaded s = {.base = {std::abs(unit()), std::abs(unit()), std::abs(unit())},
                .roughness = std::abs(unit()),
                .metallic = rng.below(3) ? 0 : 1.0};
    const dvec3 v = normalize(eye - position);
    s.normal = normalize(v + dvec3(unit(), unit(), unit()));
    Light light = lamp(position + dvec3(unit(), unit(), unit()) * 3.0, 10, rng.below(2) ? 4.0f : 0.0f);
    if (rng.below(3) == 0)  // on the highlight, where D is steep
      light.position = position + (2 * dot(v, s.normal) * s.normal - v) * 2.0 + dvec3(unit(), unit(), unit()) * 0.02;
    if (rng.below(2)) {
      light.kind = LightKind::spot;
      light.direction = glm::vec3(normalize(position + dvec3(unit(), unit(), unit()) * 0.5 - light.position));
      light.outer_rad = static_cast<float>(0.1 + std::abs(unit()));
      light.inner_rad = light.outer_rad * static_cast<float>(std::abs(unit()));
    }
    const Lit lit = reflected(s, position, eye, light);
    const dvec3 floats(in_floats(s, position, eye, light));
    for (int c = 0; c < 3; ++c) {
      ASSERT_LE(std::abs(floats[c] - lit.radiance[c]), lit.error[c] + 1e-30) << i << ": " << lit.radiance[c];
      if (lit.radiance[c] > 1e-3) widths.push_back(lit.error[c] / lit.radiance[c]);
    }
  }
  std::sort(widths.begin(), widths.end());
  ASSERT_GT(widths.size(), 1000u);
  // A bound that told nothing would hold too: mostly it is finer than a half, which the frame keeps.
  EXPECT_LT(widths[widths.size() / 2], 0x1p-10);
  fmt::print("error over value: median {:.1e}, 90 % {:.1e}\n", widths[widths.size() / 2],
             widths[widths.size() * 9 / 10]);
}

}  // namespace
}  // namespace assay::tests
