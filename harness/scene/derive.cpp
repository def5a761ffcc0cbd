#include "harness/scene/derive.h"

#include <cmath>

namespace assay::scene {
namespace {

glm::dvec3 perpendicular(const glm::dvec3& n) {
  return normalize(cross(n, std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
}

}  // namespace

void derive_flat_normals(Mesh& mesh, uint32_t first_index, uint32_t index_count) {
  for (uint32_t i = first_index; i < first_index + index_count; i += 3) {
    const uint32_t* v = &mesh.indices[i];
    const glm::dvec3 a(mesh.positions[v[0]]), b(mesh.positions[v[1]]), c(mesh.positions[v[2]]);
    const glm::dvec3 n = cross(b - a, c - a);
    const double size = length(n);
    const glm::vec3 normal = size > 0 && std::isfinite(size) ? glm::vec3(n / size) : glm::vec3(0, 1, 0);
    for (int k = 0; k < 3; ++k) mesh.attributes[v[k]].normal = normal;
  }
}

void derive_tangents(Mesh& mesh, const std::vector<bool>& marked) {
  // With edges e1, e2 and UV edges (u1, v1), (u2, v2): the gradient of u is (e1 v2 - e2 v1) / (u1 v2 - u2 v1); without
  // the division it is weighted by UV area, and the determinant's sign tells the handedness.
  std::vector<glm::dvec3> along(mesh.positions.size(), glm::dvec3(0));
  std::vector<double> handed(mesh.positions.size(), 0);
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const uint32_t* v = &mesh.indices[i];
    if (!marked[v[0]] && !marked[v[1]] && !marked[v[2]]) continue;
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[v[1]]) - glm::dvec3(mesh.positions[v[0]]);
    const glm::dvec3 e2 = glm::dvec3(mesh.positions[v[2]]) - glm::dvec3(mesh.positions[v[0]]);
    const glm::dvec2 t1 = glm::dvec2(mesh.attributes[v[1]].uv) - glm::dvec2(mesh.attributes[v[0]].uv);
    const glm::dvec2 t2 = glm::dvec2(mesh.attributes[v[2]].uv) - glm::dvec2(mesh.attributes[v[0]].uv);
    const double det = t1.x * t2.y - t2.x * t1.y;
    const glm::dvec3 gradient = (e1 * t2.y - e2 * t1.y) * (det < 0 ? -1.0 : 1.0);
    for (int k = 0; k < 3; ++k) along[v[k]] += gradient, handed[v[k]] += det;
  }
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!marked[i]) continue;
    const glm::dvec3 n(mesh.attributes[i].normal);
    glm::dvec3 t = along[i] - n * dot(n, along[i]);
    const double size = length(t);
    t = size > 1e-12 * (length(along[i]) + 1e-30) && std::isfinite(size) && size > 0 ? t / size : perpendicular(n);
    // glTF's v runs down the image, its bitangent up: a texture seen the right way round has det < 0 and w = +1.
    mesh.attributes[i].tangent = glm::vec4(glm::vec3(t), handed[i] > 0 ? -1.0f : 1.0f);
  }
}

}  // namespace assay::scene
