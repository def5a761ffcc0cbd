#include "harness/scene/gltf.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

namespace assay::scene {

Scene load_gltf(const std::filesystem::path& file) {
  Scene scene;
  scene.name = file.stem().string();
  naming(file, [&] {
    const tinygltf::Model model = gltf::read(file, scene.notes);
    gltf::append_images(model, scene);
    gltf::append_materials(model, scene);
    gltf::append_meshes(model, scene);
    gltf::append_nodes(model, scene);
    if (!model.animations.empty())
      scene.notes.push_back(fmt::format("{} animations are left out", model.animations.size()));
    if (scene.instances.empty()) refuse("scene", "no node shows a mesh with triangles");
  });
  return scene;
}

}  // namespace assay::scene
