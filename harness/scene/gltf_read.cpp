// The file, its JSON and its references, checked before any library walks them: tinygltf trusts byte ranges of images
// and nests as deep as the document does.
#include <fmt/format.h>
#include <tiny_gltf.h>

#include "harness/scene/gltf.h"

namespace assay::scene::gltf {
namespace {

using Json = nlohmann::json;

// A reference's path, '*' for any element or member, and the array that it points into.
struct Reference {
  const char *path, *target;
};
constexpr Reference kReferences[] = {
    {"scene", "scenes"},
    {"scenes/*/nodes/*", "nodes"},
    {"nodes/*/children/*", "nodes"},
    {"nodes/*/mesh", "meshes"},
    {"nodes/*/camera", "cameras"},
    {"nodes/*/skin", "skins"},
    {"nodes/*/extensions/KHR_lights_punctual/light", "extensions/KHR_lights_punctual/lights"},
    {"meshes/*/primitives/*/indices", "accessors"},
    {"meshes/*/primitives/*/material", "materials"},
    {"meshes/*/primitives/*/attributes/*", "accessors"},
    {"meshes/*/primitives/*/targets/*/*", "accessors"},
    {"accessors/*/bufferView", "bufferViews"},
    {"accessors/*/sparse/indices/bufferView", "bufferViews"},
    {"accessors/*/sparse/values/bufferView", "bufferViews"},
    {"bufferViews/*/buffer", "buffers"},
    {"images/*/bufferView", "bufferViews"},
    {"textures/*/source", "images"},
    {"textures/*/sampler", "samplers"},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/index", "textures"},
    {"materials/*/pbrMetallicRoughness/metallicRoughnessTexture/index", "textures"},
    {"materials/*/normalTexture/index", "textures"},
    {"materials/*/occlusionTexture/index", "textures"},
    {"materials/*/emissiveTexture/index", "textures"},
};

// What the format wants where: the library skips what has another type, and so would a typing error go unseen.
struct Shape {
  const char* path;
  Json::value_t type;
};
constexpr Shape kShapes[] = {
    {"asset", Json::value_t::object},
    {"scenes", Json::value_t::array},
    {"scenes/*/nodes", Json::value_t::array},
    {"nodes", Json::value_t::array},
    {"nodes/*/children", Json::value_t::array},
    {"meshes", Json::value_t::array},
    {"meshes/*/primitives", Json::value_t::array},
    {"meshes/*/primitives/*/attributes", Json::value_t::object},
    {"accessors", Json::value_t::array},
    {"bufferViews", Json::value_t::array},
    {"buffers", Json::value_t::array},
    {"images", Json::value_t::array},
    {"textures", Json::value_t::array},
    {"samplers", Json::value_t::array},
    {"materials", Json::value_t::array},
    {"cameras", Json::value_t::array},
    {"extensions/KHR_lights_punctual/lights", Json::value_t::array},
    {"extensionsUsed", Json::value_t::array},
    {"extensionsRequired", Json::value_t::array},
};

struct Found {
  const Json* value;
  std::string place;  // meshes[3].primitives[0].indices
};

// Everything in the document that a path with '*' names.
std::vector<Found> find(const Json& root, std::string_view path) {
  std::vector<Found> found = {{&root, ""}};
  while (!path.empty()) {
    const size_t slash = path.find('/');
    const std::string step(path.substr(0, slash));
    path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
    std::vector<Found> next;
    for (const Found& f : found) {
      const auto member = [&](const std::string& name) {
        return f.place.empty() ? name : fmt::format("{}.{}", f.place, name);
      };
      if (step != "*") {
        if (f.value->is_object() && f.value->contains(step)) next.push_back({&(*f.value)[step], member(step)});
      } else if (f.value->is_array()) {
        for (size_t i = 0; i < f.value->size(); ++i)
          next.push_back({&(*f.value)[i], fmt::format("{}[{}]", f.place, i)});
      } else if (f.value->is_object()) {
        for (const auto& [name, value] : f.value->items()) next.push_back({&value, member(name)});
      }
    }
    found = std::move(next);
  }
  return found;
}

// A non-negative integer below 2^53, or its default where the member is absent.
uint64_t number(const Json& object, const std::string& place, const char* name, std::optional<uint64_t> absent) {
  if (!object.contains(name)) {
    if (!absent) refuse(place, fmt::format("{} is missing", name));
    return *absent;
  }
  const Json& v = object[name];
  if (!v.is_number_integer() || v.get<double>() < 0 || v.get<double>() > 9e15)
    refuse(place, fmt::format("{} is not a size: {}", name, v.dump()));
  return v.get<uint64_t>();
}

void check_shapes(const Json& doc) {
  for (const Shape& shape : kShapes)
    for (const Found& f : find(doc, shape.path))
      if (f.value->type() != shape.type)
        refuse(f.place, shape.type == Json::value_t::array ? "is not an array" : "is not an object");
  for (const char* list :
       {"scenes", "nodes", "meshes", "meshes/*/primitives", "accessors", "bufferViews", "buffers", "images", "textures",
        "samplers", "materials", "cameras", "extensions/KHR_lights_punctual/lights"})
    for (const Found& f : find(doc, std::string(list) + "/*"))
      if (!f.value->is_object()) refuse(f.place, "is not an object");
}

void check_references(const Json& doc) {
  for (const Reference& r : kReferences) {
    const std::vector<Found> targets = find(doc, r.target);
    const uint64_t count = targets.empty() ? 0 : targets[0].value->size();
    for (const Found& f : find(doc, r.path)) {
      const bool whole = f.value->is_number_integer() && f.value->get<double>() >= 0;
      if (!whole) refuse(f.place, "is not an index");
      const uint64_t index = f.value->get<uint64_t>();
      if (index >= count) refuse(f.place, fmt::format("{} is out of range, there are {} {}", index, count, r.target));
    }
  }
}

// `chunk`: bytes of a .glb's binary chunk, which is the buffer that has no address.
void check_buffers(const Json& doc, size_t chunk) {
  for (const Found& f : find(doc, "buffers/*")) {
    const uint64_t bytes = number(*f.value, f.place, "byteLength", {});
    if (!f.value->contains("uri") && bytes > chunk)
      refuse(f.place, fmt::format("byteLength is {}, the file's binary chunk has {}", bytes, chunk));
  }
}

void check_views(const Json& doc) {
  for (const Found& f : find(doc, "bufferViews/*")) {
    const Json& view = *f.value;
    const uint64_t buffer = number(view, f.place, "buffer", {});
    const uint64_t have = number(doc["buffers"][buffer], fmt::format("buffers[{}]", buffer), "byteLength", {});
    const uint64_t end = number(view, f.place, "byteOffset", 0) + number(view, f.place, "byteLength", {});
    if (end > have) refuse(f.place, fmt::format("ends at byte {}, its buffer has {}", end, have));
    if (number(view, f.place, "byteStride", 4) > 252) refuse(f.place, "byteStride is over 252");
  }
  for (const Found& f : find(doc, "accessors/*")) {
    number(*f.value, f.place, "count", {});
    number(*f.value, f.place, "componentType", {});
    number(*f.value, f.place, "byteOffset", 0);
  }
}

const char* kSupported[] = {"KHR_lights_punctual", "KHR_mesh_quantization", "KHR_materials_emissive_strength"};

void check_extensions(const Json& doc, std::vector<std::string>& notes) {
  const auto supported = [](const std::string& name) {
    return std::find(std::begin(kSupported), std::end(kSupported), name) != std::end(kSupported);
  };
  for (const Found& f : find(doc, "extensionsRequired/*"))
    if (!f.value->is_string() || !supported(f.value->get<std::string>()))
      refuse(f.place, fmt::format("the file requires {}, which is not supported", f.value->dump()));
  for (const Found& f : find(doc, "extensionsUsed/*"))
    if (!f.value->is_string() || !supported(f.value->get<std::string>()))
      notes.push_back(fmt::format("extension {} is left out", f.value->dump()));
}

uint32_t word(std::string_view bytes, size_t at) {
  uint32_t v;
  std::memcpy(&v, bytes.data() + at, 4);
  return v;
}

struct Chunks {
  std::string_view json;
  size_t binary = 0;  // bytes
};

// The chunks of a .glb, after their lengths were checked against the file's.
Chunks chunks_of(std::string_view bytes) {
  if (bytes.size() < 20) refuse("header", fmt::format("truncated, the file has {} bytes", bytes.size()));
  if (word(bytes, 4) != 2) refuse("header", fmt::format("glTF version {}, only 2 is read", word(bytes, 4)));
  if (word(bytes, 8) > bytes.size())
    refuse("header", fmt::format("truncated: {} bytes announced, the file has {}", word(bytes, 8), bytes.size()));
  if (word(bytes, 16) != 0x4e4f534a) refuse("byte 16", "the first chunk is not JSON");
  const size_t json = word(bytes, 12), next = 20 + json;
  if (next > bytes.size()) refuse("byte 12", "the JSON chunk is longer than the file");
  if (next + 8 > bytes.size()) return {bytes.substr(20, json)};
  if (word(bytes, next) > bytes.size() - next - 8)
    refuse(fmt::format("byte {}", next), "the binary chunk is longer than the file");
  return {bytes.substr(20, json), word(bytes, next)};
}

std::string one_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

// Keeps the encoded bytes: pictures are decoded later, where an error can name its place.
bool keep_encoded(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
                  int size, void*) {
  image->image.assign(bytes, bytes + size);
  return true;
}

}  // namespace

tinygltf::Model read(const std::filesystem::path& file, std::vector<std::string>& notes) {
  const std::string bytes = read_file(file);
  const bool binary = bytes.compare(0, 4, "glTF") == 0;
  const Chunks chunks = binary ? chunks_of(bytes) : Chunks{bytes};
  const Json doc = parse_json(chunks.json);
  check_shapes(doc);
  check_extensions(doc, notes);
  check_references(doc);
  check_buffers(doc, chunks.binary);
  check_views(doc);

  tinygltf::TinyGLTF library;
  library.SetImageLoader(keep_encoded, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const std::string folder = file.parent_path().string();
  const auto size = static_cast<unsigned>(bytes.size());
  const bool ok = binary
                      ? library.LoadBinaryFromMemory(&model, &error, &warning,
                                                     reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                      : library.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder);
  if (!ok) refuse("glTF", one_line(error.empty() ? "cannot be read" : error));
  for (size_t i = 0; i < model.images.size(); ++i)
    if (model.images[i].image.empty())
      refuse(fmt::format("images[{}]", i), fmt::format("{} is missing or empty", model.images[i].uri));
  for (size_t i = 0; i < model.buffers.size(); ++i) {
    const uint64_t wanted = number(doc["buffers"][i], fmt::format("buffers[{}]", i), "byteLength", {});
    if (model.buffers[i].data.size() < wanted)
      refuse(fmt::format("buffers[{}]", i), fmt::format("has {} of {} bytes", model.buffers[i].data.size(), wanted));
  }
  return model;
}

}  // namespace assay::scene::gltf
