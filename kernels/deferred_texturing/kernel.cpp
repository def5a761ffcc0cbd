#include "harness/kernel.h"

#include "harness/commands.h"
#include "kernels/deferred_texturing/fields.h"
#include "kernels/deferred_texturing/inputs.h"
#include "kernels/deferred_texturing/oracle.h"

namespace assay::deferred_texturing {

namespace {

Count counted(uint TexturingParams::*member) {
  return [member](const Case& c) { return uint64_t{c.params<TexturingParams>().*member}; };
}
uint64_t entries(const Case& c) { return uint64_t{c.params<TexturingParams>().waves} * kWaveSize; }
uint64_t rows(const Case& c) { return command_rows(c.params<TexturingParams>().shaders); }
Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }

struct ClassShaders {
  uint32_t shader;
  const char *any, *one_surface, *inlined;
};
constexpr ClassShaders kClasses[] = {
    {kShaderOpaque, "opaque.comp", "opaque_uniform.comp", "opaque_inline.comp"},
    {kShaderMasked, "masked.comp", "masked_uniform.comp", "masked_inline.comp"},
    {kShaderTwoLayer, "two_layer.comp", "two_layer_uniform.comp", "two_layer_inline.comp"},
    {kShaderEmissiveDetail, "emissive_detail.comp", "emissive_detail_uniform.comp", "emissive_detail_inline.comp"},
    {kShaderCloth, "cloth.comp", "cloth_uniform.comp", "cloth_inline.comp"},
    {kShaderSkin, "skin.comp", "skin_uniform.comp", "skin_inline.comp"},
    {kShaderWet, "wet.comp", "wet_uniform.comp", "wet_inline.comp"},
    {kShaderFoliage, "foliage.comp", "foliage_uniform.comp", "foliage_inline.comp"}};
static_assert(std::size(kClasses) == kShaderClasses);

// A class over these rows of its slot; none of them, and no pipeline, where nothing shows it.
Dispatch over_rows(const char* shader, uint32_t shader_class, uint32_t first, uint32_t end) {
  const auto slot = [shader_class](const Case& c) { return c.params<TexturingParams>().slot_of_class[shader_class]; };
  return {.shader = shader,
          .indirect = "args",
          .first_args = [=](const Case& c) { return uint64_t{slot(c)} * kCommandRows + first; },
          .repeat = [=](const Case& c) { return slot(c) == kUnregistered ? 0 : uint64_t{end} - first; }};
}

const Dispatch kBackground = {"background.comp", per_pixel};

std::vector<Pass> uniform_and_divergent() {
  std::vector<Pass> passes;
  for (const ClassShaders& k : kClasses) {
    passes.push_back(over_rows(k.one_surface, k.shader, 0, kCommandBuckets));
    passes.push_back(over_rows(k.any, k.shader, kCommandBuckets, kCommandRows));
  }
  passes.push_back(kBackground);
  return passes;
}
// A shader a class over all its rows: with the attributes as they are stored, or with its own.
std::vector<Pass> divergent(const char* ClassShaders::*file) {
  std::vector<Pass> passes;
  for (const ClassShaders& k : kClasses) passes.push_back(over_rows(k.*file, k.shader, 0, kCommandRows));
  passes.push_back(kBackground);
  return passes;
}

// Each port once, as `lists` binds them: the lists at their capacity, every texel, every vertex.
Cost cost(const Case& c) {
  const auto p = c.params<TexturingParams>();
  uint64_t texels = 0;
  if (const auto t = c.textures.find("textures"); t != c.textures.end())
    for (const Texture& texture : t->second) texels += texture.bytes.size();
  const uint64_t lists =
      entries(c) * sizeof(uint) + p.waves * sizeof(uint) + rows(c) * (sizeof(CommandRow) + sizeof(DispatchArgs));
  return {.bytes_read = pixels(c) * (sizeof(uvec2) + sizeof(uint) + 2 * sizeof(uvec2)) +
                        p.surfaces * sizeof(SurfaceRecord) + p.materials * sizeof(MaterialRecord) +
                        p.indices * sizeof(uint) + p.vertices * sizeof(VertexAttributes) + texels + lists,
          .bytes_written = pixels(c) * (4 + 4 + 2 + 4 + sizeof(uint)),
          .operations = pixels(c) * 60};  // UV and gradients 24, tangent frame 36
}

Bound channels(std::string port, Unpack unpack, std::string reason) {
  Bound b = between({std::move(port)}, std::move(reason));
  b.unpack = std::move(unpack);
  return b;
}
std::vector<Bound> bounds() {
  return {channels("base_roughness", unpack_base_roughness(), "trilinear range, then either code (README, Bounds)"),
          channels("normal", unpack_normal(), "trilinear range of the map, then an octahedral step"),
          channels("metallic_occlusion", unpack_metallic_occlusion(), "trilinear range, then either code"),
          channels("emissive", unpack_emissive(), "trilinear range, then half a shared step"),
          exact("features", "integers only")};
}
// Around what interpolation may find, not around what is stored of it.
std::vector<Bound> inline_bounds() {
  std::vector<Bound> all = bounds();
  for (Bound& b : all)
    if (b.judge == Judge::between) b.answer = kInline + b.ports[0];
  return all;
}

Port only_in(std::vector<std::string> variants, Port p) {
  p.only_in = std::move(variants);
  return p;
}
Port listed(Port p) { return only_in({"lists", "divergent_only", "inline_texturing"}, std::move(p)); }
Port stored(Port p) { return only_in({"lists", "divergent_only", "full_screen"}, std::move(p)); }

}  // namespace

