// Cameras: construction, clip rows, and the view chosen where a file has none.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_access.hpp>

#include "harness/scene/scene.h"

namespace assay::scene {
namespace {

constexpr double kDefaultFov = 0.7853981633974483;  // 45 degrees
constexpr double kEyeHeight_m = 1.7;
constexpr double kAlongRoom = 0.8;  // how far towards the end wall an inside view stands
constexpr uint32_t kProbeRays = 128;
constexpr double kEnclosedShare = 0.5;  // of the probe rays that must end on a face turned towards their origin
constexpr double kRoomShare = 0.25;     // of the longest horizontal extent that must be free at the centre

struct Ray {
  glm::dvec3 origin, direction;
};
struct Nearest {
  double distance = 1e300;
  bool front = false;
};

bool may_hit(const Ray& ray, const Bounds& box, double farthest) {
  double enter = 0, leave = farthest;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];  // infinite for a parallel axis: the comparisons still hold
    const double a = (box.lowest[axis] - ray.origin[axis]) * inverse;
    const double b = (box.highest[axis] - ray.origin[axis]) * inverse;
    enter = std::fmax(enter, std::fmin(a, b));
    leave = std::fmin(leave, std::fmax(a, b));
  }
  return enter <= leave;
}

void hit_triangle(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, Nearest& nearest) {
  const glm::dvec3 ab = b - a, ac = c - a;
  const glm::dvec3 p = cross(ray.direction, ac);
  const double det = dot(ab, p);
  if (det == 0) return;
  const glm::dvec3 t = ray.origin - a;
  const double u = dot(t, p) / det;
  if (!(u >= 0 && u <= 1)) return;
  const glm::dvec3 q = cross(t, ab);
  const double v = dot(ray.direction, q) / det, distance = dot(ac, q) / det;
  if (v >= 0 && u + v <= 1 && distance > 0 && distance < nearest.distance) nearest = {distance, det > 0};
}

// The nearest triangle of the scene along a ray, in the ray's direction lengths, and whether its front is seen.
Nearest cast(const Scene& scene, const std::vector<std::vector<Bounds>>& boxes, const Ray& world) {
  Nearest nearest;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const glm::dmat4 to_mesh = inverse(instance.to_world);
    const Ray ray = {glm::dvec3(to_mesh * glm::dvec4(world.origin, 1)),
                     glm::dvec3(to_mesh * glm::dvec4(world.direction, 0))};
    for (size_t p = 0; p < mesh.parts.size(); ++p) {
      if (!may_hit(ray, boxes[instance.mesh][p], nearest.distance)) continue;
      const Part& part = mesh.parts[p];
      for (uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3)
        hit_triangle(ray, glm::dvec3(mesh.positions[mesh.indices[i]]), glm::dvec3(mesh.positions[mesh.indices[i + 1]]),
                     glm::dvec3(mesh.positions[mesh.indices[i + 2]]), nearest);
    }
  }
  return nearest;
}

// Evenly spread directions (a Fibonacci spiral).
glm::dvec3 probe_direction(uint32_t i) {
  const double y = 1 - (2.0 * i + 1) / kProbeRays, ring = std::sqrt(1 - y * y);
  const double angle = i * glm::pi<double>() * (3 - std::sqrt(5.0));
  return {ring * std::cos(angle), y, ring * std::sin(angle)};
}

// Fits the whole box into an image of 4:3 or wider, seen from the front right and above.
Camera outside_view(const Bounds& box) {
  const glm::dvec3 centre = (box.lowest + box.highest) * 0.5;
  const glm::dvec3 towards = normalize(glm::dvec3(0.5, 0.4, 1));
  const glm::dvec3 right = normalize(cross(glm::dvec3(0, 1, 0), towards)), up = cross(towards, right);
  const double tangent = std::tan(kDefaultFov / 2) * 0.95;  // a margin of a twentieth
  double distance = 1e-6, nearest = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner = glm::dvec3(i & 1 ? box.highest.x : box.lowest.x, i & 2 ? box.highest.y : box.lowest.y,
                                         i & 4 ? box.highest.z : box.lowest.z) -
                              centre;
    const double side = std::max(std::abs(dot(corner, right)) * 3 / 4, std::abs(dot(corner, up)));
    distance = std::max(distance, side / tangent + dot(corner, towards));
    nearest = std::max(nearest, dot(corner, towards));
  }
  Camera camera = look_at(centre + towards * distance, centre, kDefaultFov);
  camera.name = "outside";
  camera.near_plane = std::min(0.1, std::max(distance - nearest, distance * 0.01) * 0.5);
  return camera;
}

