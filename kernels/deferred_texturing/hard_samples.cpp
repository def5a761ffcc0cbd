// Hard cases of coordinates, gradients and textures.
#include <cmath>
#include <limits>

#include "kernels/deferred_texturing/inputs.h"

namespace assay::deferred_texturing {

namespace {

constexpr Extent kExtent = {40, 36};
constexpr Rectangle kAll = {0, 0, 40, 36};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// One sheet over the screen, whose base colour is the first texture of the first array.
Builder sheet(Texture t, const std::array<vec2, 4>& corners) {
  Builder b(kExtent);
  b.textures = {std::move(t)};
  MaterialRecord m = plain_material();
  m.base_texture = texture_name(0, 0);
  b.add_sheet(kAll, b.add_material(m), corners);
  return b;
}

// A colour a level, far from its neighbours'.
Texture levels(Extent e) {
  return levels_texture(Format::rgba8_unorm, e, [](uint32_t level, uint32_t c) {
    return (level + c) % 3 == 0 ? 20 + 10 * level : 240 - 15 * level;
  });
}

// Upright stripes of a texel, another in each channel, and lines in alpha: u and v differ.
Texture stripes(Format format, Extent e, uint32_t layers = 1) {
  return texture_of(
      format, e, layers,
      [](uint32_t x, uint32_t y, uint32_t layer, uint32_t c) {
        return 40 * ((x + c + layer) % 3) + (c == 2 ? 100 * (y % 2) : 60u);
      },
      false);
}

// Columns of another number of texels a pixel each, a power of two or near one. The second vertex is left bottom.
Case all_levels() {
  Builder b = sheet(levels({256, 64}), {});
  for (uint32_t x = 0; x < kExtent.width; ++x)
    for (uint32_t y = 0; y < kExtent.height; ++y) {
      const double texels = std::exp2(x / 4.0 - 1) * (y % 2 == 0 ? 1 : 1.03);
      Interpolated p;
      p.weights = {0.3, 0.3}, p.d_dx = {texels / 256, 0}, p.d_dy = {0, texels / 512};
      b.set(x, y, p);
    }
  b.vertices[2].uv = vec2(1, 0), b.vertices[1].uv = vec2(0, 1), b.vertices[3].uv = vec2(1, 1);
  return b.finish();
}

// Every pixel with these derivatives of the second and third weight, whose vertices are one apart in u and in v.
Case with_derivatives(const glm::dvec2& d_dx, const glm::dvec2& d_dy) {
  Builder b = sheet(levels({64, 64}), {vec2(0), vec2(1, 0), vec2(0, 1), vec2(1)});
  for (uint32_t y = 0; y < kExtent.height; ++y)
    for (uint32_t x = 0; x < kExtent.width; ++x) b.set(x, y, {{0.25, 0.5}, d_dx, d_dy, {}});
  return b.finish();
}

Case with_corner(vec2 broken) {
  auto corners = uv_by_pixel(kAll, vec2(0.01f));
  corners[0] = broken;
  return sheet(stripes(Format::rgba8_unorm, {8, 8}), corners).finish();
}

Case named(uint32_t name, std::vector<Texture> textures) {
  Builder b = sheet(stripes(Format::rgba8_srgb, {4, 4}, 2), uv_by_pixel(kAll, vec2(0.013f)));
  if (!textures.empty()) b.textures = std::move(textures);
  b.materials[0].base_texture = b.materials[0].normal_texture = b.materials[0].metallic_roughness_texture = name;
  return b.finish();
}

}  // namespace

std::vector<HardCase> sample_cases() {
  return {
      {"magnified", "40 pixels a texel, contrast full: the weights' steps are seen",
       [] {
         return sheet(stripes(Format::rgba8_unorm, {4, 4}), uv_by_pixel(kAll, vec2(0.01f))).finish();
       }},
      {"magnified_srgb", "the same decoded before it is filtered",
       [] {
         return sheet(stripes(Format::rgba8_srgb, {4, 4}), uv_by_pixel(kAll, vec2(0.01f))).finish();
       }},
      {"across_the_edge", "the last texel beside the first, upwards and downwards",
       [] {
         return sheet(stripes(Format::rgba8_unorm, {5, 3}), uv_by_pixel(kAll, vec2(0.05f, 0.04f), vec2(-1))).finish();
       }},
      {"every_level", "from half a texel a pixel to 1024, on whole levels and beside them", all_levels},
      {"gradient_zero", "the same coordinate at all corners: level 0",
       [] {
         return sheet(levels({64, 64}), {vec2(0.4f), vec2(0.4f), vec2(0.4f), vec2(0.4f)}).finish();
       }},
      {"gradient_of_y", "only the way down is minified",
       [] {
         return with_derivatives({0, 0}, {0.125, 0});
       }},
      {"gradient_of_x", "only the way across is minified",
       [] {
         return with_derivatives({0, 0.125}, {0, 0});
       }},
      {"gradient_opposed", "derivatives of both weights that cancel in no vertex",
       [] {
         return with_derivatives({0.25, -0.25}, {1e-6, 1e-6});
       }},
      {"gradient_huge", "1e8 a pixel: the last level",
       [] {
         return with_derivatives({1e8, 0}, {0, -1e8});
       }},
      {"gradient_tiny", "1e-20 a pixel: the first",
       [] {
         return with_derivatives({1e-20, 0}, {0, 1e-20});
       }},
      {"one_level", "minified where there is nothing to minify with",
       [] {
         return sheet(stripes(Format::rgba8_unorm, {32, 32}), uv_by_pixel(kAll, vec2(0.7f))).finish();
       }},
      {"one_texel", "1x1",
       [] {
         return sheet(stripes(Format::rgba8_srgb, {1, 1}), uv_by_pixel(kAll, vec2(0.7f))).finish();
       }},
      {"odd_texture", "37x21: no size is a power of two and levels round down",
       [] {
         return sheet(texture_of(Format::rgba8_srgb, {37, 21}, 1,
                                 [](uint32_t x, uint32_t y, uint32_t, uint32_t c) { return 4 * x + 3 * y + 20 * c; }),
                      uv_by_pixel(kAll, vec2(0.08f)))
             .finish();
       }},
      {"uv_far", "1e4: fp32 has a thousandth left",
       [] {
         return sheet(stripes(Format::rgba8_unorm, {8, 8}), uv_by_pixel(kAll, vec2(0.01f), vec2(1e4f, -1e4f))).finish();
       }},
      {"uv_mirrored", "u falls to the right",
       [] {
         return sheet(stripes(Format::rgba8_unorm, {4, 4}), uv_by_pixel(kAll, vec2(-0.01f, 0.01f))).finish();
       }},
      {"uv_nan", "no coordinate is coordinate 0, no gradient the last level",
       [] { return with_corner(vec2(kNaN, 0.2f)); }},
      {"uv_infinite", "nor is an infinite one", [] { return with_corner(vec2(0.2f, -kInf)); }},
      {"uv_beyond", "nor one past 65536", [] { return with_corner(vec2(1e9f, 3e38f)); }},
      {"uv_past_the_limit", "70000.25 at all corners: 0, not a quarter",
       [] {
         const vec2 at(70000.25f);
         return sheet(stripes(Format::rgba8_unorm, {8, 8}), {at, at, at, at}).finish();
       }},
      {"uv_denormal", "flushed or not", [] { return with_corner(vec2(1e-40f, -1e-42f)); }},
      {"texture_none", "no texture is white, and its normal up", [] { return named(kNoTexture, {}); }},
      {"texture_slot_unused", "a slot without an array is white", [] { return named(texture_name(9, 0), {}); }},
      {"texture_array_past_end", "an array that there is not is white", [] { return named(texture_name(40, 0), {}); }},
      {"texture_layer", "the second layer, not the first", [] { return named(texture_name(0, 1), {}); }},
      {"texture_layer_past_end", "a layer past the end is the last", [] { return named(texture_name(0, 900), {}); }},
      {"texture_sixteenth", "the last of sixteen arrays",
       [] {
         std::vector<Texture> all(15, constant_texture(Format::rgba8_unorm, {0, 0, 0, 0}));
         all.push_back(stripes(Format::rgba8_unorm, {5, 3}));
         return named(texture_name(15, 0), all);
       }},
  };
}

}  // namespace assay::deferred_texturing
