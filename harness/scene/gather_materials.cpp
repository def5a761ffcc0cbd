// Material records of a view: factors as the scene has them, textures of what the surfaces show, and the compact
// numbers of shader classes and materials.
#include <set>

#include "harness/scene/gather.h"
#include "harness/scene/textures.h"

namespace assay::scene {
namespace {

static_assert(kNone == kNoMaterial && kNone == kNoTexture);

// Images by the way they are read, each of both formats if a scene uses it both ways.
struct Packed {
  std::set<ImageUse> uses = {};
  TextureArrays arrays = {};

  void add(const Material& m) {
    for (const uint32_t image : {m.base_image, m.emissive_image}) add(image, Format::rgba8_srgb);
    for (const uint32_t image :
         {m.normal_image, m.metallic_roughness_image, m.occlusion_image, m.mask_image, m.detail_image})
      add(image, Format::rgba8_unorm);
  }
  void add(uint32_t image, Format format) {
    if (image != kNone) uses.insert({image, format});
  }
  uint32_t name(uint32_t image, Format format) const {
    const auto it = uses.find({image, format});
    if (it == uses.end()) return kNoTexture;
    return arrays.names[static_cast<size_t>(std::distance(uses.begin(), it))];
  }
};

MaterialRecord record_of(const Scene& scene, const Material& m) {
  return {.base_colour = m.base_colour,
          .base_texture = kNoTexture,
          .alpha_cutoff = m.alpha_cutoff,
          .flags = material_flags(m),
          .features = feature_bits(scene, m),
          .emissive = m.emissive,
          .emissive_texture = kNoTexture,
          .metallic = m.metallic,
          .roughness = m.roughness,
          .metallic_roughness_texture = kNoTexture,
          .normal_texture = kNoTexture,
          .normal_scale = m.normal_scale,
          .occlusion_texture = kNoTexture,
          .occlusion_strength = m.occlusion_strength,
          .shader = shader_class(scene, m),
          .layer = m.layer,
          .mask_texture = kNoTexture,
          .blend_depth = m.blend_depth,
          .detail_texture = kNoTexture,
          .detail_scale = m.detail_scale};
}

void name_textures(const Material& m, const Packed& packed, MaterialRecord& r) {
  r.base_texture = packed.name(m.base_image, Format::rgba8_srgb);
  r.emissive_texture = packed.name(m.emissive_image, Format::rgba8_srgb);
  r.metallic_roughness_texture = packed.name(m.metallic_roughness_image, Format::rgba8_unorm);
  r.normal_texture = packed.name(m.normal_image, Format::rgba8_unorm);
  r.occlusion_texture = packed.name(m.occlusion_image, Format::rgba8_unorm);
  r.mask_texture = packed.name(m.mask_image, Format::rgba8_unorm);
  r.detail_texture = packed.name(m.detail_image, Format::rgba8_unorm);
}

void append_slots(const std::set<uint32_t>& visible, Gathered& to) {
  std::set<uint32_t> shaders;
  for (const uint32_t m : visible) shaders.insert(to.materials[m].shader);
  to.shaders.assign(shaders.begin(), shaders.end());
  const auto rank = [](const std::set<uint32_t>& of, uint32_t x) {
    return static_cast<uint32_t>(std::distance(of.begin(), of.find(x)));
  };
  for (const SurfaceRecord& s : to.surfaces)
    to.surface_slots.push_back({rank(shaders, to.materials[s.material].shader), rank(visible, s.material)});
  to.counts.visible_materials = static_cast<uint32_t>(visible.size());
}

}  // namespace

uint32_t material_flags(const Material& m) {
  uint32_t flags = m.double_sided ? kMaterialDoubleSided : 0;
  if (m.alpha == AlphaMode::masked) flags |= kMaterialMasked;
  if (m.alpha == AlphaMode::blended) flags |= kMaterialBlended;
  return flags;
}

// Indices stay the scene's; textures are those of materials that the surfaces use, of the layers on top of them, and
// of what casts shadows through holes.
void append_materials(const Scene& scene, Gathered& to) {
  std::set<uint32_t> visible;
  for (const SurfaceRecord& s : to.surfaces) visible.insert(s.material);
  std::set<uint32_t> textured = visible;
  for (const uint32_t m : visible)
    if (scene.materials[m].layer != kNone) textured.insert(scene.materials[m].layer);
  for (const ShadowCaster& c : to.shadow_casters)
    if (scene.materials[c.material].alpha == AlphaMode::masked) textured.insert(c.material);
  Packed packed;
  for (const uint32_t m : textured) packed.add(scene.materials[m]);
  packed.arrays = pack_textures(scene, {packed.uses.begin(), packed.uses.end()});
  for (uint32_t m = 0; m < scene.materials.size(); ++m) {
    to.materials.push_back(record_of(scene, scene.materials[m]));
    if (textured.contains(m)) name_textures(scene.materials[m], packed, to.materials[m]);
  }
  to.textures = std::move(packed.arrays.textures);
  append_slots(visible, to);
}

}  // namespace assay::scene
