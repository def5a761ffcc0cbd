// Small glTF files made by the tests, whole and broken.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/scene/scene.h"

namespace assay::tests {

using Json = nlohmann::json;

// A document and its binary chunk.
struct Glb {
  Json doc = {{"asset", {{"version", "2.0"}}}, {"buffers", Json::array()}};
  std::string bin;

  // Appends an accessor over the values, with a view of its own, and returns its index.
  template <class T>
  int add(const std::vector<T>& values, int component_type, const std::string& type, int components,
          bool normalised = false) {
    return add_bytes(std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)),
                     component_type, type, values.size() / static_cast<size_t>(components), normalised);
  }
  int add_bytes(const std::string& bytes, int component_type, const std::string& type, size_t count, bool normalised);
  int add_view(const std::string& bytes);
};

// A quad of two triangles: positions, normals, UVs, 16-bit indices, one masked material with a 4x4 PNG, a spot light, a
// camera, a child node.
Glb quad();
std::string bytes_of(const Glb&);
// Writes under the system's folder for temporary files and loads; `suffix` names the file.
scene::Scene load_bytes(const std::string& bytes, const std::string& suffix = "test.glb");
scene::Scene load(const Glb&);
std::filesystem::path temporary(const std::string& name);

}  // namespace assay::tests
