// From a scene and a camera to the buffers of a frame: culling, buckets of draws, merged meshes.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <map>
#include <set>
#include <stdexcept>

#include "harness/scene/gather.h"

namespace assay::scene {
namespace {

// A mesh part of one instance, by the order in which it is drawn: what shares bucket, mesh and part is one draw.
struct Surface {
  uint32_t bucket, mesh, part, instance;
  auto operator<=>(const Surface&) const = default;
};

struct Transform {  // in double; the records round each row once
  glm::dvec4 clip_x, clip_y, clip_w, world_x, world_y, world_z;
  bool mirrored;
};

Transform transform_of(const Instance& instance, const Camera& camera, const ClipRows& rows) {
  glm::dmat4 relative = instance.to_world;
  relative[3] -= glm::dvec4(camera.eye, 0);
  // row * matrix: the clip row of the product.
  return {rows.x * relative,
          rows.y * relative,
          rows.w * relative,
          row(relative, 0),
          row(relative, 1),
          row(relative, 2),
          determinant(glm::dmat3(relative)) < 0};
}

// Whether the whole box lies outside one plane of the frustum. The slack (10^-5 of the coordinates) is far above what
// float rows and a float transform lose (about 4 * 2^-24 of them), so that nothing that a pixel could see is dropped.
bool outside(const Transform& t, const Bounds& box, double near_plane) {
  double out[5] = {1e300, 1e300, 1e300, 1e300, 1e300}, scale = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 p = {i & 1 ? box.highest.x : box.lowest.x, i & 2 ? box.highest.y : box.lowest.y,
                          i & 4 ? box.highest.z : box.lowest.z, 1};
    const double x = dot(t.clip_x, p), y = dot(t.clip_y, p), w = dot(t.clip_w, p);
    const double beyond[5] = {x - w, -x - w, y - w, -y - w, near_plane - w};
    for (int k = 0; k < 5; ++k) out[k] = std::min(out[k], beyond[k]);
    const glm::dvec4 magnitude = abs(p);
    scale =
        std::max({scale, dot(abs(t.clip_x), magnitude), dot(abs(t.clip_y), magnitude), dot(abs(t.clip_w), magnitude)});
  }
  return *std::max_element(out, out + 5) > 1e-5 * scale;
}

uint32_t bucket_of(const Material& m, bool mirrored) {
  const uint32_t facing = m.double_sided ? kFacingBoth : mirrored ? kFacingCullFront : kFacingCullBack;
  return (m.alpha == AlphaMode::masked ? 3u : 0u) + facing;
}

std::vector<Surface> visible_surfaces(const Scene& scene, const Camera& camera,
                                      const std::vector<Transform>& transforms, std::vector<std::string>& notes) {
  std::vector<std::vector<Bounds>> boxes(scene.meshes.size());
  for (size_t m = 0; m < boxes.size(); ++m)
    for (const Part& part : scene.meshes[m].parts) boxes[m].push_back(bounds_of(scene.meshes[m], part));

  std::vector<Surface> surfaces;
  std::set<uint32_t> blended;
  uint32_t culled = 0, blended_surfaces = 0, all = 0;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const uint32_t m = scene.instances[i].mesh;
    for (uint32_t p = 0; p < scene.meshes[m].parts.size(); ++p, ++all) {
      const uint32_t material = scene.meshes[m].parts[p].material;
      if (boxes[m][p].empty()) continue;
      if (outside(transforms[i], boxes[m][p], camera.near_plane)) {
        ++culled;
      } else if (scene.materials[material].alpha == AlphaMode::blended) {
        ++blended_surfaces;
        blended.insert(material);
      } else {
        surfaces.push_back({bucket_of(scene.materials[material], transforms[i].mirrored), m, p, i});
      }
    }
  }
  if (culled) notes.push_back(fmt::format("{} of {} surfaces lie outside the view and are culled", culled, all));
  if (blended_surfaces)
    notes.push_back(fmt::format("{} surfaces of {} blended materials are left to the forward pass", blended_surfaces,
                                blended.size()));
  std::sort(surfaces.begin(), surfaces.end());
  return surfaces;
}

void append_draw(const Scene& scene, std::span<const Surface> instances, const std::vector<Transform>& transforms,
                 Merger& merger) {
  Gathered& to = merger.to;
  const Surface& s = instances.front();
  const Part& part = scene.meshes[s.mesh].parts[s.part];
  const DrawCommand draw = {part.index_count, static_cast<uint32_t>(instances.size()),
                            merger.first_index(s.mesh, s.part), merger.vertex_offset(s.mesh),
                            static_cast<uint32_t>(to.surfaces.size())};
  to.draws.push_back(draw);
  for (const Surface& surface : instances) {
    const Transform& t = transforms[surface.instance];
    uint32_t flags = material_flags(scene.materials[part.material]);
    if (t.mirrored) flags |= kSurfaceFlipped;
    if (instances.size() > 1) flags |= kSurfaceInstanced;
    to.surfaces.push_back({vec4(t.clip_x), vec4(t.clip_y), vec4(t.clip_w), vec4(t.world_x), vec4(t.world_y),
                           vec4(t.world_z), part.material, flags, draw.first_index, part.index_count / 3,
                           draw.vertex_offset, surface.mesh});
    to.surface_instance.push_back(surface.instance);
    to.surface_part.push_back(surface.part);
  }
}

}  // namespace

Gathered gather(const Scene& scene, const Camera& camera, Extent extent, const ShadowRequest* shadows) {
  const ClipRows rows = clip_rows(camera, extent);
  std::vector<Transform> transforms;
  for (const Instance& instance : scene.instances) transforms.push_back(transform_of(instance, camera, rows));

  Gathered to;
  const std::vector<Surface> surfaces = visible_surfaces(scene, camera, transforms, to.notes);
  Merger merger = {scene, to};
  uint32_t bucket = 0;
  for (size_t first = 0, last = 0; first < surfaces.size(); first = last) {
    const Surface& s = surfaces[first];
    while (last < surfaces.size() && surfaces[last].bucket == s.bucket && surfaces[last].mesh == s.mesh &&
           surfaces[last].part == s.part)
      ++last;
    while (bucket < s.bucket) to.counts.bucket_first[++bucket] = static_cast<uint32_t>(to.draws.size());
    append_draw(scene, std::span(surfaces).subspan(first, last - first), transforms, merger);
  }
  while (bucket < kDrawBuckets) to.counts.bucket_first[++bucket] = static_cast<uint32_t>(to.draws.size());
  append_lights(scene, camera, rows, to);
  append_particles(scene, camera, rows, to);
  const bool is_empty = to.surfaces.empty() && to.particle_order.empty();
  if (shadows && !is_empty) append_shadows(scene, camera, extent, *shadows, merger);
  append_materials(scene, to);
  append_decals(scene, camera, rows, to);
  to.rays = view_rays(camera, extent);

  to.counts.vertices = static_cast<uint32_t>(to.positions.size());
  to.counts.indices = static_cast<uint32_t>(to.indices.size());
  to.counts.surfaces = static_cast<uint32_t>(to.surfaces.size());
  to.counts.materials = static_cast<uint32_t>(to.materials.size());
  to.counts.draws = static_cast<uint32_t>(to.draws.size());
  to.counts.lights = static_cast<uint32_t>(to.lights.size());
  to.counts.visible_shaders = static_cast<uint32_t>(to.shaders.size());
  return to;
}

}  // namespace assay::scene