// The rule: a scene is a room if, from the middle of its bounds, at least half of 128 even directions end on a face
// turned towards the middle (inside a solid they end on back faces), and a quarter of the longest horizontal extent is
// free there in each direction of that axis. The view then stands at eye height, 80 % of the way to the farther end
// wall, and looks back along the axis.
std::optional<Camera> inside_view(const Scene& scene, const Bounds& box) {
  std::vector<std::vector<Bounds>> boxes(scene.meshes.size());
  for (size_t m = 0; m < boxes.size(); ++m)
    for (const Part& part : scene.meshes[m].parts) boxes[m].push_back(bounds_of(scene.meshes[m], part));
  const glm::dvec3 centre = (box.lowest + box.highest) * 0.5, size = box.highest - box.lowest;
  uint32_t fronts = 0;
  for (uint32_t i = 0; i < kProbeRays; ++i) fronts += cast(scene, boxes, {centre, probe_direction(i)}).front;
  if (fronts < kProbeRays * kEnclosedShare) return {};

  const Nearest floor = cast(scene, boxes, {centre, {0, -1, 0}});
  if (floor.distance > size.y) return {};
  const glm::dvec3 axis = size.x >= size.z ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const double length = std::max(size.x, size.z), floor_y = centre.y - floor.distance;
  const glm::dvec3 stand = {centre.x, floor_y + std::min(kEyeHeight_m, floor.distance * 0.5), centre.z};
  const double back = std::min(cast(scene, boxes, {stand, -axis}).distance, length / 2);
  const double ahead = std::min(cast(scene, boxes, {stand, axis}).distance, length / 2);
  if (std::min(back, ahead) < length * kRoomShare) return {};
  const double sign = back >= ahead ? -1 : 1;
  const glm::dvec3 eye = stand + axis * (sign * kAlongRoom * std::max(back, ahead));
  Camera camera = look_at(eye, eye - axis * sign, kDefaultFov);
  camera.name = "inside";
  return camera;
}

}  // namespace

Camera look_at(const glm::dvec3& eye, const glm::dvec3& target, double vertical_fov_rad) {
  const glm::dvec3 backward = normalize(eye - target);
  const glm::dvec3 hint = std::abs(backward.y) < 0.9999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  const glm::dvec3 right = normalize(cross(hint, backward)), up = cross(backward, right);
  Camera camera;
  camera.eye = eye;
  camera.orientation = normalize(quat_cast(glm::dmat3(right, up, backward)));
  camera.vertical_fov_rad = vertical_fov_rad;
  return camera;
}

ClipRows clip_rows(const Camera& camera, Extent extent) {
  const glm::dmat3 axes = mat3_cast(camera.orientation);  // columns: right, up, backward
  const double focal = 1 / std::tan(camera.vertical_fov_rad / 2);
  const double aspect = static_cast<double>(extent.width) / extent.height;
  return {glm::dvec4(axes[0] * (focal / aspect), 0), glm::dvec4(axes[1] * -focal, 0), glm::dvec4(-axes[2], 0)};
}

ViewRays view_rays(const Camera& camera, Extent extent) {
  const glm::dmat3 axes = mat3_cast(camera.orientation);
  const double high = std::tan(camera.vertical_fov_rad / 2), wide = high * extent.width / extent.height;
  return {vec3(axes[1] * high - axes[0] * wide - axes[2]), vec3(axes[0] * (2 * wide / extent.width)),
          vec3(axes[1] * (-2 * high / extent.height))};
}

Bounds bounds_of(const Mesh& mesh, const Part& part) {
  Bounds box;
  for (uint32_t i = part.first_index; i < part.first_index + part.index_count; ++i)
    box.add(glm::dvec3(mesh.positions[mesh.indices[i]]));
  return box;
}

Bounds bounds_of(const Scene& scene) {
  std::vector<Bounds> meshes(scene.meshes.size());
  for (size_t m = 0; m < meshes.size(); ++m)
    for (const Part& part : scene.meshes[m].parts) {
      const Bounds box = bounds_of(scene.meshes[m], part);
      if (!box.empty()) meshes[m].add(box.lowest), meshes[m].add(box.highest);
    }
  Bounds all;
  for (const Instance& instance : scene.instances) {
    const Bounds& box = meshes[instance.mesh];
    for (int i = 0; i < 8 && !box.empty(); ++i)
      all.add(glm::dvec3(instance.to_world * glm::dvec4(i & 1 ? box.highest.x : box.lowest.x,
                                                        i & 2 ? box.highest.y : box.lowest.y,
                                                        i & 4 ? box.highest.z : box.lowest.z, 1)));
  }
  return all;
}

Camera default_camera(const Scene& scene) {
  if (!scene.cameras.empty()) return scene.cameras.front();
  const Bounds box = bounds_of(scene);
  if (box.empty()) return {};
  if (const std::optional<Camera> inside = inside_view(scene, box)) return *inside;
  return outside_view(box);
}

}  // namespace assay::scene
