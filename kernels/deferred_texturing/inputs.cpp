#include "kernels/deferred_texturing/inputs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/commands.h"
#include "harness/crop.h"
#include "harness/formats/features.h"
#include "harness/formats/visibility.h"

namespace assay::deferred_texturing {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

glm::dvec3 unit_vector(Pcg32& rng) {
  const double z = rng.range(-1, 1), angle = rng.range(0, 2 * kPi), r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Frame random_frame(Pcg32& rng) {
  Frame f;
  f.normal = unit_vector(rng);
  do f.tangent = glm::cross(f.normal, unit_vector(rng));
  while (glm::length(f.tangent) < 0.1);
  f.tangent = glm::normalize(f.tangent);
  f.left_handed = rng.below(2) == 0, f.front_facing = rng.below(4) != 0;
  return f;
}

Rectangle random_rectangle(Pcg32& rng, Extent e, uint32_t least, uint32_t most) {
  const uint32_t w = least + rng.below(most - least + 1), h = least + rng.below(most - least + 1);
  return {rng.below(e.width), rng.below(e.height), w, h};
}

float unit(Pcg32& rng) { return static_cast<float>(rng.unit()); }

// A material of this class with textures of shared_textures(), each there with this likelihood.
MaterialRecord random_material(Pcg32& rng, uint32_t shader, uint32_t layers, double textured) {
  const auto name = [&](uint32_t array) {
    return rng.unit() < textured ? texture_name(array, rng.below(layers)) : kNoTexture;
  };
  MaterialRecord m = plain_material(shader);
  m.base_colour = vec4(unit(rng), unit(rng), unit(rng), 1);
  m.base_texture = name(0), m.emissive_texture = name(0);
  m.emissive = rng.below(3) == 0 ? vec3(unit(rng), 4 * unit(rng), 100 * unit(rng)) : vec3(0);
  m.metallic = unit(rng), m.roughness = unit(rng), m.metallic_roughness_texture = name(1);
  m.normal_texture = name(2), m.normal_scale = static_cast<float>(rng.range(0.2, 2));
  m.occlusion_texture = name(3), m.occlusion_strength = unit(rng);
  m.mask_texture = name(3), m.detail_texture = name(4), m.detail_scale = static_cast<float>(rng.range(0.5, 8));
  m.blend_depth = static_cast<float>(rng.range(0.05, 1));
  m.flags = rng.below(2) == 0 ? kMaterialDoubleSided : 0;
  m.features = kFeatureOpaque | (rng.next() & 0x1ffeu);
  return m;
}

void extreme_factors(MaterialRecord& m, Pcg32& rng) {
  const auto extreme = [&rng] {
    const float values[] = {0, -1, 2, 1e-40f, 1e30f, -1e30f, kInf, -kInf, kNaN};
    return values[rng.below(std::size(values))];
  };
  for (float* factor : {&m.base_colour.x, &m.metallic, &m.roughness, &m.normal_scale, &m.occlusion_strength,
                        &m.emissive.y, &m.blend_depth, &m.detail_scale})
    if (rng.below(3) == 0) *factor = extreme();
}

void add_classes(Builder& b, Random& r, uint32_t layers, double textured) {
  const size_t choice = r.branch({{"opaque", 0.05},
                                  {"masked", 0.05},
                                  {"two_layer", 0.1},
                                  {"emissive_detail", 0.05},
                                  {"cloth", 0.05},
                                  {"skin", 0.05},
                                  {"wet", 0.05},
                                  {"foliage", 0.05},
                                  {"every_class", 0.55}});
  const uint32_t count = 1 + r.rng.below(60);
  for (uint32_t i = 0; i < count; ++i) {
    const auto shader = choice < kShaderClasses ? static_cast<uint32_t>(choice) : r.rng.below(kShaderClasses);
    b.add_material(random_material(r.rng, shader, layers, textured));
  }
  for (MaterialRecord& m : b.materials) m.layer = r.rng.below(count);
}

vec2 random_scale(Random& r, uint32_t side) {
  const double texels = std::array{0.05, 1.0, 20.0}[r.branch({{"magnified", 1}, {"one_to_one", 1}, {"minified", 1}})];
  const auto one = [&] {
    const double sign = r.rng.below(4) == 0 ? -1 : 1;
    return static_cast<float>(sign * texels * r.rng.range(0.5, 2) / side);
  };
  return {one(), one()};
}

void add_sheets(Builder& b, Random& r, uint32_t side) {
  const size_t frames = r.branch({{"frames_flat", 1}, {"frames_turned", 2}, {"frames_curved", 1}});
  const size_t where = r.branch({{"uv_near", 0.8}, {"uv_far", 0.1}, {"uv_hostile", 0.1}});
  const bool perspective = r.branch({{"sheets_upright", 1}, {"sheets_in_perspective", 1}}) == 1;
  const auto sheets = std::min<uint32_t>(1 + r.rng.below(60), 200);
  const uint32_t most = std::max(b.extent.width, b.extent.height) / 2 + 4;
  const vec2 scale = random_scale(r, side);
  for (uint32_t i = 0; i < sheets; ++i) {
    const Rectangle rect = random_rectangle(r.rng, b.extent, 1, most);
    const vec2 origin = where == 1 ? vec2(r.rng.range(-1e4, 1e4), r.rng.range(-1e4, 1e4))
                                   : vec2(r.rng.range(-2, 2), r.rng.range(-2, 2));
    auto corners = uv_by_pixel(rect, scale, origin);
    if (where == 2 && r.rng.below(2) == 0) {
      const float values[] = {kNaN, kInf, 1e38f, -1e9f, 7e4f, 1e-42f};
      corners[r.rng.below(4)][static_cast<int>(r.rng.below(2))] = values[r.rng.below(std::size(values))];
    }
    const Frame frame = frames == 0 ? Frame{} : random_frame(r.rng);
    Shape shape = {.bulge = frames == 2 ? r.rng.range(0, 0.6) : 0, .mirrored = r.rng.below(3) == 0};
    if (perspective)
      for (double& w : shape.depths) w = std::exp2(r.rng.range(-2, 2));
    const auto material = r.rng.below(static_cast<uint32_t>(b.materials.size()));
    const uint32_t surface = b.add_sheet(rect, material, corners, frame, shape);
    if (r.rng.below(3) == 0) b.flag_surface(surface, kVisibilityInstanced);
  }
}

// Surfaces, materials and classes that there are not; indices past the end.
void break_indices(Builder& b, Pcg32& rng) {
  for (uvec2& v : b.visibility)
    if (rng.below(16) == 0) v = {rng.next(), rng.below(2 * static_cast<uint32_t>(b.surfaces.size()) + 2)};
  for (SurfaceRecord& s : b.surfaces) {
    if (rng.below(8) == 0) s.material = rng.next();
    if (rng.below(8) == 0) s.first_index = rng.next();
    if (rng.below(8) == 0) s.vertex_offset = rng.next();
  }
  for (MaterialRecord& m : b.materials) {
    if (rng.below(8) == 0) m.shader = rng.next();
    if (rng.below(8) == 0) m.layer = rng.next();
    if (rng.below(8) == 0) m.base_texture = rng.next();
    if (rng.below(8) == 0) m.normal_texture = rng.below(40) << 16 | rng.below(9);
  }
  b.hidden_classes = {rng.below(kShaderClasses)};
}

}  // namespace

std::vector<Texture> shared_textures(uint32_t side, uint32_t layers, double contrast) {
  // Waves of a few periods, so that neighbouring texels are near, around a middle of each layer's own.
  const auto wave = [=](uint32_t x, uint32_t y, uint32_t layer, uint32_t channel, double middle) {
    const double turn = 2 * kPi / side, a = (1 + (layer + channel) % 3) * x * turn, b = (1 + layer % 2) * y * turn;
    return static_cast<uint32_t>(
        std::clamp(middle + contrast * std::sin(a + layer) * std::cos(b + channel + 2.0 * layer), 0.0, 255.0));
  };
  const Extent e = {side, side};
  const auto coloured = [=](uint32_t x, uint32_t y, uint32_t l, uint32_t c) {
    return wave(x, y, l, c, 90 + 37 * ((l + 2 * c) % 4));
  };
  const auto raised = [=](uint32_t x, uint32_t y, uint32_t l, uint32_t c) { return wave(x, y, l + c, c, 128); };
  const auto tilted = [=](uint32_t x, uint32_t y, uint32_t l, uint32_t c) { return wave(x, y, l, c, 128); };
  return {texture_of(Format::rgba8_srgb, e, layers, coloured), texture_of(Format::rgba8_unorm, e, layers, raised),
          texture_of(Format::rgba8_unorm, e, layers, tilted), texture_of(Format::rgba8_unorm, e, layers, raised),
          texture_of(Format::rgba8_unorm, e, layers, coloured)};
}

namespace {

Case random_case(Random& r) {
  Builder b(random_extent(r, kTileSide));
  const uint32_t side = std::array{1u, 16u, 37u, 128u}[r.branch(
      {{"textures_of_one_texel", 0.1}, {"textures_small", 0.3}, {"textures_odd", 0.3}, {"textures_large", 0.3}})];
  const uint32_t layers = 1 + r.rng.below(4);
  const bool is_textured = r.branch({{"textures_none", 0.1}, {"textures_some", 0.9}}) == 1;
  if (is_textured) b.textures = shared_textures(side, layers, r.rng.range(0, 100));
  add_classes(b, r, layers, is_textured ? 0.7 : 0);
  if (r.branch({{"factors_plain", 0.8}, {"factors_extreme", 0.2}}) == 1)
    for (MaterialRecord& m : b.materials) extreme_factors(m, r.rng);
  if (r.branch({{"screen_empty", 0.05}, {"screen_shown", 0.95}}) == 1) add_sheets(b, r, side);
  if (r.branch({{"indices_good", 0.8}, {"indices_broken", 0.2}}) == 1) break_indices(b, r.rng);
  if (r.branch({{"lists_padded", 0.7}, {"lists_overflow", 0.3}}) == 1)
    b.tiles_with_room = r.rng.below(static_cast<uint32_t>(tile_count(b.extent, kTileSide)) + 1);
  return b.finish("random");
}

std::vector<std::string> branches() {
  std::vector<std::string> all = kExtentBranches;
  for (const char* b : {"textures_of_one_texel",
                        "textures_small",
                        "textures_odd",
                        "textures_large",
                        "textures_none",
                        "textures_some",
                        "opaque",
                        "masked",
                        "two_layer",
                        "emissive_detail",
                        "cloth",
                        "skin",
                        "wet",
                        "foliage",
                        "every_class",
                        "factors_plain",
                        "factors_extreme",
                        "screen_empty",
                        "screen_shown",
                        "frames_flat",
                        "frames_turned",
                        "frames_curved",
                        "sheets_upright",
                        "sheets_in_perspective",
                        "uv_near",
                        "uv_far",
                        "uv_hostile",
                        "magnified",
                        "one_to_one",
                        "minified",
                        "indices_good",
                        "indices_broken",
                        "lists_padded",
                        "lists_overflow"})
    all.push_back(b);
  return all;
}

}  // namespace

Inputs inputs() {
  Inputs in = {.random = random_case, .branches = branches(), .hard = {}};
  for (const auto& cases : {list_cases(), sample_cases(), class_cases(), mesh_cases()})
    in.hard.insert(in.hard.end(), cases.begin(), cases.end());
  return in;
}

Case typical(Extent e) {
  constexpr uint32_t kSide = 256, kLayers = 8, kMaterials = 60, kSheets = 400;
  Builder b(e);
  Pcg32 rng(11);
  b.textures = shared_textures(kSide, kLayers, 60);
  for (uint32_t i = 0; i < kMaterials; ++i) {
    b.add_material(random_material(rng, i % kShaderClasses, kLayers, 0.8));
    b.materials.back().layer = (i * 7 + 1) % kMaterials;
  }
  const auto add = [&](const Rectangle& r) {
    const auto scale = static_cast<float>(std::exp2(rng.range(-2, 2)) / kSide);
    b.add_sheet(r, rng.below(kMaterials), uv_by_pixel(r, vec2(scale), vec2(unit(rng), unit(rng))), random_frame(rng));
  };
  add({0, 0, e.width, e.height});
  for (uint32_t i = 0; i < kSheets; ++i) {
    const auto side = static_cast<uint32_t>(std::exp2(rng.range(3, 0.8 * std::log2(e.width))));
    add({rng.below(e.width), rng.below(e.height), side, side / 2 + 1});
  }
  // Some sky.
  for (uint32_t y = 0; y < e.height / 8; ++y)
    for (uint32_t x = 0; x < e.width; ++x) b.visibility[size_t{y} * e.width + x] = uvec2(kVisibilityNone);
  return b.finish("typical");
}

Case frame(const FrameInputs& f) {
  TexturingParams p = {};
  p.width = f.extent.width, p.height = f.extent.height;
  p.surfaces = f.scene.surfaces, p.materials = f.scene.materials;
  p.indices = f.scene.indices, p.vertices = f.scene.vertices;
  p.probe_factor = kProbeFactor, p.probe_addend = kProbeAddend;
  p.shaders = static_cast<uint32_t>(f.shaders.size());
  p.waves = static_cast<uint32_t>(command_waves(f.extent, f.shaders.size()));
  std::fill(std::begin(p.slot_of_class), std::end(p.slot_of_class), kUnregistered);
  for (uint32_t slot = 0; slot < f.shaders.size(); ++slot)
    if (f.shaders[slot] < kShaderClasses) p.slot_of_class[f.shaders[slot]] = slot;
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(p);
  return c;
}

}  // namespace assay::deferred_texturing
