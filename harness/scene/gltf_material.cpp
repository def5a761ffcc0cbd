// Images and materials.
#include <fmt/format.h>
#include <tiny_gltf.h>
#include <set>

#include "harness/image/image.h"
#include "harness/scene/gltf.h"

namespace assay::scene::gltf {
namespace {

bool is_png(const std::vector<unsigned char>& bytes) {
  return bytes.size() >= 4 && bytes[0] == 0x89 && bytes[1] == 'P' && bytes[2] == 'N' && bytes[3] == 'G';
}

Image decode(const tinygltf::Image& from, size_t index) {
  const std::string place = fmt::format("images[{}]{}", index, from.uri.empty() ? "" : " (" + from.uri + ")");
  if (is_png(from.image)) {
    try {
      image::Rgba8 png = image::decode_png(from.image);
      return {from.name, png.width, png.height, std::move(png.texels)};
    } catch (const std::exception& e) {
      refuse(place, e.what());
    }
  }
  tinygltf::Image jpeg;
  std::string error, warning;
  const int size = static_cast<int>(from.image.size());
  if (!tinygltf::LoadImageData(&jpeg, static_cast<int>(index), &error, &warning, 0, 0, from.image.data(), size,
                               nullptr) ||
      jpeg.component != 4 || jpeg.bits != 8)
    refuse(place, "is neither a whole PNG nor a whole JPEG image");
  return {from.name, static_cast<uint32_t>(jpeg.width), static_cast<uint32_t>(jpeg.height), std::move(jpeg.image)};
}

// The image behind a texture reference; a texture without a source (its image is an extension's) counts as none.
uint32_t image_of(const tinygltf::Model& model, int texture) {
  if (texture < 0) return kNone;
  const int source = model.textures[static_cast<size_t>(texture)].source;
  return source < 0 ? kNone : static_cast<uint32_t>(source);
}

glm::vec3 vec3_of(const std::vector<double>& v) {
  return v.size() == 3 ? glm::vec3(glm::dvec3(v[0], v[1], v[2])) : glm::vec3(0);
}

float emissive_strength(const tinygltf::Material& m) {
  const auto it = m.extensions.find("KHR_materials_emissive_strength");
  if (it == m.extensions.end() || !it->second.Has("emissiveStrength")) return 1;
  return static_cast<float>(it->second.Get("emissiveStrength").GetNumberAsDouble());
}

AlphaMode alpha_mode(const tinygltf::Material& m, const std::string& place) {
  if (m.alphaMode == "MASK") return AlphaMode::masked;
  if (m.alphaMode == "BLEND") return AlphaMode::blended;
  if (m.alphaMode != "OPAQUE") refuse(place, fmt::format("alphaMode \"{}\" is not known", m.alphaMode));
  return AlphaMode::opaque;
}

void note_uv_sets(const tinygltf::Material& m, const std::string& place, Scene& scene) {
  const tinygltf::PbrMetallicRoughness& pbr = m.pbrMetallicRoughness;
  std::set<int> sets;
  if (pbr.baseColorTexture.index >= 0) sets.insert(pbr.baseColorTexture.texCoord);
  if (pbr.metallicRoughnessTexture.index >= 0) sets.insert(pbr.metallicRoughnessTexture.texCoord);
  if (m.normalTexture.index >= 0) sets.insert(m.normalTexture.texCoord);
  if (m.occlusionTexture.index >= 0) sets.insert(m.occlusionTexture.texCoord);
  if (m.emissiveTexture.index >= 0) sets.insert(m.emissiveTexture.texCoord);
  if (sets.size() > 1)
    scene.notes.push_back(place + ": its textures use several UV sets, base colour's is used for all");
}

void check_finite(const std::vector<double>& values, const std::string& place) {
  for (const double v : values)
    if (!std::isfinite(static_cast<float>(v))) refuse(place, "a factor is not finite");
}

}  // namespace

void append_images(const tinygltf::Model& model, Scene& scene) {
  for (size_t i = 0; i < model.images.size(); ++i) scene.images.push_back(decode(model.images[i], i));
  std::set<size_t> unlike;
  for (const tinygltf::Texture& t : model.textures)
    if (t.sampler >= 0) {
      const tinygltf::Sampler& s = model.samplers[static_cast<size_t>(t.sampler)];
      if (s.wrapS != TINYGLTF_TEXTURE_WRAP_REPEAT || s.wrapT != TINYGLTF_TEXTURE_WRAP_REPEAT)
        unlike.insert(static_cast<size_t>(t.sampler));
    }
  for (const size_t s : unlike)
    scene.notes.push_back(fmt::format("samplers[{}]: textures are sampled with repeat in place of its wrap modes", s));
}

void append_materials(const tinygltf::Model& model, Scene& scene) {
  for (size_t i = 0; i < model.materials.size(); ++i) {
    const tinygltf::Material& from = model.materials[i];
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    const std::string place = fmt::format("materials[{}]", i);
    check_finite(pbr.baseColorFactor, place);
    check_finite({pbr.metallicFactor, pbr.roughnessFactor, from.alphaCutoff, from.normalTexture.scale,
                  from.occlusionTexture.strength},
                 place);
    check_finite(from.emissiveFactor, place);
    const std::vector<double>& c = pbr.baseColorFactor;
    Material m = {.name = from.name.empty() ? place : from.name};
    if (c.size() == 4) m.base_colour = glm::vec4(glm::dvec4(c[0], c[1], c[2], c[3]));
    m.metallic = static_cast<float>(pbr.metallicFactor);
    m.roughness = static_cast<float>(pbr.roughnessFactor);
    m.emissive = vec3_of(from.emissiveFactor) * emissive_strength(from);
    m.base_image = image_of(model, pbr.baseColorTexture.index);
    m.normal_image = image_of(model, from.normalTexture.index);
    m.metallic_roughness_image = image_of(model, pbr.metallicRoughnessTexture.index);
    m.occlusion_image = image_of(model, from.occlusionTexture.index);
    m.emissive_image = image_of(model, from.emissiveTexture.index);
    m.normal_scale = static_cast<float>(from.normalTexture.scale);
    m.occlusion_strength = static_cast<float>(from.occlusionTexture.strength);
    m.alpha = alpha_mode(from, place);
    m.alpha_cutoff = static_cast<float>(from.alphaCutoff);
    m.double_sided = from.doubleSided;
    if (from.extensions.count("KHR_materials_sheen")) m.features |= kFeatureCloth;  // glTF's own word for cloth
    note_uv_sets(from, place, scene);
    scene.materials.push_back(std::move(m));
  }
}

}  // namespace assay::scene::gltf
