#include "tests/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace assay::tests {
namespace {

using glm::dvec2;
using glm::dvec3;

// Weights are kept as unorm16: half a code, and as much again for the arithmetic. Derivatives keep 13 bits under the
// exponent of the largest: half a unit of at least 2048 of them, and as much again.
constexpr double kWeightError = 1.0 / 65535;
constexpr double kDerivativeError = 1.0 / 2048;
// Lambert's projection in two snorm16: within 0.0025 degrees.
constexpr double kFrameError_rad = 0.0025 * 3.14159265358979 / 180;

struct Sampler {
  const scene::Scene& scene;
  const SurfacePoint& point;
  Filter& filter;

  RangedTexel linear(uint32_t image) { return filter.sample(image, false, point.footprint); }
  RangedTexel colour(uint32_t image) { return filter.sample(image, true, point.footprint); }
  RangedTexel detail(const scene::Material& m) {
    Footprint f = point.footprint;
    const double scale = double{m.detail_scale};
    for (dvec2* v : {&f.uv, &f.per_x, &f.per_y, &f.uv_error, &f.gradient_error}) *v *= scale;
    return filter.sample(m.detail_image, false, f);
  }
};

// Tangent-space normal: the middle of its box, and how far the box reaches.
std::pair<dvec3, double> normal_of(const scene::Material& m, Sampler& s) {
  if (m.normal_image == scene::kNone) return {dvec3(0, 0, 1), 0.0};
  const RangedTexel t = s.linear(m.normal_image);
  const auto signed_range = [](const Range& r) { return Range{r.low * 2 - 1, r.high * 2 - 1}; };
  const Range x = signed_range(t[0]), y = signed_range(t[1]);
  const auto square = [](const Range& r) {
    const double a = r.low * r.low, b = r.high * r.high;
    return Range{r.low <= 0 && r.high >= 0 ? 0.0 : std::min(a, b), std::max(a, b)};
  };
  const Range z = {std::sqrt(std::max(0.0, 1 - square(x).high - square(y).high)),
                   std::sqrt(std::max(0.0, 1 - square(x).low - square(y).low))};
  const double scale = double{m.normal_scale};
  const dvec3 low(scale * x.low, scale * y.low, z.low), high(scale * x.high, scale * y.high, z.high);
  return {(low + high) * 0.5, length(high - low) * 0.5};
}

// Angle by which a vector may turn that is off by `error`.
double turn(double error, double length) { return error < length ? std::asin(error / length) : 3.15; }

void add_class(const scene::Scene& scene, const scene::Material& m, Sampler& s, Appearance& a) {
  switch (shader_class(scene, m)) {
    case kShaderEmissiveDetail: {
      const RangedTexel t = s.detail(m);
      for (size_t c = 0; c < 3; ++c) a.base[c] = a.base[c] * t[c], a.emissive[c] = a.emissive[c] * t[c];
      return;
    }
    case kShaderCloth: {  // threads that stand high are as smooth as the material, between them is 1
      const Range height = s.detail(m)[0];
      const Range low = mix({1, 1}, a.roughness, height.high), high = mix({1, 1}, a.roughness, height.low);
      a.roughness = hull(low, high);
      return;
    }
    case kShaderSkin:  // thickness takes the place of metallic
      a.metallic = s.linear(m.mask_image)[0];
      return;
  }
}

}  // namespace

std::string outside(const char* channel, double got, const Range& allowed) {
  if (allowed.holds(got)) return "";
  return fmt::format("{} is {:.5f}, allowed are {:.5f} to {:.5f}", channel, got, allowed.low, allowed.high);
}
Range stored(const Range& r) {
  const auto clamped = [](double v) { return std::clamp(v, 0.0, 1.0) * 255; };
  return {std::floor(clamped(r.low) - 1e-4) / 255, std::ceil(clamped(r.high) + 1e-4) / 255};
}
Range rooted(const Range& r) { return {std::sqrt(std::max(0.0, r.low)), std::sqrt(std::max(0.0, r.high))}; }

