// Feature bits and shader class of a material, from the material's own data. What glTF has no property for is read from
// the name, by the short list below; nothing is guessed beyond it.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "harness/scene/scene.h"

namespace assay::scene {
namespace {

struct NameRule {
  const char* word;
  uint32_t bits;
};
// Leaves let light through: thin subsurface scattering.
constexpr NameRule kNameRules[] = {
    {"fabric", kFeatureCloth},     {"curtain", kFeatureCloth},      {"cloth", kFeatureCloth},
    {"leaf", kFeatureSubsurface},  {"foliage", kFeatureSubsurface}, {"grass", kFeatureSubsurface},
    {"plant", kFeatureSubsurface}, {"skin", kFeatureSkin},
};

// Mean of one channel of a metallic-roughness image, 0 to 1 (1 without an image, glTF's default).
double mean_channel(const Scene& scene, uint32_t image, uint32_t channel) {
  if (image == kNone || scene.images[image].rgba.empty()) return 1;
  const std::vector<uint8_t>& texels = scene.images[image].rgba;
  uint64_t sum = 0;
  const size_t count = texels.size() / 4;
  for (size_t i = channel; i < texels.size(); i += 4) sum += texels[i];
  return static_cast<double>(sum) / (255.0 * static_cast<double>(count));
}

// Sharp reflections are worth tracing: mostly metal, or smooth enough to mirror, on average over its texels.
bool reflective(const Scene& scene, const Material& m) {
  const double metallic = m.metallic * mean_channel(scene, m.metallic_roughness_image, 2);
  const double roughness = m.roughness * mean_channel(scene, m.metallic_roughness_image, 1);
  return metallic > 0.5 && roughness < 0.5;
}

}  // namespace

uint32_t feature_bits(const Scene& scene, const Material& m) {
  uint32_t bits = m.features | kFeatureOpaque;
  if (m.alpha == AlphaMode::masked) bits |= kFeatureMasked;
  if (m.double_sided) bits |= kFeatureDoubleSided;
  if (std::max({m.emissive.x, m.emissive.y, m.emissive.z}) > 0) bits |= kFeatureEmissive;
  if (m.base_image != kNone || m.normal_image != kNone || m.metallic_roughness_image != kNone ||
      m.occlusion_image != kNone || m.emissive_image != kNone || m.mask_image != kNone || m.detail_image != kNone)
    bits |= kFeatureTextured;
  if (reflective(scene, m)) bits |= kFeatureReflective;
  std::string name = m.name;
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const NameRule& rule : kNameRules)
    if (name.find(rule.word) != std::string::npos) bits |= rule.bits;
  return bits;
}

// A scene made by code names its classes. A file's material has the first class whose feature it has, and glTF has no
// word for two layers; what such a class samples and the material lacks reads white.
uint32_t shader_class(const Scene& scene, const Material& m) {
  if (m.shader) return *m.shader;
  const uint32_t bits = feature_bits(scene, m);
  if (bits & kFeatureCloth) return kShaderCloth;
  if (bits & kFeatureSkin) return kShaderSkin;
  if (bits & (kFeatureWetnessDrops | kFeaturePuddles)) return kShaderWet;
  if (bits & kFeatureMasked) return bits & kFeatureSubsurface ? kShaderFoliage : kShaderMasked;
  if (bits & kFeatureEmissive) return kShaderEmissiveDetail;
  return kShaderOpaque;
}

}  // namespace assay::scene
