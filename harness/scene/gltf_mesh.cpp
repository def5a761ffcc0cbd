// Primitives to meshes: one mesh a glTF mesh, one part a primitive that makes triangles.
#include <fmt/format.h>
#include <tiny_gltf.h>
#include <map>

#include "harness/scene/derive.h"
#include "harness/scene/gltf.h"

namespace assay::scene::gltf {
namespace {

// The accessors that a run of vertices came from; primitives that name the same share the vertices.
struct VertexSource {
  int position = -1, normal = -1, tangent = -1, uv = -1;
  auto operator<=>(const VertexSource&) const = default;
};

struct MeshBuilder {
  const tinygltf::Model& model;
  Scene& scene;
  Mesh mesh = {};
  std::vector<bool> lacks_tangent = {};
  std::map<VertexSource, std::pair<uint32_t, uint32_t>> runs = {};  // first vertex and count of sources with normals
};

int attribute(const tinygltf::Primitive& p, const std::string& name) {
  const auto it = p.attributes.find(name);
  return it == p.attributes.end() ? -1 : it->second;
}

// The UV set that the material's base colour reads; the others' own sets are a note of the material's.
int uv_accessor(const tinygltf::Model& model, const tinygltf::Primitive& p) {
  int set = 0;
  if (p.material >= 0) {
    const tinygltf::TextureInfo& base =
        model.materials[static_cast<size_t>(p.material)].pbrMetallicRoughness.baseColorTexture;
    if (base.index >= 0) set = base.texCoord;
  }
  return attribute(p, fmt::format("TEXCOORD_{}", set));
}

void check_size(size_t got, size_t wanted, const std::string& place) {
  if (got != wanted) refuse(place, fmt::format("has {} elements, POSITION has {}", got, wanted));
}

void append_vertices(MeshBuilder& b, const VertexSource& source, const std::string& place) {
  const std::vector<float> position = read_floats(b.model, source.position, 3, place + ".POSITION");
  const size_t first = b.mesh.positions.size(), count = position.size() / 3;
  std::vector<float> normal, tangent, uv;
  if (source.normal >= 0) {
    check_size((normal = read_floats(b.model, source.normal, 3, place + ".NORMAL")).size(), count * 3,
               place + ".NORMAL");
  }
  if (source.tangent >= 0 && source.normal >= 0)
    check_size((tangent = read_floats(b.model, source.tangent, 4, place + ".TANGENT")).size(), count * 4,
               place + ".TANGENT");
  if (source.uv >= 0)
    check_size((uv = read_floats(b.model, source.uv, 2, place + ".TEXCOORD")).size(), count * 2, place + ".TEXCOORD");
  b.mesh.positions.resize(first + count);
  b.mesh.attributes.resize(first + count, {{0, 1, 0}, {1, 0, 0, 1}, {0, 0}});
  b.lacks_tangent.resize(first + count, tangent.empty());
  for (size_t i = 0; i < count; ++i) {
    VertexAttributes& a = b.mesh.attributes[first + i];
    b.mesh.positions[first + i] = {position[3 * i], position[3 * i + 1], position[3 * i + 2]};
    if (!uv.empty()) a.uv = {uv[2 * i], uv[2 * i + 1]};
    if (!tangent.empty()) {
      a.tangent = {tangent[4 * i], tangent[4 * i + 1], tangent[4 * i + 2], tangent[4 * i + 3] < 0 ? -1.0f : 1.0f};
    }
    if (normal.empty()) continue;
    const glm::vec3 n = {normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]};
    const float size = glm::length(n);  // quantised normals are only roughly of unit length
    if (size > 0) a.normal = n / size;
  }
}

// Vertex numbers of the primitive's triangles, three each, in the file's order.
std::vector<uint32_t> triangles(const tinygltf::Primitive& p, std::vector<uint32_t> v, const std::string& place) {
  if (p.mode == TINYGLTF_MODE_TRIANGLES) {
    if (v.size() % 3) refuse(place, fmt::format("{} vertices do not make whole triangles", v.size()));
    return v;
  }
  std::vector<uint32_t> out;
  for (size_t i = 2; i < v.size(); ++i) {
    const bool fan = p.mode == TINYGLTF_MODE_TRIANGLE_FAN, odd = i % 2;
    const uint32_t a = fan ? v[0] : v[odd ? i - 1 : i - 2], b = fan ? v[i - 1] : v[odd ? i - 2 : i - 1];
    out.insert(out.end(), {a, b, v[i]});
  }
  return out;
}

uint32_t material_of(MeshBuilder& b, const tinygltf::Primitive& p) {
  if (p.material >= 0) return static_cast<uint32_t>(p.material);
  if (b.scene.materials.size() == b.model.materials.size()) b.scene.materials.push_back({.name = "default"});
  return static_cast<uint32_t>(b.scene.materials.size() - 1);
}

// glTF asks for flat normals where there are none: every triangle gets vertices of its own.
void append_split(MeshBuilder& b, const VertexSource& source, const std::vector<uint32_t>& corners,
                  const std::string& place) {
  MeshBuilder whole = {b.model, b.scene};
  append_vertices(whole, source, place);
  const auto first = static_cast<uint32_t>(b.mesh.indices.size());
  for (const uint32_t v : corners) {
    b.mesh.indices.push_back(static_cast<uint32_t>(b.mesh.positions.size()));
    b.mesh.positions.push_back(whole.mesh.positions[v]);
    b.mesh.attributes.push_back(whole.mesh.attributes[v]);
    b.lacks_tangent.push_back(true);
  }
  derive_flat_normals(b.mesh, first, static_cast<uint32_t>(corners.size()));
}

void append_shared(MeshBuilder& b, const VertexSource& source, const std::vector<uint32_t>& corners,
                   const std::string& place) {
  const auto [it, is_new] = b.runs.try_emplace(source);
  if (is_new) {
    const auto first = static_cast<uint32_t>(b.mesh.positions.size());
    append_vertices(b, source, place);
    it->second = {first, static_cast<uint32_t>(b.mesh.positions.size()) - first};
  }
  for (const uint32_t v : corners) b.mesh.indices.push_back(it->second.first + v);
}

void append_primitive(MeshBuilder& b, const tinygltf::Primitive& p, const std::string& place) {
  const VertexSource source = {attribute(p, "POSITION"), attribute(p, "NORMAL"), attribute(p, "TANGENT"),
                               uv_accessor(b.model, p)};
  if (p.mode < TINYGLTF_MODE_POINTS || p.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    refuse(place, fmt::format("mode {} is not known", p.mode));
  if (p.mode < TINYGLTF_MODE_TRIANGLES || source.position < 0) {
    b.scene.notes.push_back(
        fmt::format("{} is left out: {}", place, source.position < 0 ? "it has no POSITION" : "points or lines"));
    return;
  }
  if (!p.targets.empty()) b.scene.notes.push_back(place + ": morph targets are left out");
  const tinygltf::Accessor& positions = b.model.accessors[static_cast<size_t>(source.position)];
  const size_t count = positions.count;
  if (positions.type != TINYGLTF_TYPE_VEC3) refuse(place + ".POSITION", "does not have 3 components");
  std::vector<uint32_t> vertices;
  if (p.indices >= 0) {
    vertices = read_indices(b.model, p.indices, place + ".indices");
  } else {
    read_floats(b.model, source.position, 3, place + ".POSITION");  // checks the count before as many are numbered
    for (uint32_t i = 0; i < count; ++i) vertices.push_back(i);
  }
  for (size_t i = 0; i < vertices.size(); ++i)
    if (vertices[i] >= count)
      refuse(place + ".indices",
             fmt::format("index {} at {} is out of range, there are {} vertices", vertices[i], i, count));
  const std::vector<uint32_t> corners = triangles(p, std::move(vertices), place);
  if (corners.empty()) {
    b.scene.notes.push_back(place + " is left out: it has no triangles");
    return;
  }
  const auto first = static_cast<uint32_t>(b.mesh.indices.size());
  if (source.normal >= 0)
    append_shared(b, source, corners, place);
  else
    append_split(b, source, corners, place);
  b.mesh.parts.push_back({first, static_cast<uint32_t>(corners.size()), material_of(b, p)});
}

}  // namespace

void append_meshes(const tinygltf::Model& model, Scene& scene) {
  for (size_t m = 0; m < model.meshes.size(); ++m) {
    MeshBuilder b = {model, scene};
    b.mesh.name = model.meshes[m].name;
    for (size_t p = 0; p < model.meshes[m].primitives.size(); ++p)
      append_primitive(b, model.meshes[m].primitives[p], fmt::format("meshes[{}].primitives[{}]", m, p));
    derive_tangents(b.mesh, b.lacks_tangent);
    scene.meshes.push_back(std::move(b.mesh));
  }
}

}  // namespace assay::scene::gltf