Kernel describe() {
  return {
      .name = "deferred_texturing",
      .source = "Lazarek, Hammer 2025, Deferred Texturing",
      .default_variant = "lists",
      .params = layout_of<TexturingParams>(),
      .ports = {reads_image("visibility", Format::rg32_uint, {"visibility.visibility"}),
                reads<SurfaceRecord>("surfaces", counted(&TexturingParams::surfaces), {"scene.surfaces"}),
                reads<MaterialRecord>("materials", counted(&TexturingParams::materials), {"scene.materials"}),
                reads<uint>("indices", counted(&TexturingParams::indices), {"scene.indices"}),
                reads<VertexAttributes>("vertices", counted(&TexturingParams::vertices), {"scene.attributes"}),
                only_in({"inline_texturing"},
                        reads<vec3>("positions", counted(&TexturingParams::vertices), {"scene.positions"})),
                stored(reads<uint>("barycentrics", pixels, {"attribute_interpolation.barycentrics"})),
                stored(reads<uvec2>("derivatives", pixels, {"attribute_interpolation.derivatives"})),
                stored(reads<uvec2>("tangent_frame", pixels, {"attribute_interpolation.tangent_frame"})),
                reads_textures("textures", 16, {"scene.textures"}),
                listed(reads<uint>("entries", entries, {"pixel_commands.entries"})),
                listed(reads<uint>("commands", counted(&TexturingParams::waves), {"pixel_commands.commands"})),
                listed(reads<CommandRow>("command_rows", rows, {"pixel_commands.command_rows"})),
                listed(reads<DispatchArgs>("args", rows, {"pixel_commands.args"})),
                writes_image("base_roughness", Format::rgba8_unorm), writes_image("normal", Format::rg16_snorm),
                writes_image("metallic_occlusion", Format::rg8_unorm), writes_image("emissive", Format::r32_uint),
                writes<uint>("features", pixels)},
      .variants = {{.name = "lists",
                    .passes = uniform_and_divergent(),
                    .constants = {{"FIRST_ROW", {kCommandBuckets}}},
                    .needs = {Feature::subgroup_ballot},
                    .note = "a shader a class over its pixels; waves of one surface have a permutation of their own"},
                   {.name = "divergent_only",
                    .passes = divergent(&ClassShaders::any),
                    .constants = {{"FIRST_ROW", {0}}},
                    .needs = {Feature::subgroup_ballot},
                    .note = "a shader a class, nothing known of its waves"},
                   {.name = "inline_texturing",
                    .passes = divergent(&ClassShaders::inlined),
                    .constants = {{"FIRST_ROW", {0}}, {"SPLIT_PRODUCTS", {0, 1}}},
                    .needs = {Feature::subgroup_ballot},
                    .bounds = inline_bounds(),
                    .note = "as divergent_only, but every shader interpolates, and no pass does so before it"},
                   {.name = "full_screen",
                    .passes = {Dispatch{"full_screen.comp", per_pixel}},
                    .note = "one shader over all pixels, a branch a class"}},
      .oracle = textured,
      .inputs = inputs(),
      .bounds = bounds(),
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = frame,
  };
}

}  // namespace assay::deferred_texturing
