#include "tests/glb.h"

#include <unistd.h>

#include <fmt/format.h>
#include <fstream>

#include "harness/image/image.h"

namespace assay::tests {
namespace {

void append_word(std::string& to, uint64_t value) {
  const auto word = static_cast<uint32_t>(value);
  to.append(reinterpret_cast<const char*>(&word), 4);
}

std::string png_bytes() {
  image::Rgba8 texels = {4, 4, {}};
  for (int i = 0; i < 16; ++i)
    texels.texels.insert(texels.texels.end(),
                         {200, static_cast<uint8_t>(10 * i), 30, static_cast<uint8_t>(i < 8 ? 255 : 0)});
  const std::filesystem::path file = temporary("texture.png");
  image::write_png(file, texels);
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::filesystem::remove(file);
  return bytes;
}

}  // namespace

int Glb::add_view(const std::string& bytes) {
  bin.resize((bin.size() + 3) / 4 * 4);
  doc["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}});
  bin += bytes;
  return static_cast<int>(doc["bufferViews"].size()) - 1;
}

int Glb::add_bytes(const std::string& bytes, int component_type, const std::string& type, size_t count,
                   bool normalised) {
  const int view = add_view(bytes);
  Json accessor = {{"bufferView", view}, {"componentType", component_type}, {"type", type}, {"count", count}};
  if (normalised) accessor["normalized"] = true;
  doc["accessors"].push_back(accessor);
  return static_cast<int>(doc["accessors"].size()) - 1;
}

Glb quad() {
  Glb g;
  const int position = g.add<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 5126, "VEC3", 3);
  const int normal = g.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 3);
  const int uv = g.add<float>({0, 1, 1, 1, 1, 0, 0, 0}, 5126, "VEC2", 2);
  const int index = g.add<uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 1);
  g.doc["images"] = {{{"bufferView", g.add_view(png_bytes())}, {"mimeType", "image/png"}}};
  g.doc["samplers"] = {{{"wrapS", 10497}, {"wrapT", 10497}}};
  g.doc["textures"] = {{{"source", 0}, {"sampler", 0}}};
  g.doc["materials"] = {{{"name", "leaf"},
                         {"alphaMode", "MASK"},
                         {"alphaCutoff", 0.25},
                         {"doubleSided", true},
                         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}}}};
  g.doc["meshes"] = {{{"name", "quad"},
                      {"primitives",
                       {{{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}},
                         {"indices", index},
                         {"material", 0}}}}}};
  g.doc["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.05}}}}};
  g.doc["extensionsUsed"] = {"KHR_lights_punctual"};
  g.doc["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"},
                                                           {"intensity", 7},
                                                           {"range", 9},
                                                           {"color", {1, 0.5, 0.25}},
                                                           {"spot", {{"outerConeAngle", 0.6}}}}};
  g.doc["nodes"] = {
      {{"mesh", 0}, {"children", {1, 2}}, {"translation", {10, 0, 0}}},
      {{"camera", 0}, {"translation", {0, 0, 5}}},
      {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"rotation", {-0.70710678, 0, 0, 0.70710678}}}};
  g.doc["scenes"] = {{{"nodes", {0}}}};
  g.doc["scene"] = 0;
  return g;
}

std::string bytes_of(const Glb& g) {
  Json doc = g.doc;
  std::string bin = g.bin;
  bin.resize((bin.size() + 3) / 4 * 4);
  if (doc["buffers"].empty()) doc["buffers"] = {{{"byteLength", bin.size()}}};
  std::string text = doc.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string out = "glTF";
  append_word(out, 2);
  append_word(out, 12 + 8 + text.size() + 8 + bin.size());
  append_word(out, text.size());
  append_word(out, 0x4e4f534a);
  out += text;
  append_word(out, bin.size());
  append_word(out, 0x004e4942);
  return out + bin;
}

std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::temp_directory_path() / fmt::format("assay-{}-{}", getpid(), name);
}

scene::Scene load_bytes(const std::string& bytes, const std::string& suffix) {
  const std::filesystem::path file = temporary(suffix);
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  struct Remove {
    const std::filesystem::path& file;
    ~Remove() { std::filesystem::remove(file); }
  } remove{file};
  return scene::load_gltf(file);
}

scene::Scene load(const Glb& g) { return load_bytes(bytes_of(g)); }

}  // namespace assay::tests
