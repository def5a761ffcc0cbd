// The grid of a view, and convex bounds of its lights and decals.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/clusters.h"
#include "harness/scene/gather.h"

namespace assay::scene {
namespace {

using glm::dmat3;
using glm::dvec3;

constexpr double kNear_m = 0.3, kFar_m = 300;  // of the slices; nearer and farther is in the first and the last
constexpr float kFarthest_m = 0x1p37f;         // where the last slice ends
constexpr double kEverywhere_m = 0x1p36;       // half the side of a box round what has no bounds

// Of a light: 15 u of the position (kernels/deferred_lighting, Bounds) and under 10 u each of the way from there to the
// light and its cosine with the light's axis.
constexpr double kSlack = kPositionSlack;

ClusterItem box(const dvec3& centre, double half) {
  return {vec3(centre), kShapeBox, vec3(half, 0, 0), vec3(0, half, 0), vec3(0, 0, half)};
}

// A spot's cone up to `reach`, all of it moved outwards by `off`: a cone with its apex farther back. Its pyramid, or
// the box of the whole sphere where that is smaller.
ClusterItem cone(const LightRecord& light, const dvec3& apex, const dmat3& to_view, double reach, double off) {
  const dvec3 axis(light.direction);
  const double cosine = -double{light.cone_offset} / double{light.cone_scale} / length(axis) - kSlack;
  if (!(cosine >= 0.5 && cosine <= 1)) return box(apex, reach);
  const double sine = std::sqrt(1 - cosine * cosine), back = off / sine, high = reach + back;
  const dvec3 along = normalize(to_view * axis);
  const dvec3 aside = std::fabs(along.x) < std::fabs(along.y) ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = normalize(cross(along, aside)), v = cross(along, u);
  const double half = (high + off) * sine / cosine;
  return {vec3(apex - along * back), kShapePyramid, vec3(u * half), vec3(v * half), vec3(along * (high + off))};
}

ClusterItem item_of(const LightRecord& light, const dmat3& to_view) {
  if (light.kind == kLightDirectional || !(light.range > 0)) return box(dvec3(0), kEverywhere_m);
  const dvec3 at = to_view * dvec3(light.position);
  const double off = kSlack * (length(at) + light.range), reach = light.range + off;
  return light.kind == kLightSpot ? cone(light, at, to_view, reach, off) : box(at, reach);
}

// Slopes of the edges of cells, in pixels from one side of the picture to the other.
void append_slopes(std::vector<float>& edges, uint32_t cells, uint32_t cell, uint32_t pixels, double half) {
  for (uint32_t i = 0; i <= cells; ++i)
    edges.push_back(static_cast<float>(half * (2.0 * std::min(i * cell, pixels) / pixels - 1)));
}

}  // namespace

void append_clusters(const Camera& camera, Extent picture, Extent cell, uint32_t slices, Gathered& to) {
  to.grid = grid_over(picture, cell, slices);
  const double high = std::tan(camera.vertical_fov_rad / 2), wide = high * picture.width / picture.height;
  append_slopes(to.cluster_edges, to.grid.columns, cell.width, picture.width, wide);
  append_slopes(to.cluster_edges, to.grid.rows, cell.height, picture.height, high);
  std::vector<float> depths = slice_edges(kNear_m, kFar_m, slices);
  depths.front() = 0, depths.back() = kFarthest_m;
  to.cluster_edges.insert(to.cluster_edges.end(), depths.begin(), depths.end());
  to.slice_edges = reversed_slice_edges(depths, static_cast<float>(camera.near_plane));

  const dmat3 axes = mat3_cast(camera.orientation);  // columns: right, up, backward
  const dmat3 to_view = transpose(dmat3(axes[0], -axes[1], -axes[2]));
  const size_t lights = std::min<size_t>(to.lights.size(), kMaxClusterLights);
  for (size_t i = 0; i < lights; ++i) to.cluster_items.push_back(item_of(to.lights[i], to_view));
  if (to.lights.size() > lights)
    to.notes.push_back(fmt::format("cells know the first {} of {} lights; the others shed no light through them",
                                   kMaxClusterLights, to.lights.size()));
  for (const DecalRecord& d : to.decals) {
    ClusterItem item = reach_of(d, d.receiver == kNoReceiver ? nullptr : &to.receivers[d.receiver]);
    for (vec3* v : {&item.origin, &item.a, &item.b, &item.c}) *v = vec3(to_view * dvec3(*v));
    to.cluster_items.push_back(item);
  }
}

}  // namespace assay::scene
