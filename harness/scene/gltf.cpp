#include "harness/scene/gltf.h"

#include <fmt/format.h>
#include <tiny_gltf.h>
#include <algorithm>
#include <stdexcept>

namespace assay::scene {

Scene load_gltf(const std::filesystem::path& file) {
  try {
    Scene scene;
    scene.name = file.stem().string();
    const tinygltf::Model model = gltf::read(file, scene.notes);
    gltf::append_images(model, scene);
    gltf::append_materials(model, scene);
    gltf::append_meshes(model, scene);
    gltf::append_nodes(model, scene);
    if (!model.animations.empty())
      scene.notes.push_back(fmt::format("{} animations are left out", model.animations.size()));
    if (scene.instances.empty()) gltf::refuse("scene", "no node shows a mesh with triangles");
    return scene;
  } catch (const std::exception& e) {  // the library's own exceptions too, and running out of memory
    std::string what = e.what();
    for (char& c : what)
      if (c == '\n' || c == '\r') c = ' ';
    throw std::runtime_error(fmt::format("{}: {}", file.string(), what));
  }
}

}  // namespace assay::scene
