// The default scene's nodes: instances, punctual lights and cameras, with their world transforms in double.
#include <fmt/format.h>
#include <tiny_gltf.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "harness/scene/gltf.h"

namespace assay::scene::gltf {
namespace {

glm::dmat4 local_transform(const tinygltf::Node& n) {
  if (n.matrix.size() == 16) return glm::make_mat4(n.matrix.data());
  glm::dmat4 m(1);
  if (n.translation.size() == 3) m = glm::translate(m, glm::make_vec3(n.translation.data()));
  if (n.rotation.size() == 4) {
    const glm::dquat q(n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]);
    m = m * glm::mat4_cast(glm::length(q) > 0 ? glm::normalize(q) : glm::dquat(1, 0, 0, 0));
  }
  return n.scale.size() == 3 ? glm::scale(m, glm::make_vec3(n.scale.data())) : m;
}

void check_finite(const glm::dmat4& m, const std::string& place) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!(std::abs(m[c][r]) < 1e30)) refuse(place, "its transform is not finite");
  if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) refuse(place, "its matrix is not affine");
}

// The transform's axes without its scale: what a camera or a light follows.
glm::dvec3 turned(const glm::dmat4& m, const glm::dvec3& v) {
  const glm::dvec3 t(m * glm::dvec4(v, 0));
  return glm::length(t) > 0 ? glm::normalize(t) : v;
}

void append_light(const tinygltf::Light& from, const glm::dmat4& world, const std::string& place, Scene& scene) {
  Light light;
  if (from.type == "directional")
    light.kind = LightKind::directional;
  else if (from.type == "spot")
    light.kind = LightKind::spot;
  else if (from.type != "point")
    refuse(place, fmt::format("light type \"{}\" is not known", from.type));
  light.position = glm::dvec3(world[3]);
  light.direction = glm::vec3(turned(world, {0, 0, -1}));
  if (!from.color.empty() && from.color.size() != 3) refuse(place, "light: its colour has not three components");
  if (from.color.size() == 3) light.colour = glm::vec3(glm::make_vec3(from.color.data()));
  light.intensity = static_cast<float>(from.intensity);
  light.range = static_cast<float>(from.range);
  light.inner_rad = static_cast<float>(from.spot.innerConeAngle);
  light.outer_rad = static_cast<float>(from.spot.outerConeAngle);
  if (const std::string fault = fault_of(light); !fault.empty()) refuse(place, "light: " + fault);
  scene.lights.push_back(light);
}

void append_camera(const tinygltf::Camera& from, const glm::dmat4& world, const std::string& place, Scene& scene) {
  if (from.type != "perspective") {
    scene.notes.push_back(fmt::format("{}: a camera of type \"{}\" is left out", place, from.type));
    return;
  }
  const double fov = from.perspective.yfov, near_plane = from.perspective.znear;
  if (!(fov > 0 && fov < 3.14) || !(near_plane > 0)) refuse(place, "yfov lies outside 0..pi, or znear is not positive");
  const glm::dvec3 eye(world[3]), ahead = turned(world, {0, 0, -1});
  Camera camera = look_at(eye, eye + ahead, fov);
  const glm::dvec3 right = turned(world, {1, 0, 0}), up = glm::cross(right, ahead);  // keeps the node's roll
  if (glm::length(up) > 1e-6)
    camera.orientation =
        glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(ahead, glm::normalize(up)), glm::normalize(up), -ahead)));
  camera.name = from.name.empty() ? place : from.name;
  camera.near_plane = near_plane;
  scene.cameras.push_back(camera);
}

void append_node(const tinygltf::Model& model, size_t index, const glm::dmat4& world, Scene& scene) {
  const tinygltf::Node& node = model.nodes[index];
  const std::string place = fmt::format("nodes[{}]", index);
  check_finite(world, place);
  if (node.skin >= 0) scene.notes.push_back(place + ": its skin is left out, the mesh stays in its rest pose");
  if (node.mesh >= 0 && !scene.meshes[static_cast<size_t>(node.mesh)].parts.empty())
    scene.instances.push_back({static_cast<uint32_t>(node.mesh), world});
  if (node.camera >= 0) append_camera(model.cameras[static_cast<size_t>(node.camera)], world, place, scene);
  const auto light = node.extensions.find("KHR_lights_punctual");
  if (light != node.extensions.end() && light->second.Has("light")) {
    const auto l = static_cast<size_t>(light->second.Get("light").GetNumberAsInt());
    if (l < model.lights.size()) append_light(model.lights[l], world, place, scene);
  }
}

// The default scene's roots; the first scene's where none is named; without scenes, every node that is nobody's child.
std::vector<int> roots(const tinygltf::Model& model, Scene& scene) {
  if (!model.scenes.empty()) {
    if (model.scenes.size() > 1)
      scene.notes.push_back(fmt::format("{} further scenes are left out", model.scenes.size() - 1));
    return model.scenes[static_cast<size_t>(std::max(model.defaultScene, 0))].nodes;
  }
  scene.notes.push_back("the file names no scene: all its nodes are taken");
  std::vector<bool> child(model.nodes.size());
  for (const tinygltf::Node& n : model.nodes)
    for (const int c : n.children) child[static_cast<size_t>(c)] = true;
  std::vector<int> out;
  for (size_t i = 0; i < model.nodes.size(); ++i)
    if (!child[i]) out.push_back(static_cast<int>(i));
  return out;
}

}  // namespace

void append_nodes(const tinygltf::Model& model, Scene& scene) {
  struct Visit {
    int node;
    glm::dmat4 parent;
  };
  std::vector<Visit> stack;  // not recursion: a chain of nodes may be as long as the file
  std::vector<bool> seen(model.nodes.size());
  const std::vector<int> first = roots(model, scene);
  for (auto it = first.rbegin(); it != first.rend(); ++it) stack.push_back({*it, glm::dmat4(1)});
  while (!stack.empty()) {
    const Visit v = stack.back();
    stack.pop_back();
    const auto n = static_cast<size_t>(v.node);
    if (seen[n]) refuse(fmt::format("nodes[{}]", n), "is reached twice: it has two parents or is its own ancestor");
    seen[n] = true;
    const glm::dmat4 world = v.parent * local_transform(model.nodes[n]);
    append_node(model, n, world, scene);
    const std::vector<int>& children = model.nodes[n].children;
    for (auto it = children.rbegin(); it != children.rend(); ++it) stack.push_back({*it, world});
  }
}

}  // namespace assay::scene::gltf
