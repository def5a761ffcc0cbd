// Hard cases of what materials and their classes come to.
#include <limits>

#include "harness/formats/features.h"
#include "harness/formats/visibility.h"
#include "kernels/deferred_texturing/inputs.h"

namespace assay::deferred_texturing {

namespace {

constexpr Extent kExtent = {40, 36};
constexpr Rectangle kAll = {0, 0, 40, 36};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// Constant textures, for values that can be told apart whatever the filter: 0 sRGB, 1 surface, 2 normal, 3 mask, 4
// detail.
constexpr std::array<std::array<uint32_t, 4>, 5> kTexels = {
    {{60, 130, 200, 255}, {250, 180, 90, 150}, {180, 90, 0, 255}, {160, 30, 10, 0}, {100, 160, 220, 255}}};

MaterialRecord textured(uint32_t shader) {
  MaterialRecord m = plain_material(shader);
  m.base_colour = vec4(0.9f, 0.7f, 0.8f, 1), m.base_texture = texture_name(0, 0);
  m.emissive = vec3(3, 0.5f, 20), m.emissive_texture = texture_name(0, 0);
  m.metallic = 0.8f, m.roughness = 0.9f, m.metallic_roughness_texture = texture_name(1, 0);
  m.normal_texture = texture_name(2, 0), m.normal_scale = 0.7f;
  m.occlusion_texture = texture_name(3, 0), m.occlusion_strength = 0.6f;
  m.mask_texture = texture_name(3, 0), m.detail_texture = texture_name(4, 0);
  m.features = kFeatureOpaque | kFeatureTextured;
  return m;
}

Frame tilted() {
  Frame f;
  f.normal = glm::normalize(glm::dvec3(1, 2, -2));
  f.tangent = glm::normalize(glm::dvec3(2, 0, 1));
  return f;
}

Builder one(const MaterialRecord& m) {
  Builder b(kExtent);
  for (size_t i = 0; i < kTexels.size(); ++i)
    b.textures.push_back(constant_texture(i == 0 ? Format::rgba8_srgb : Format::rgba8_unorm, kTexels[i]));
  b.add_sheet(kAll, b.add_material(m), uv_by_pixel(kAll, vec2(0.03f)), tilted());
  return b;
}

// Two layers that differ in everything, mixed by a mask that rises to the right.
Builder two_layers(float depth, uint32_t lower_height, uint32_t upper_height) {
  MaterialRecord lower = textured(kShaderTwoLayer), upper = textured(kShaderOpaque);
  lower.blend_depth = depth, lower.layer = 1, lower.mask_texture = texture_name(7, 0);
  upper.base_colour = vec4(0.1f, 0.9f, 0.2f, 1), upper.metallic = 0.1f, upper.roughness = 0.3f;
  upper.emissive = vec3(0, 9, 0), upper.normal_texture = kNoTexture, upper.occlusion_strength = 0;
  lower.metallic_roughness_texture = texture_name(5, 0), upper.metallic_roughness_texture = texture_name(6, 0);
  Builder b = one(lower);
  b.add_material(upper);
  b.textures.push_back(constant_texture(Format::rgba8_unorm, {0, 200, 200, lower_height}));
  b.textures.push_back(constant_texture(Format::rgba8_unorm, {0, 200, 200, upper_height}));
  b.textures.push_back(texture_of(
      Format::rgba8_unorm, {64, 1}, 1, [](uint32_t x, uint32_t, uint32_t, uint32_t) { return 4 * x; }, false));
  b.vertices[1].uv = b.vertices[3].uv = vec2(0.99f, 0), b.vertices[0].uv = b.vertices[2].uv = vec2(0.01f, 0);
  return b;
}

// Sheets of either facing, of either handedness, by way of a mirror or not.
Case sides(uint32_t shader, uint32_t flags) {
  MaterialRecord m = textured(shader);
  m.flags = flags;
  Builder b = one(m);
  for (uint32_t i = 0; i < 16; ++i) {
    const Rectangle r = {i % 4 * 10, i / 4 * 9, 10, 9};
    Frame f = tilted();
    f.front_facing = i % 2 == 0, f.left_handed = i / 2 % 2 == 0;
    b.add_sheet(r, 0, uv_by_pixel(r, vec2(0.03f)), f, {.mirrored = i / 4 % 2 == 0});
  }
  return b.finish();
}

Case with(uint32_t shader, const std::function<void(MaterialRecord&)>& change) {
  MaterialRecord m = textured(shader);
  change(m);
  return one(m).finish();
}

// Sixteen instances of one leaf.
Case instances(uint32_t shader) {
  Builder b = one(textured(shader));
  for (uint32_t i = 0; i < 16; ++i) {
    const Rectangle r = {i % 4 * 10, i / 4 * 9, 10, 9};
    b.add_sheet(r, 0, uv_by_pixel(r, vec2(0.03f)), tilted());
  }
  return b.finish();
}

std::vector<HardCase> layer_cases() {
  return {
      {"layers_by_mask", "equal heights: the mask alone decides, over its whole range",
       [] { return two_layers(0.25f, 128, 128).finish(); }},
      {"layers_by_height", "the lower layer stands higher: the change comes later",
       [] { return two_layers(0.25f, 220, 60).finish(); }},
      {"layers_sharp", "a depth of 1/64: nearly a step", [] { return two_layers(0.015625f, 100, 160).finish(); }},
      {"layers_deep", "a depth of 16 mixes both everywhere", [] { return two_layers(16, 100, 160).finish(); }},
      {"layers_no_depth", "0, below and NaN are the least depth that there is",
       [] { return two_layers(0, 100, 160).finish(); }},
      {"layers_negative_depth", "as none", [] { return two_layers(-1, 100, 160).finish(); }},
      {"layers_depth_nan", "NaN is the largest depth", [] { return two_layers(kNaN, 100, 160).finish(); }},
      {"layers_depth_infinite", "and so is infinity", [] { return two_layers(kInf, 100, 160).finish(); }},
      {"layer_itself", "a material on top of itself ends after one turn",
       [] {
         Builder b = two_layers(0.25f, 100, 160);
         b.materials[0].layer = 0;
         return b.finish();
       }},
      {"layer_past_end", "a layer that there is not is none",
       [] {
         Builder b = two_layers(0.25f, 100, 160);
         b.materials[0].layer = 2;
         return b.finish();
       }},
      {"layer_none", "no layer",
       [] {
         Builder b = two_layers(0.25f, 100, 160);
         b.materials[0].layer = kNoMaterial;
         return b.finish();
       }},
  };
}

}  // namespace

std::vector<HardCase> class_cases() {
  std::vector<HardCase> cases = {
      {"class_opaque", "every channel of every texture and factor is another number",
       [] { return with(kShaderOpaque, [](MaterialRecord&) {}); }},
      {"class_masked", "both sides are seen, with the flag or without", [] { return sides(kShaderMasked, 0); }},
      {"class_emissive_detail", "the detail in base colour and emission",
       [] { return with(kShaderEmissiveDetail, [](MaterialRecord&) {}); }},
      {"class_cloth", "the weave roughens", [] { return with(kShaderCloth, [](MaterialRecord&) {}); }},
      {"class_skin", "thickness, whatever the metal", [] { return with(kShaderSkin, [](MaterialRecord&) {}); }},
      {"class_wet", "porous, half wet", [] { return with(kShaderWet, [](MaterialRecord& m) { m.metallic = 0.2f; }); }},
      {"class_wet_metal", "metal has no pores",
       [] {
         return with(kShaderWet, [](MaterialRecord& m) { m.metallic = 1, m.metallic_roughness_texture = kNoTexture; });
       }},
      {"class_wet_smooth", "nor has what is smooth",
       [] { return with(kShaderWet, [](MaterialRecord& m) { m.metallic = 0, m.roughness = 0.5f; }); }},
      {"class_foliage", "sixteen instances, sixteen tints", [] { return instances(kShaderFoliage); }},
      {"detail_scale", "the detail's own scale, where the level changes with it",
       [] {
         MaterialRecord m = textured(kShaderEmissiveDetail);
         m.detail_scale = 8;
         Builder b = one(m);
         b.textures[4] =
             levels_texture(Format::rgba8_unorm, {64, 64}, [](uint32_t level, uint32_t) { return 250 - 40 * level; });
         return b.finish();
       }},
      {"back_faces_kept", "a single-sided material's back faces keep their normal",
       [] { return sides(kShaderOpaque, 0); }},
      {"back_faces_turned", "a double-sided one's are turned, in frames of either hand",
       [] { return sides(kShaderCloth, kMaterialDoubleSided); }},
      {"normal_none", "no normal texture: the surface's own",
       [] { return with(kShaderOpaque, [](MaterialRecord& m) { m.normal_texture = kNoTexture; }); }},
      {"normal_scaled", "x and y are scaled, z is not",
       [] { return with(kShaderOpaque, [](MaterialRecord& m) { m.normal_scale = 3; }); }},
      {"normal_lost", "a normal of length 0 becomes the surface's own",
       [] {
         MaterialRecord m = textured(kShaderOpaque);
         m.normal_scale = 0;
         Builder b = one(m);
         b.textures[2] = constant_texture(Format::rgba8_unorm, {255, 255, 0, 0});
         return b.finish();
       }},
      {"normal_endless", "and so does one that fp32 cannot square",
       [] { return with(kShaderOpaque, [](MaterialRecord& m) { m.normal_scale = 1e30f; }); }},
      {"factors_out_of_range", "negative and above 1: clamped as they are stored",
       [] {
         return with(kShaderOpaque, [](MaterialRecord& m) {
           m.base_colour = vec4(-1, 5, 1e30f, 1), m.roughness = 7, m.metallic = -2, m.occlusion_strength = 40;
           m.emissive = vec3(-5, 1e30f, 2);
         });
       }},
      {"factors_infinite", "the ends of the range",
       [] {
         return with(kShaderOpaque, [](MaterialRecord& m) {
           m.base_colour = vec4(kInf, -kInf, 0.5f, 1), m.roughness = kInf, m.emissive = vec3(kInf, 1, 1);
         });
       }},
      {"factors_nan", "anything that the format holds, and nothing else is touched",
       [] {
         return with(kShaderTwoLayer, [](MaterialRecord& m) {
           m.base_colour.x = m.metallic = m.normal_scale = m.emissive.y = m.detail_scale = kNaN;
         });
       }},
      {"emissive_dim", "under the least step of the format, and at it",
       [] { return with(kShaderOpaque, [](MaterialRecord& m) { m.emissive = vec3(1e-7f, 1.2e-7f, 3e-5f); }); }},
      {"emissive_rounded", "between two codes, nearer to the upper one",
       [] {
         return with(kShaderOpaque, [](MaterialRecord& m) {
           m.emissive = vec3(1, 100.9f / 256, 7.7f / 256), m.emissive_texture = kNoTexture;
         });
       }},
      {"emissive_dark_beside_bright", "1e-4 beside 6e4: the dark one is lost to the shared exponent",
       [] { return with(kShaderOpaque, [](MaterialRecord& m) { m.emissive = vec3(1e-4f, 6e4f, 10); }); }},
  };
  for (HardCase& c : layer_cases()) cases.push_back(std::move(c));
  return cases;
}

}  // namespace assay::deferred_texturing
