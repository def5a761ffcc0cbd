#include "tests/raycaster.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_precision.hpp>
#include <limits>

namespace assay::tests {
namespace {

using glm::dvec2;
using glm::dvec3;
using scene::Scene;

// Half a step of the rasteriser's 1/256 px grid moves an edge by 0.0028 px at most, and a float clip position of 1280
// pixels is good to 640 * 2^-24 * 8 roundings = 0.0003 px; where a triangle's w spans much more, a little of that is
// magnified. 1/128 px is twice the sum.
constexpr double kEdgePx = 1.0 / 128;
// Depths are floats, near / w of three vertices blended: surfaces that close are a tie.
constexpr double kTie = 1e-5;

struct Ray {  // direction with its change a pixel to the right and down
  dvec3 origin, direction, right, down;
};

struct Candidate : Hit {
  enum { solid, hole, close } alpha = solid;
};

// Alpha at a texel of the repeating image.
double texel_alpha(const scene::Image& image, int64_t x, int64_t y) {
  const auto wrap = [](int64_t i, uint32_t n) { return static_cast<size_t>((i % n + n) % n); };
  return image.rgba[(wrap(y, image.height) * image.width + wrap(x, image.width)) * 4 + 3] / 255.0;
}

// Any mip level's bilinear sample is a weighted mean of the texels around: within two pixels' footprint and one texel.
// All above the cutoff: solid; all below: a hole; else (or over 64 texels across) nobody can say without filtering.
auto masked(const Scene& s, const scene::Material& m, const dvec2& uv, const dvec2& uv_per_x, const dvec2& uv_per_y) {
  if (m.base_image == scene::kNone) return m.base_colour.w >= m.alpha_cutoff ? Candidate::solid : Candidate::hole;
  const scene::Image& image = s.images[m.base_image];
  const dvec2 size(image.width, image.height), centre = uv * size - 0.5;
  const dvec2 reach = (abs(uv_per_x) + abs(uv_per_y)) * size * 2.0 + 1.0;
  if (!(std::max(reach.x, reach.y) < 32)) return Candidate::close;
  const glm::i64vec2 low(floor(centre - reach)), high(floor(centre + reach) + 1.0);
  bool above = false, below = false;
  for (int64_t y = low.y; y <= high.y; ++y)
    for (int64_t x = low.x; x <= high.x; ++x) {
      const double alpha = texel_alpha(image, x, y) * m.base_colour.w;
      above |= alpha > m.alpha_cutoff - 0.008;  // two codes of slack: levels and samples are rounded
      below |= alpha < m.alpha_cutoff + 0.008;
    }
  return above && below ? Candidate::close : above ? Candidate::solid : Candidate::hole;
}

// The triangle a, b, c relative to the ray's origin. With n_k the normals of the planes through the origin and an edge,
// direction . n_k are its barycentrics times their sum, and their change a pixel gives the distance to the edge.
void test_triangle(const Scene& s, const scene::Mesh& mesh, const scene::Material& m, const uint32_t* v, const Ray& ray,
                   double near_plane, Candidate found, std::vector<Candidate>& candidates) {
  dvec3 p[3], n[3], weight;
  for (int k = 0; k < 3; ++k) p[k] = dvec3(mesh.positions[v[k]]) - ray.origin;
  double sum = 0, inside = 1e300, outside = -1e300;
  for (int k = 0; k < 3; ++k) {
    n[k] = cross(p[(k + 1) % 3], p[(k + 2) % 3]);
    sum += weight[k] = dot(ray.direction, n[k]);
  }
  const double volume = dot(p[0], n[0]);  // negative: the front is seen
  found.distance = volume / sum;
  if (!(found.distance >= near_plane) || (volume > 0 && !m.double_sided)) return;
  for (int k = 0; k < 3; ++k) {
    const double per_px = std::hypot(dot(ray.right, n[k]), dot(ray.down, n[k]));
    const double px = (sum < 0 ? -weight[k] : weight[k]) / per_px;
    inside = std::fmin(inside, px), outside = std::fmax(outside, -px);
  }
  found.edge_px = inside >= 0 ? inside : -outside;  // negative outside the triangle
  if (!(found.edge_px > -1)) return;
  if (m.alpha == scene::AlphaMode::masked) {
    const auto uv_along = [&](const dvec3& d) {  // uv where the ray d meets the plane
      dvec2 uv(0);
      double total = 0;
      for (int k = 0; k < 3; ++k) uv += dvec2(mesh.attributes[v[k]].uv) * dot(d, n[k]), total += dot(d, n[k]);
      return uv / total;
    };
    const dvec2 uv = uv_along(ray.direction);
    found.alpha = masked(s, m, uv, uv_along(ray.direction + ray.right) - uv, uv_along(ray.direction + ray.down) - uv);
  }
  candidates.push_back(found);
}

// Whether the box's sphere comes within a pixel of the ray.
bool passes(const scene::Bounds& box, const Ray& ray) {
  const dvec3 centre = (box.lowest + box.highest) * 0.5 - ray.origin;
  const double pixel = std::max(length(ray.right), length(ray.down)), along = length(ray.direction);
  const double radius = length(box.highest - box.lowest) * 0.5;
  return length(cross(ray.direction, centre)) / along <= radius + (length(centre) + radius) * pixel / along * 2;
}

std::optional<Hit> resolve(std::vector<Candidate> all) {
  if (all.empty()) return {};
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  const auto is_hit = [](const Candidate& c) { return c.edge_px >= 0 && c.alpha != Candidate::hole; };
  const auto first = std::find_if(all.begin(), all.end(), is_hit);
  Hit hit;
  if (first != all.end()) hit = *first;
  hit.edge_px = 1;
  const double limit = first == all.end() ? std::numeric_limits<double>::infinity() : first->distance * (1 + 1e-6);
  for (const Candidate& c : all) {
    if (c.distance > limit) break;
    if (c.alpha != Candidate::hole) hit.edge_px = std::min(hit.edge_px, std::abs(c.edge_px));
    hit.alpha_close |= c.alpha == Candidate::close;
  }
  hit.second = std::numeric_limits<double>::infinity();
  if (first != all.end()) {
    const auto next = std::find_if(first + 1, all.end(), is_hit);
    if (next != all.end()) hit.second = next->distance;
  }
  return hit;
}

}  // namespace

std::optional<Hit> cast(const Scene& s, const scene::Camera& camera, Extent extent, double x, double y) {
  const double high = std::tan(camera.vertical_fov_rad / 2), wide = high * extent.width / extent.height;
  const glm::dmat3 axes = mat3_cast(camera.orientation);
  const Ray world = {camera.eye,
                     axes * dvec3((2 * x / extent.width - 1) * wide, (1 - 2 * y / extent.height) * high, -1),
                     axes[0] * (2 * wide / extent.width), axes[1] * (-2 * high / extent.height)};
  std::vector<std::vector<scene::Bounds>> boxes(s.meshes.size());
  for (size_t m = 0; m < boxes.size(); ++m)
    for (const scene::Part& part : s.meshes[m].parts) boxes[m].push_back(bounds_of(s.meshes[m], part));

  std::vector<Candidate> candidates;
  for (uint32_t i = 0; i < s.instances.size(); ++i) {
    const scene::Mesh& mesh = s.meshes[s.instances[i].mesh];
    const glm::dmat3 linear = inverse(glm::dmat3(s.instances[i].to_world));
    const Ray ray = {linear * (world.origin - dvec3(s.instances[i].to_world[3])), linear * world.direction,
                     linear * world.right, linear * world.down};
    for (uint32_t p = 0; p < mesh.parts.size(); ++p) {
      const scene::Part& part = mesh.parts[p];
      const scene::Material& m = s.materials[part.material];
      if (m.alpha == scene::AlphaMode::blended || !passes(boxes[s.instances[i].mesh][p], ray)) continue;
      Candidate found;
      found.instance = i, found.part = p;
      for (; found.triangle < part.index_count / 3; ++found.triangle)
        test_triangle(s, mesh, m, &mesh.indices[part.first_index + found.triangle * 3], ray, camera.near_plane, found,
                      candidates);
    }
  }
  return resolve(std::move(candidates));
}

Doubt doubt_of(const std::optional<Hit>& hit) {
  if (!hit) return Doubt::none;
  if (hit->edge_px < kEdgePx) return Doubt::edge;
  if (hit->alpha_close) return Doubt::alpha;
  if (hit->instance != scene::kNone && hit->second - hit->distance < kTie * hit->distance) return Doubt::tie;
  return Doubt::none;
}

}  // namespace assay::tests
