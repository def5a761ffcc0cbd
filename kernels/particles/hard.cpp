#include <cmath>
#include <limits>

#include "kernels/particles/air.h"
#include "kernels/particles/inputs.h"

namespace assay::particles {

using glm::dvec3;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr Extent kSmall = {64, 48};

std::function<Case()> made(std::function<Air()> make) {
  return [make = std::move(make)] { return to_case("", make()); };
}
std::function<Case()> one(std::function<void(ParticleRecord&)> change, double depth = 3, double radius = 2) {
  return made([=] {
    Air a = air(kSmall);
    ParticleRecord p = facing({0, 0, -depth}, radius);
    change(p);
    a.add(p, rect(16, 1, 2));
    return a;
  });
}
Air plume(Extent e, uint32_t count, uint32_t lights) {
  Air a = air(e);
  Pcg32 rng(5);
  add_plume(a, rng, count, 1, 9, 0.6);
  add_lights(a, rng, lights);
  return a;
}

std::vector<HardCase> size_cases() {
  return {{"one_pixel", "one fragment, without neighbours", made([] {
             return plume({1, 1}, 3, 2);
           })},
          {"odd_extent", "quads of pixels that reach out of the picture", made([] {
             return plume({31, 33}, 5, 3);
           })},
          {"no_particles", "nothing is drawn, nothing may change", made([] { return plume(kSmall, 0, 1); })},
          {"no_lights", "no record to read", made([] { return plume(kSmall, 4, 0); })},
          {"full_hd_and_one", "an odd extent of real size", made([] {
             return plume({1921, 1081}, 30, 1);
           })},
          {"many_particles", "10^5, each of a pixel or two, in order", made([] {
             Air a = air({320, 180});
             Pcg32 rng(6);
             add_plume(a, rng, 100000, 2, 40, 0.02);
             return a;
           }),
           true}};
}

std::vector<HardCase> record_cases() {
  return {
      {"whole_screen", "one particle over every pixel, its texels 8 pixels wide", one([](ParticleRecord&) {}, 2, 4)},
      {"size_zero", "no area: the place on it is no number", one([](ParticleRecord& p) { p.right = p.up = vec3(0); })},
      {"one_axis_zero", "a line", one([](ParticleRecord& p) { p.up = vec3(0); })},
      {"tiny_axes", "products of axes are denormal", one([](ParticleRecord& p) { p.right *= 1e-22f, p.up *= 1e-22f; })},
      {"tiny", "10^-6 m at 0.3 m, about a hundredth of a pixel", one([](ParticleRecord& p) {
         p = facing({0.0001, 0.0001, -0.3}, 2e-6);
       })},
      {"quality_zero", "not lit, so not drawn", one([](ParticleRecord& p) { p.quality = 0; })},
      {"opaque", "an opacity of 1 and one above: in the middle nothing is left of the picture", made([] {
         Air a = air(kSmall);
         for (const float opacity : {1.0f, 7.0f}) {
           ParticleRecord p = facing({opacity == 1 ? -1.5 : 1.5, 0, -3}, 1.4);
           p.opacity = opacity;
           a.add(p, rect(8, 3, 3));
         }
         return a;
       })},
      {"no_numbers", "a NaN or an infinity in each number by turns, and whole ones between", made([] {
         Air a = air(kSmall);
         for (uint32_t i = 0; i < sizeof(ParticleRecord) / 4; ++i)
           for (const float bad : {kNan, kInf, -kInf}) {
             ParticleRecord p = facing({0.2 * i - 1.5, 0.1 * i - 0.8, -3}, 0.5);
             a.add(p, rect(8, i % 8, 1));
             std::memcpy(reinterpret_cast<char*>(&p) + 4 * size_t{i}, &bad, 4);
             a.add(p, rect(8, i % 8, 2));
           }
         return a;
       })},
      {"too_far", "10^6 m and beyond", made([] {
         Air a = air(kSmall, 1e7);
         for (const double far : {9.9e5, 1.01e6}) a.add(facing({far / 4, 0, -far}, far / 3), rect(16, 2, 1));
         return a;
       })},
      {"negative_albedo", "the colour is held above 0", one([](ParticleRecord& p) { p.albedo = vec3(-1, 0.5f, 2); })},
      {"brightest", "colour and picture at the largest half", made([] {
         Air a = air(kSmall);
         for (vec4& t : a.radiance) t = vec4(65504, 65504, 1, 1);
         for (uvec2& t : a.atlas) t = encoded({65024, 65024, 64512}, kLightR11G11B10);
         ParticleRecord p = facing({0, 0, -3}, 2);
         p.albedo = vec3(2);
         a.add(p, rect(16, 1, 1));
         return a;
       })},
  };
}

std::vector<HardCase> view_cases() {
  return {
      {"behind", "its centre behind the viewer, all of it or a part", made([] {
         Air a = air(kSmall);
         a.add(facing({0, 0, 2}, 1), rect(8, 1, 1));
         ParticleRecord p = facing({0, 0, 0.5}, 1);
         p.right = vec3(0.4f, 0, -3);
         a.add(p, rect(8, 1, 2));
         return a;
       })},
      {"through_near_plane", "corners before and behind the near plane", one([](ParticleRecord& p) {
         p.centre = vec3(0, 0, -0.5f), p.right = vec3(0.3f, 0.1f, -2), p.up = vec3(0, 1, 0.2f);
       })},
      {"at_near_plane", "where the fade is not yet whole", one([](ParticleRecord& p) {
         p.centre = vec3(0, 0, -0.15f), p.right = vec3(0.2f, 0, -0.04f), p.up = vec3(0, 0.2f, 0);
       })},
      {"edge_on", "a plane through the eye, and a thousandth beside", made([] {
         Air a = air(kSmall);
         for (const float by : {0.0f, 1e-3f, 1e-7f}) {
           ParticleRecord p = facing({by, 0, -3}, 1);
           p.right = vec3(0, 0, -2);
           a.add(p, rect(8, 2, 2));
         }
         return a;
       })},
      {"from_behind", "a quad that is turned over", one([](ParticleRecord& p) { p.right = -p.right; })},
      {"far_aside", "corners a million pixels out of the picture",
       one([](ParticleRecord& p) { p.right = vec3(3e4f, 2e4f, 0), p.up = vec3(-4, 3, -0.5f), p.softness = 0; })},
      {"half_in_a_wall", "soft where it meets the wall, gone behind it", one([](ParticleRecord& p) {
         p.centre.z = -9.9f, p.right = vec3(5, 0, -1), p.up = vec3(0, 5, 0.2f), p.softness = 0.7f;
       })},
      {"hard_in_a_wall", "softness 0: a cut", one([](ParticleRecord& p) {
         p.centre.z = -9.9f, p.right = vec3(5, 0, -1), p.up = vec3(0, 5, 0.2f), p.softness = 0;
       })},
      {"odd_depths", "no surface, NaN, infinite, denormal, nearer than the near plane", made([] {
         Air a = plume(kSmall, 6, 1);
         const float odd[] = {0, kNan, kInf, 1e-40f, 1e-31f, 2, -1, 0.02f};
         for (size_t i = 0; i < a.depth.size(); ++i) a.depth[i] = odd[i / 3 % std::size(odd)];
         return a;
       })},
  };
}

// One particle, over texels from an encoding's least to its largest exponent.
Air all_exponents(uint32_t encoding) {
  Air a = air(kSmall);
  a.params.encoding = encoding;
  for (size_t i = 0; i < a.atlas.size(); ++i)
    a.atlas[i] = encoded(dvec3(1, 0.3, 0.01) * std::exp2(static_cast<double>(i % 40) - 24), encoding);
  a.add(facing({0, 0, -2.5}, 2.5), rect(32, 1, 1));
  return a;
}
// Four particles side by side, a texel of each with a code of its own.
Air with_bad_texels(Air a, std::span<const uvec2> codes) {
  for (uint32_t i = 0; i < codes.size(); ++i) {
    a.atlas[size_t{a.side} * (8 + 3) + 8 * i + 4] = codes[i];
    a.add(facing({1.2 * i - 1.8, 0, -2.5}, 0.6), rect(8, i, 1));
  }
  return a;
}

std::vector<HardCase> atlas_cases() {
  return {
      {"no_rect", "dropped by a full atlas: ambient light alone", made([] {
         Air a = air(kSmall);
         a.add(facing({0, 0, -3}, 2), kNoRect);
         return a;
       })},
      {"rect_out_of_atlas", "words that are no rectangle of it", made([] {
         Air a = air(kSmall);
         const uint32_t words[] = {rect(8, 16, 0), rect(8, 0, 511), rect(32, 3, 3) + 1, 0xffffffffu, 0x3ffffu};
         for (uint32_t i = 0; i < std::size(words); ++i) a.add(facing({0.8 * i - 1.6, 0, -3}, 0.8), words[i]);
         return a;
       })},
      {"loud_neighbours", "a thousand times as bright beside the rectangle: no tap may reach there", made([] {
         Air a = air(kSmall);
         for (uint32_t y = 0; y < a.side; ++y)
           for (uint32_t x = 0; x < a.side; ++x)
             if (x / 8 != 4 || y / 8 != 5) a.atlas[y * a.side + x] = encoded({1000, 900, 2000}, kLightR11G11B10);
         a.add(facing({0, 0, -2.5}, 2.5), rect(8, 4, 5));
         return a;
       })},
      {"edge_of_shadow", "a step: Catmull-Rom would overshoot", made([] {
         Air a = air(kSmall);
         for (uint32_t y = 0; y < a.side; ++y)
           for (uint32_t x = 0; x < a.side; ++x)
             a.atlas[y * a.side + x] = encoded(dvec3((3 * x + y) % 16 < 8 ? 20 : 0.01), kLightR11G11B10);
         a.add(facing({0, 0, -2.5}, 2.5), rect(8, 4, 5));
         return a;
       })},
      {"rgb9e5", "another encoding, from the least to the largest exponent",
       made([] { return all_exponents(kLightRgb9e5); })},
      {"rgba16f", "two words a texel, from denormal halves to the largest",
       made([] { return all_exponents(kLightRgba16); })},
      {"no_number_codes", "infinities and NaN of R11G11B10F, each on a rectangle of its own", made([] {
         Air a = air(kSmall);
         const uvec2 codes[] = {{0x7c0u, 0}, {0x7c1u << 11, 0}, {0xf8000000u, 0}, {0xffffffffu, 0}};
         return with_bad_texels(a, codes);
       })},
      {"no_number_halves", "infinities, NaN and negative numbers of RGBA16F", made([] {
         Air a = air(kSmall);
         a.params.encoding = kLightRgba16;
         for (uvec2& t : a.atlas) t = encoded({1, 0.5, 2}, kLightRgba16);
         const uvec2 codes[] = {
             {0x7c003c00u, 0x3c00u}, {0xfc003c00u, 0x3c00u}, {0x3c007e00u, 0x3c00u}, {0xc400c400u, 0xc400u}};
         return with_bad_texels(a, codes);
       })},
      {"denormal_texels", "R11G11B10F's least numbers, in a dark picture", made([] {
         Air a = air(kSmall);
         for (vec4& t : a.radiance) t = vec4(0, 0, 0, 1);
         for (size_t i = 0; i < a.atlas.size(); ++i)
           a.atlas[i] = encoded(dvec3(std::exp2(-13 - static_cast<double>(i % 7))), kLightR11G11B10);
         ParticleRecord p = facing({0, 0, -2.5}, 2.5);
         p.albedo = vec3(1000);
         a.add(p, rect(16, 1, 1));
         return a;
       })},
      {"each_size", "rectangles of 8, 16 and 32 texels, turned", made([] {
         Air a = air(kSmall);
         for (uint32_t i = 0; i < 3; ++i) {
           ParticleRecord p = facing({1.6 * i - 1.6, 0, -2.5}, 0.8);
           p.right = vec3(0.6f, 0.5f, 0), p.up = vec3(-0.5f, 0.6f, 0);
           a.add(p, rect(8u << i, 1, 1));
         }
         return a;
       })},
  };
}

std::vector<HardCase> order_cases() {
  return {
      {"layers", "12 over each other: their order is seen", made([] {
         Air a = air(kSmall);
         for (uint32_t i = 0; i < 12; ++i)
           a.add(facing({0.1 * i - 0.5, 0.05 * i, -4 + 0.2 * i}, 1.5), rect(8, i, i % 3));
         return a;
       })},
      {"order_odd", "entries past the records, and one twice", made([] {
         Air a = plume(kSmall, 5, 1);
         a.order = {4, 7, 0, 0xffffffffu, 0, 5, 2};
         return a;
       })},
      {"not_finite_picture", "NaN and infinities beneath", made([] {
         Air a = air(kSmall);
         for (size_t i = 0; i < a.radiance.size(); ++i) a.radiance[i][static_cast<int>(i % 3)] = i % 2 ? kNan : kInf;
         a.add(facing({0, 0, -3}, 1.2), rect(16, 1, 1));
         return a;
       })},
      {"corners_apart", "a light at one corner: both triangles of the quad differ", made([] {
         Air a = air(kSmall);
         a.add(facing({0, 0, -2.5}, 2.5), rect(8, 1, 1));
         a.lights.push_back(
             {.position = vec3(2.4f, 2.4f, -2), .range = 0, .colour = vec3(9, 6, 3), .kind = kLightPoint});
         a.lights.push_back(
             {.position = vec3(-2.4f, 1.4f, -2), .range = 3, .colour = vec3(1, 6, 3), .kind = kLightPoint});
         return a;
       })},
      {"light_inside", "a light on the particle, and 5 cm above it", made([] {
         Air a = air(kSmall);
         a.add(facing({0, 0, -2.5}, 2), rect(8, 1, 1));
         a.lights.push_back(
             {.position = vec3(0.3f, 0.2f, -2.5f), .range = 4, .colour = vec3(0.02f), .kind = kLightPoint});
         a.lights.push_back({.position = vec3(-0.5f, 0, -2.45f), .range = 4, .colour = vec3(1), .kind = kLightPoint});
         return a;
       })},
  };
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto group : {size_cases(), record_cases(), view_cases(), atlas_cases(), order_cases()})
    for (HardCase& h : group) {
      h.make = [make = h.make, name = h.name] {
        Case c = make();
        c.name = name;
        return c;
      };
      all.push_back(std::move(h));
    }
  return all;
}