SurfacePoint surface_at(const scene::Scene& s, const scene::Camera& camera, Extent extent, double x, double y,
                        const Hit& hit) {
  const scene::Instance& instance = s.instances[hit.instance];
  const scene::Mesh& mesh = s.meshes[instance.mesh];
  const scene::Part& part = mesh.parts[hit.part];
  const uint32_t* v = &mesh.indices[part.first_index + hit.triangle * 3];
  const glm::dmat3 to_world(instance.to_world), axes = mat3_cast(camera.orientation);
  const double high = std::tan(camera.vertical_fov_rad / 2), wide = high * extent.width / extent.height;
  const dvec3 ray = axes * dvec3((2 * x / extent.width - 1) * wide, (1 - 2 * y / extent.height) * high, -1);
  const dvec3 right = axes[0] * (2 * wide / extent.width), down = axes[1] * (-2 * high / extent.height);

  // Homogeneous weights are ray . n_k; lambda = weight / sum, and so are its derivatives.
  dvec3 corner[3], weights, per_x, per_y;
  for (int k = 0; k < 3; ++k)
    corner[k] = dvec3(instance.to_world * glm::dvec4(dvec3(mesh.positions[v[k]]), 1)) - camera.eye;
  for (int k = 0; k < 3; ++k) {
    const dvec3 n = cross(corner[(k + 1) % 3], corner[(k + 2) % 3]);
    weights[k] = dot(ray, n), per_x[k] = dot(right, n), per_y[k] = dot(down, n);
  }
  const auto total = [](const dvec3& w) { return w.x + w.y + w.z; };
  const dvec3 lambda = weights / total(weights);
  const dvec3 lambda_x = (per_x - lambda * total(per_x)) / total(weights),
              lambda_y = (per_y - lambda * total(per_y)) / total(weights);

  SurfacePoint p = {.material = part.material, .position = ray * hit.distance};
  // Depth is near / w, linear over the screen. Snapping vertices to a grid of 1/256 px moves it by its slope over half
  // a step each way, twice that to be safe; the plane is computed in floats from the nearest vertex's depth downwards.
  const double slope = (std::abs(total(per_x)) + std::abs(total(per_y))) / std::abs(total(weights));
  p.per_x = hit.distance * (right - ray * (total(per_x) / total(weights)));
  p.per_y = hit.distance * (down - ray * (total(per_y) / total(weights)));
  double nearest = hit.distance;
  for (const dvec3& c : corner) nearest = std::min(nearest, std::max(camera.near_plane, -dot(axes[2], c)));
  p.depth_error = slope / 256 + 16 * std::ldexp(1.0, -24) * hit.distance / nearest;
  dvec3 normal(0), tangent(0);
  for (int k = 0; k < 3; ++k) {
    const VertexAttributes& a = mesh.attributes[v[k]];
    normal += dvec3(a.normal) * lambda[k];
    tangent += dvec3(glm::vec3(a.tangent)) * lambda[k];
    const dvec2 uv(a.uv);
    p.footprint.uv += uv * lambda[k], p.footprint.per_x += uv * lambda_x[k], p.footprint.per_y += uv * lambda_y[k];
  }
  const double mirror = determinant(to_world) < 0 ? -1 : 1;
  p.normal = normalize(transpose(inverse(to_world)) * normal);
  p.tangent = normalize(to_world * tangent);
  p.handedness = mirror * (mesh.attributes[v[0]].tangent.w < 0 ? -1 : 1);
  p.front = dot(ray, cross(corner[1] - corner[0], corner[2] - corner[0])) * mirror < 0;

  const dvec2 first(mesh.attributes[v[0]].uv);
  const dvec2 extent_uv = abs(dvec2(mesh.attributes[v[1]].uv) - first) + abs(dvec2(mesh.attributes[v[2]].uv) - first);
  double steepest = 0;
  for (const dvec3& d : {lambda_x, lambda_y}) steepest = std::max({steepest, std::abs(d.y), std::abs(d.z)});
  p.footprint.uv_error = extent_uv * kWeightError;
  p.footprint.gradient_error = extent_uv * steepest * kDerivativeError;
  return p;
}

