#include "tests/shading.h"

#include <algorithm>
#include <cmath>

#include "harness/formats/gbuffer.h"

namespace assay::tests {
namespace {

using glm::dvec3;

constexpr double kPi = 3.14159265358979323846;
constexpr double kUnit = 1.0 / (1 << 24);  // of float's roundings
// The shading model's constants, as its description gives them.
constexpr double kDielectric = 0.04, kLeastDistance_m = 0.01, kSheen = 0.5, kThrough = 0.5;
constexpr double kWrap[3] = {0.4, 0.15, 0.1};

bool has(const Shaded& s, uint32_t feature) { return (s.features & feature) != 0; }
double metal_of(const Shaded& s) { return has(s, kFeatureSkin) ? 0 : s.metallic; }
double alpha_of(const Shaded& s) {
  const double rough = std::max(s.roughness, double{kMinimumRoughness});
  return rough * rough;
}
dvec3 f0_of(const Shaded& s) { return kDielectric * (1 - metal_of(s)) + s.base * metal_of(s); }
double fifth(double x) { return x * x * x * x * x; }

// Smith's masking of both directions together (Heitz 2014), over 4 n.l n.v.
double smith(double l, double v, double alpha) {
  const auto root = [alpha](double c) { return std::sqrt(alpha * alpha + (1 - alpha * alpha) * c * c); };
  return 0.5 / (l * root(v) + v * root(l));
}

// What arrives, and the relative error of it; the direction's error is an angle.
struct Arriving {
  dvec3 direction;
  double share = 0, share_error = 0, angle_error = 0;
};

Arriving arriving(const dvec3& position, const dvec3& eye, const scene::Light& light) {
  const double round = 8 * kUnit;
  if (light.kind == scene::LightKind::directional) return {-normalize(dvec3(light.direction)), 1, round, round};
  const dvec3 towards = light.position - position;
  const double distance = length(towards);
  // The renderer's position is near / depth times a ray: 9 roundings of its length, and 3 of the difference.
  const double off = 9 * kUnit * length(position - eye) / distance + 3 * kUnit;
  Arriving a = {towards / distance, 1 / std::pow(std::max(distance, kLeastDistance_m), 2), 2 * off + round,
                off + round};
  double error = a.share * a.share_error;
  if (light.range > 0) {
    const double q = std::pow(distance / double{light.range}, 2), window = std::max(0.0, 1 - q * q);
    error = error * window + a.share * (4 * q * q * off + round);
    a.share *= window;
    if (q > 1 + 8 * off) error = 0;
  }
  if (light.kind == scene::LightKind::spot) {
    const double inner = std::cos(double{light.inner_rad}), outer = std::cos(double{light.outer_rad});
    const double scale = 1 / std::max(0.001, inner - outer);
    const double t = scale * (dot(-a.direction, normalize(dvec3(light.direction))) - outer);
    const double t_error = scale * (a.angle_error + 8 * kUnit), edge = std::clamp(t, 0.0, 1.0);
    // (edge + t_error)^2 - edge^2, where the cone is not dark for certain.
    const double edge_error = t < -t_error ? 0 : (2 * edge + t_error) * t_error;
    error = error * edge * edge + a.share * edge_error;
    a.share *= edge * edge;
  }
  a.share_error = error;  // absolute from here on
  return a;
}

}  // namespace

double ggx(double n_dot_h, double alpha) {
  const double sum = n_dot_h * n_dot_h * (alpha * alpha - 1) + 1;
  return alpha * alpha / (kPi * sum * sum);
}

dvec3 specular(const Shaded& s, const dvec3& to_light, const dvec3& to_eye) {
  const dvec3 h = normalize(to_light + to_eye), f0 = f0_of(s);
  const double l = dot(s.normal, to_light), v = std::max(dot(s.normal, to_eye), 1e-4), alpha = alpha_of(s);
  if (l <= 0) return dvec3(0);
  const dvec3 fresnel = f0 + (1.0 - f0) * fifth(1 - std::clamp(dot(to_eye, h), 0.0, 1.0));
  return ggx(dot(s.normal, h), alpha) * smith(l, v, alpha) * fresnel;
}

Lit reflected(const Shaded& s, const dvec3& position, const dvec3& eye, const scene::Light& light) {
  const Arriving in = arriving(position, eye, light);
  const dvec3 to_eye = normalize(eye - position), intensity = dvec3(light.colour) * double{light.intensity};
  const dvec3 albedo = s.base * (1 - metal_of(s));
  const double n_dot_l = dot(s.normal, in.direction), alpha = alpha_of(s);
  // n.l, v.h and the like: three roundings, the normal's and the directions' own.
  const double angle = in.angle_error + 20 * kUnit;
  dvec3 diffuse, rate;  // the lobes times n.l, and how fast the diffuse one changes with n.l
  for (int c = 0; c < 3; ++c) {
    const double wrap = has(s, kFeatureSkin) ? kWrap[c] * (1 - s.metallic) : 0;
    const double through = has(s, kFeatureSubsurface) ? kThrough : 0;
    diffuse[c] = albedo[c] / kPi *
                 (std::max(0.0, n_dot_l + wrap) / ((1 + wrap) * (1 + wrap)) + through * std::max(0.0, -n_dot_l));
    rate[c] = albedo[c] / kPi;
  }
  dvec3 lobes = diffuse, error = rate * angle + diffuse * (10 * kUnit);
  if (n_dot_l > -angle) {
    const double l = std::max(n_dot_l, 0.0), both = length(in.direction + to_eye);
    const double c = both > 0 ? 1 - std::clamp(both / 2, 0.0, 1.0) : 1;  // v.h is half of |l + v|
    const double half_angle = 2 * angle / std::max(both, 1e-6);
    const dvec3 gloss = l > 0 ? specular(s, in.direction, to_eye) : dvec3(0);
    // D's relative condition to the angle between n and h is 2 / alpha at most; V n.l changes by V for each of n.l, and
    // V by at most its 1 / alpha where both cosines are small.
    const double v = std::max(dot(s.normal, to_eye), 1e-4), steep = smith(std::max(l, 1e-12), v, alpha);
    const double peak =
        ggx(std::min(1.0, std::abs(dot(s.normal, both > 0 ? normalize(in.direction + to_eye) : s.normal))), alpha);
    const dvec3 f0 = f0_of(s), fresnel = f0 + (1.0 - f0) * fifth(c);
    const dvec3 fresnel_error = (1.0 - f0) * (5 * c * c * c * c * half_angle) + fresnel * (10 * kUnit);
    lobes += gloss * l;
    error += gloss * l * (2 * half_angle / alpha + angle / v + 60 * kUnit) +
             peak * steep * (fresnel * angle + fresnel_error * l);
    if (has(s, kFeatureCloth)) {
      lobes += kSheen * s.base * (fifth(c) / kPi * l);
      error += kSheen * s.base / kPi * (5 * half_angle * l + angle + 10 * kUnit);
    }
  }
  Lit lit;
  lit.radiance = lobes * intensity * in.share;
  lit.error = 2.0 * intensity * (error * (in.share + in.share_error) + lobes * in.share_error) +
              abs(lit.radiance) * (8 * kUnit);
  return lit;
}

Lit reflected(const Shaded& s, const dvec3& position, const dvec3& eye, std::span<const scene::Light> lights) {
  Lit sum;
  for (const scene::Light& light : lights) {
    const Lit one = reflected(s, position, eye, light);
    sum.radiance += one.radiance;
    sum.error += one.error + abs(sum.radiance) * kUnit;  // of the partial sum's rounding
  }
  return sum;
}

Shaded shaded_of(const GBufferPixel& p, uint32_t features) {
  Shaded s;
  for (int c = 0; c < 3; ++c) s.base[c] = std::pow(p.base_roughness[static_cast<size_t>(c)] / 255.0, 2);
  s.roughness = p.base_roughness[3] / 255.0;
  s.metallic = p.metallic_occlusion[0] / 255.0;
  s.normal = octahedral_direction(p.normal);
  s.features = features;
  return s;
}

}  // namespace assay::tests
