// Materials of `default`: 60, and how many of each shader class.
#include "harness/scene/default_scene.h"

namespace assay::scene::builtin {
namespace {

// Looks with a tint; colours are linear.
struct Row {
  const char* name;
  Finish Looks::*look;
  glm::vec3 tint = glm::vec3(1);
  float roughness = 1;
};
constexpr glm::vec3 kWhite = glm::vec3(1);

Material material_of(const Row& row, const Looks& looks, uint32_t shader) {
  const Finish& f = looks.*row.look;
  return {.name = row.name,
          .base_colour = glm::vec4(row.tint, 1),
          .roughness = row.roughness,
          .base_image = f.base,
          .normal_image = f.normal,
          .metallic_roughness_image = f.surface,
          .occlusion_image = f.surface,
          .shader = shader};
}

struct Adder {
  Scene& scene;
  const Looks& looks;
  Palette palette = {};

  uint32_t add(Material m) {
    const uint32_t shader = *m.shader;
    palette.of_class[shader].push_back(add_material(scene, std::move(m)));
    return palette.of_class[shader].back();
  }
};

// The last two lie on top of others (add_two_layer).
void add_opaque(Adder& a) {
  const Row rows[] = {
      {"flagstones", &Looks::stone},
      {"dark flagstones", &Looks::stone, {0.4f, 0.42f, 0.45f}},
      {"red brick", &Looks::brick},
      {"whitewashed brick", &Looks::brick, {1, 0.95f, 0.9f}, 0.9f},
      {"black brick", &Looks::brick, {0.25f, 0.22f, 0.22f}},
      {"white marble", &Looks::marble},
      {"green marble", &Looks::marble, {0.35f, 0.6f, 0.42f}},
      {"rose marble", &Looks::marble, {0.85f, 0.55f, 0.5f}},
      {"plaster", &Looks::plaster},
      {"ochre plaster", &Looks::plaster, {0.85f, 0.62f, 0.32f}},
      {"blue plaster", &Looks::plaster, {0.4f, 0.5f, 0.7f}},
      {"oak", &Looks::wood},
      {"walnut", &Looks::wood, {0.5f, 0.4f, 0.33f}, 0.8f},
      {"iron", &Looks::metal, {0.55f, 0.55f, 0.57f}},
      {"brass", &Looks::metal, {0.9f, 0.68f, 0.3f}, 0.7f},
      {"moss", &Looks::moss},
      {"sand", &Looks::sand},
  };
  for (const Row& row : rows) a.add(material_of(row, a.looks, kShaderOpaque));
}

void add_masked(Adder& a) {
  struct Sheet {
    const char* name;
    uint32_t Looks::*holes;
    bool double_sided;
  };
  const Sheet sheets[] = {
      {"iron bars", &Looks::bars, false},         {"brass bars", &Looks::bars, true},
      {"wooden lattice", &Looks::lattice, false}, {"painted lattice", &Looks::lattice, true},
      {"chain mail", &Looks::rings, true},
  };
  for (const Sheet& sheet : sheets) {
    const Row row = {sheet.name, &Looks::metal};
    Material m = material_of(row, a.looks, kShaderMasked);
    m.base_image = a.looks.*sheet.holes;
    m.alpha = AlphaMode::masked;
    m.double_sided = sheet.double_sided;
    a.add(std::move(m));
  }
}

void add_two_layer(Adder& a) {
  const std::vector<uint32_t>& opaque = a.palette.of_class[kShaderOpaque];
  const uint32_t moss = opaque[opaque.size() - 2], sand = opaque.back();
  struct Layered {
    Row below;
    uint32_t above;
    float blend_depth;
  };
  const Layered rows[] = {
      {{"mossy flagstones", &Looks::stone}, moss, 0.2f},
      {{"sanded flagstones", &Looks::stone, {0.9f, 0.8f, 0.7f}}, sand, 0.1f},
      {{"mossy brick", &Looks::brick}, moss, 0.3f},
      {{"sanded brick", &Looks::brick, {0.8f, 0.75f, 0.7f}}, sand, 0.05f},
      {{"mossy planks", &Looks::wood}, moss, 0.15f},
      {{"sanded planks", &Looks::wood, {0.8f, 0.75f, 0.7f}}, sand, 0.2f},
      {{"sanded plates", &Looks::metal, {0.6f, 0.6f, 0.62f}}, sand, 0.1f},
      {{"overgrown marble", &Looks::marble}, moss, 0.4f},
  };
  for (const Layered& row : rows) {
    Material m = material_of(row.below, a.looks, kShaderTwoLayer);
    m.layer = row.above;
    m.mask_image = a.looks.layer_mask;
    m.blend_depth = row.blend_depth;
    a.add(std::move(m));
  }
}

void add_emissive(Adder& a) {
  struct Glow {
    const char* name;
    glm::vec3 radiance;
    float detail_scale;
  };
  const Glow glows[] = {{"ember runes", {6, 1.6f, 0.3f}, 2},  {"ice runes", {0.6f, 2.4f, 6}, 3},
                        {"acid runes", {1, 5, 0.6f}, 4},      {"violet runes", {3, 0.7f, 5}, 2},
                        {"golden runes", {5, 3.4f, 0.8f}, 5}, {"pale runes", {3, 3, 3.4f}, 3}};
  for (const Glow& glow : glows) {
    Material m = material_of({glow.name, &Looks::rune}, a.looks, kShaderEmissiveDetail);
    m.emissive = glow.radiance;
    m.emissive_image = a.looks.glow;
    m.detail_image = a.looks.scan;
    m.detail_scale = glow.detail_scale;
    a.add(std::move(m));
  }
}

void add_cloth(Adder& a) {
  const std::pair<const char*, glm::vec3> dyes[] = {{"crimson damask", {0.55f, 0.04f, 0.05f}},
                                                    {"indigo damask", {0.07f, 0.08f, 0.4f}},
                                                    {"saffron damask", {0.8f, 0.45f, 0.06f}},
                                                    {"emerald damask", {0.05f, 0.35f, 0.12f}},
                                                    {"linen", {0.75f, 0.7f, 0.6f}},
                                                    {"plum damask", {0.3f, 0.05f, 0.22f}},
                                                    {"teal damask", {0.03f, 0.32f, 0.34f}},
                                                    {"charcoal felt", {0.08f, 0.08f, 0.09f}}};
  for (const auto& [name, dye] : dyes) {
    Material m = material_of({name, &Looks::fabric, dye}, a.looks, kShaderCloth);
    m.double_sided = true;
    m.features = kFeatureCloth;
    m.detail_image = a.looks.weave;
    m.detail_scale = 6;
    a.add(std::move(m));
  }
}

void add_skin(Adder& a) {
  const std::pair<const char*, glm::vec3> tints[] = {{"pale hide", {1, 0.9f, 0.85f}},
                                                     {"ruddy hide", {0.95f, 0.6f, 0.5f}},
                                                     {"tanned hide", {0.7f, 0.5f, 0.38f}},
                                                     {"dark hide", {0.32f, 0.24f, 0.2f}},
                                                     {"bruised hide", {0.6f, 0.5f, 0.75f}}};
  for (const auto& [name, tint] : tints) {
    Material m = material_of({name, &Looks::skin, tint}, a.looks, kShaderSkin);
    m.features = kFeatureSkin | kFeatureSubsurface;
    m.mask_image = a.looks.thickness;
    m.normal_scale = 0.7f;
    a.add(std::move(m));
  }
}

void add_wet(Adder& a) {
  const Row rows[] = {{"wet flagstones", &Looks::stone},
                      {"wet brick", &Looks::brick},
                      {"wet marble", &Looks::marble},
                      {"wet plates", &Looks::metal, {0.6f, 0.58f, 0.55f}},
                      {"wet sand", &Looks::sand}};
  for (const Row& row : rows) {
    Material m = material_of(row, a.looks, kShaderWet);
    m.features = kFeatureWetnessDrops | kFeaturePuddles;
    m.mask_image = a.looks.wet_mask;
    a.add(std::move(m));
  }
}

void add_foliage(Adder& a) {
  struct Plant {
    const char* name;
    uint32_t Looks::*holes;
    glm::vec3 tint;
  };
  const Plant plants[] = {
      {"ivy", &Looks::leaves, kWhite},        {"red ivy", &Looks::leaves, {1.6f, 0.5f, 0.5f}},
      {"fern", &Looks::fern, kWhite},         {"dry fern", &Looks::fern, {1.7f, 1, 0.5f}},
      {"reed grass", &Looks::blades, kWhite}, {"blue grass", &Looks::blades, {0.6f, 0.9f, 2}},
  };
  for (const Plant& plant : plants)
    a.add({.name = plant.name,
           .base_colour = glm::vec4(plant.tint, 1),
           .metallic = 0,
           .roughness = 0.7f,
           .base_image = a.looks.*plant.holes,
           .alpha = AlphaMode::masked,
           .double_sided = true,
           .features = kFeatureSubsurface,
           .shader = kShaderFoliage});
}

}  // namespace

Palette add_default_materials(Scene& s, const Looks& looks) {
  Adder a = {s, looks};
  add_opaque(a);
  add_masked(a);
  add_two_layer(a);
  add_emissive(a);
  add_cloth(a);
  add_skin(a);
  add_wet(a);
  add_foliage(a);
  return a.palette;
}

}  // namespace assay::scene::builtin