std::optional<Appearance> appearance_of(const scene::Scene& scene, const SurfacePoint& p, Filter& filter) {
  const scene::Material& m = scene.materials[p.material];
  const uint32_t shader = shader_class(scene, m);
  if (shader == kShaderTwoLayer || shader == kShaderWet || shader == kShaderFoliage) return {};
  Sampler s = {scene, p, filter};
  const RangedTexel base = s.colour(m.base_image), emissive = s.colour(m.emissive_image),
                    surface = s.linear(m.metallic_roughness_image), occlusion = s.linear(m.occlusion_image);
  Appearance a;
  for (int c = 0; c < 3; ++c) {
    a.base[static_cast<size_t>(c)] = double{m.base_colour[c]} * base[static_cast<size_t>(c)];
    a.emissive[static_cast<size_t>(c)] = double{m.emissive[c]} * emissive[static_cast<size_t>(c)];
  }
  a.roughness = double{m.roughness} * surface[1];
  a.metallic = double{m.metallic} * surface[2];
  const double strength = double{m.occlusion_strength};
  a.occlusion = {1 + strength * (occlusion[0].low - 1), 1 + strength * (occlusion[0].high - 1)};
  const auto [n, reach] = normal_of(m, s);
  const dvec3 bitangent = p.handedness * cross(p.normal, p.tangent);
  const dvec3 world = n.x * p.tangent + n.y * bitangent + n.z * p.normal;
  // The box's half diagonal goes through three unit vectors, which stretch it by sqrt(3) at most (they need not be
  // orthogonal); those are each off by the stored frame's error, the cross product by twice that.
  const double size = length(n) + reach;
  a.normal_rad = turn(reach * std::sqrt(3.0) + size * 4 * kFrameError_rad, length(world)) + kOctahedralError_rad;
  const bool both = m.double_sided || shader == kShaderMasked;
  a.normal = normalize(world) * (both && !p.front ? -1.0 : 1.0);
  add_class(scene, m, s, a);
  return a;
}

dvec3 octahedral_direction(const std::array<int16_t, 2>& code) {
  dvec2 e(std::max<int>(code[0], -32767), std::max<int>(code[1], -32767));
  e /= 32767.0;
  dvec3 n(e, 1 - std::abs(e.x) - std::abs(e.y));
  if (n.z < 0) n = {(1 - std::abs(e.y)) * (e.x < 0 ? -1 : 1), (1 - std::abs(e.x)) * (e.y < 0 ? -1 : 1), n.z};
  return normalize(n);
}

dvec3 shared_exponent_radiance(uint32_t code) {
  const double scale = std::ldexp(1.0, static_cast<int>(code >> 27) - 15 - 9);
  return dvec3(code & 511u, code >> 9 & 511u, code >> 18 & 511u) * scale;
}

std::string disagreement(const Appearance& a, const GBufferPixel& got, const std::string& name) {
  static const char* names[] = {"base red", "base green", "base blue"};
  static const char* lights[] = {"emissive red", "emissive green", "emissive blue"};
  const dvec3 emissive = shared_exponent_radiance(got.emissive);
  double brightest = 0;
  for (const Range& r : a.emissive) brightest = std::max(brightest, r.high);
  const double step = std::max(brightest * std::ldexp(1.0, -9), std::ldexp(1.0, -25)) * 1.01;  // half of 2^-8 of it
  std::string all;
  const auto add = [&](const std::string& what) { all += (all.empty() || what.empty() ? "" : "; ") + what; };
  for (size_t c = 0; c < 3; ++c) {
    add(outside(names[c], got.base_roughness[c] / 255.0, stored(rooted(a.base[c]))));
    add(outside(lights[c], emissive[static_cast<int>(c)], a.emissive[c].widened(step)));
  }
  add(outside("roughness", got.base_roughness[3] / 255.0, stored(a.roughness)));
  add(outside("metallic", got.metallic_occlusion[0] / 255.0, stored(a.metallic)));
  add(outside("occlusion", got.metallic_occlusion[1] / 255.0, stored(a.occlusion)));
  const double angle = std::atan2(length(cross(octahedral_direction(got.normal), a.normal)),
                                  dot(octahedral_direction(got.normal), a.normal));
  add(outside("angle between normals", angle, {0, a.normal_rad}));
  return all.empty() ? "" : name + ": " + all;
}

}  // namespace assay::tests
