// Inside of the glTF loader: reading and checking the file, then one function a subject. Errors are std::runtime_error,
// one line: file, place in the document, what.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "harness/scene/json_file.h"
#include "harness/scene/scene.h"

namespace tinygltf {
class Model;
struct Accessor;
struct Material;
struct Primitive;
}  // namespace tinygltf

namespace assay::scene::gltf {

// The document with every reference and every byte range in it checked; images are still encoded.
tinygltf::Model read(const std::filesystem::path&, std::vector<std::string>& notes);

// `components` floats an element, integers normalised where the accessor says so, sparse elements laid over.
std::vector<float> read_floats(const tinygltf::Model&, int accessor, int components, const std::string& place);
std::vector<uint32_t> read_indices(const tinygltf::Model&, int accessor, const std::string& place);

void append_images(const tinygltf::Model&, Scene&);
void append_materials(const tinygltf::Model&, Scene&);  // glTF's default material comes last, if any primitive needs it
void append_meshes(const tinygltf::Model&, Scene&);
void append_nodes(const tinygltf::Model&, Scene&);  // instances, lights and cameras of the default scene

}  // namespace assay::scene::gltf