std::vector<Mutant> mutants() {
  return {{"common.glsl", 1, "what is no number is drawn", "no_numbers"},
          {"quad.vert", 2, "quads through the near plane left out", "through_near_plane"},
          {"fragment.glsl", 3, "the pixel's corner for its centre", "odd_extent"},
          {"fragment.glsl", 4, "the profile not squared", "odd_extent"},
          {"fragment.glsl", 5, "particles behind a surface show through", "hard_in_a_wall"},
          {"fragment.glsl", 6, "no fade where it meets a surface", "half_in_a_wall"},
          {"fragment.glsl", 7, "no fade at the near plane", "at_near_plane"},
          {"fragment.glsl", 8, "albedo forgotten", "odd_extent"},
          {"atlas.glsl", 9, "rectangles outside of the atlas are read", "rect_out_of_atlas"},
          {"atlas.glsl", 10, "taps leave the rectangle", "loud_neighbours"},
          {"atlas.glsl", 11, "half a texel off", "odd_extent"},
          {"bilinear.frag", 12, "down by the fraction across", "odd_extent"},
          {"b_spline.frag", 13, "weights mirrored", "odd_extent"},
          {"catmull_rom.frag", 14, "overshoots at a shadow's edge", "edge_of_shadow"},
          {"lit.glsl", 15, "the last light left out", "odd_extent"},
          {"corners.comp", 16, "all corners lit as the first", "one_pixel"},
          {"per_vertex.frag", 17, "the other diagonal", "corners_apart"},
          {"atlas.glsl", 18, "without a rectangle black", "no_rect"}};
}

}  // namespace assay::particles
