#include <fmt/format.h>
#include <stdexcept>

#include "harness/scene/scene.h"

namespace assay::scene {
namespace {

Scene load_file(const std::string& name_or_file, bool neighbour) {
  if (!std::filesystem::is_regular_file(name_or_file))
    throw std::runtime_error(
        fmt::format("{}: no such scene; give a .gltf or .glb file, or bare, small or default", name_or_file));
  Scene scene = load_gltf(name_or_file);
  std::filesystem::path beside = name_or_file;
  beside.replace_extension(".lights.json");
  if (neighbour && std::filesystem::exists(beside)) append_sidecar(beside, scene);
  return scene;
}

}  // namespace

Scene load(const std::string& name_or_file, const std::filesystem::path& sidecar) {
  Scene scene = name_or_file == "bare"      ? bare()
                : name_or_file == "small"   ? small()
                : name_or_file == "default" ? default_scene()
                                            : load_file(name_or_file, sidecar.empty());
  if (!sidecar.empty()) append_sidecar(sidecar, scene);
  return scene;
}

}  // namespace assay::scene
