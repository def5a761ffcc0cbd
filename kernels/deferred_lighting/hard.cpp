#include <cmath>
#include <limits>

#include "kernels/deferred_lighting/inputs.h"
#include "kernels/deferred_lighting/picture.h"

namespace assay::deferred_lighting {

using glm::dvec3;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
const vec3 kWhite = vec3(10, 10, 10);

std::function<Case()> made(std::function<Picture()> make) {
  return [make = std::move(make)] { return to_case("", make()); };
}

Picture lit_wall(Extent e, uint32_t lights) {
  Picture p = wall(e);
  Pcg32 rng(7);
  add_lights(p, rng, lights, 3);
  return p;
}

std::vector<HardCase> size_cases() {
  const auto size = [](Extent e) { return [e] { return typical(e); }; };
  return {
      {"one_pixel", "one lane of one group is alive", made([] {
         return lit_wall({1, 1}, 3);
       })},
      {"one_group", "exactly one group", size({16, 16})},
      {"one_group_and_one", "three more groups for one row and one column", size({17, 17})},
      {"odd_extent", "rows that start in the middle of a subgroup of any width", made([] {
         return lit_wall({31, 33}, 5);
       })},
      {"wide", "width and height cannot be swapped", made([] {
         return lit_wall({200, 3}, 5);
       })},
      {"full_hd_and_one", "an odd extent of real size", size({1921, 1081})},
      {"ultra_hd", "3840x2160, the largest frame", size({3840, 2160}), true},
  };
}

// Every byte of base colour, roughness, metallic and occlusion appears.
void fill_codes(Picture& p) {
  for (uint32_t y = 0; y < p.extent.height; ++y)
    for (uint32_t x = 0; x < p.extent.width; ++x) {
      const uint32_t i = y * p.extent.width + x;
      p.base[i] = base_code(i % 256, (i + 85) % 256, (255 - i) % 256, i * 7 % 256);
      p.metal[i] = metal_code(i * 3 % 256, i * 5 % 256);
      p.face(x, y, {0.3 * std::sin(x), 0.3 * std::cos(y), 1});
    }
}

std::vector<HardCase> surface_cases() {
  return {
      {"no_light", "no record to read; every code of colour, metal and occlusion under ambient light", made([] {
         Picture p = wall({64, 64});
         fill_codes(p);
         return p;
       })},
      {"emission", "every exponent and odd mantissas of E5B9G9R9, alone and under a light", made([] {
         Picture p = lit_wall({64, 64}, 2);
         for (uint32_t i = 0; i < p.emissive.size(); ++i)
           p.emissive[i] = i % 32 << 27 | i * 37 % 512 << 18 | i * 91 % 512 << 9 | (i < 2048 ? 511u : i % 512);
         return p;
       })},
      {"background", "depth 0, denormal and least depths between surfaces: all zero, alpha too", made([] {
         Picture p = lit_wall({64, 64}, 3);
         const float depths[] = {0, 1e-40f, 1e-31f, 0.02f, 1e-8f, 1, 0.5f};
         for (uint32_t i = 0; i < p.depth.size(); ++i) p.depth[i] = depths[i % 7];
         return p;
       })},
      {"nothing_at_all", "no pixel has a surface", made([] {
         Picture p = lit_wall({40, 40}, 3);
         p.depth.assign(p.depth.size(), 0);
         return p;
       })},
      {"every_normal", "codes on the octahedron's edges, corners and folds, -32768, 0 (which is +z), and others",
       made([] {
         Picture p = lit_wall({64, 64}, 6);
         p.lights.push_back(directional({0.2, 0.3, 1}, vec3(2, 3, 4)));
         Pcg32 rng(3);
         const uint16_t edge[] = {0, 1, 0xffff, 32767, 0x8000, 0x8001, 16384, 0xc000, 16383, 0xc001};
         for (uint32_t i = 0; i < p.normal.size(); ++i)
           p.normal[i] = i < 1000 ? edge[i % 10] | static_cast<uint32_t>(edge[i / 10 % 10]) << 16 : rng.next();
         return p;
       })},
      {"every_roughness", "256 roughnesses across, 16 metals down, lights in the mirror direction and beside it",
       made([] {
         Picture p = wall({256, 16});
         for (uint32_t y = 0; y < 16; ++y)
           for (uint32_t x = 0; x < 256; ++x) {
             p.base[p.at(x, y)] = base_code(200, 120, 60, x);
             p.metal[p.at(x, y)] = metal_code(17 * y, 255);
           }
         p.lights = {point({0.5, 0.2, 0.3}, 0, kWhite), directional({0.8, -0.5, -0.3}, vec3(3)),
                     point({-4, 0, -2.9}, 9, kWhite)};
         return p;
       })},
      {"smoothest", "roughness 0, at its floor and just above; normals within 0.02 rad of the mirror direction",
       made([] {
         Picture p = wall({128, 64});
         for (uint32_t y = 0; y < 64; ++y)
           for (uint32_t x = 0; x < 128; ++x) {
             p.base[p.at(x, y)] = base_code(200, 120, 60, y % 4 == 0 ? 0 : y % 16);
             p.metal[p.at(x, y)] = metal_code(y % 2 ? 255 : 0, 255);
             const dvec3 half = -glm::normalize(p.ray(x + 0.5, y + 0.5)) + glm::normalize(dvec3(0.3, 0.5, 0.7));
             p.face(x, y, glm::normalize(half) + (0.02 * x / 128 - 0.01) * dvec3(0.7, -0.7, 0));
           }
         p.lights = {directional({-0.3, -0.5, -0.7}, vec3(0.5f, 0.4f, 0.3f))};
         return p;
       })},
      {"featured", "cloth, skin and leaves in every combination, thickness from 0 to 1, light from both sides",
       made([] {
         Picture p = lit_wall({64, 64}, 4);
         p.lights.push_back(directional({0.9, 0.1, 0.05}, vec3(1, 2, 3)));
         p.lights.push_back(point({0, 0, -4}, 10, kWhite));
         fill_codes(p);
         const uint32_t bits[] = {kFeatureCloth, kFeatureSkin, kFeatureSubsurface};
         for (uint32_t i = 0; i < p.features.size(); ++i)
           for (uint32_t b = 0; b < 3; ++b)
             if ((i / 3 >> b & 1u) != 0) p.features[i] |= bits[b];
         return p;
       })},
      {"far_away", "surfaces and lights 10^5 m from the camera: positions are off by centimetres in float", made([] {
         Picture p = wall({40, 40}, 1e5);
         Pcg32 rng(5);
         add_lights(p, rng, 8, 1e4);
         p.lights.push_back(point(p.position(20, 20) + dvec3(0.3, 0.2, 0.5), 50, kWhite));
         return p;
       })},
  };
}

std::vector<HardCase> light_cases() {
  return {
      {"light_at_the_surface", "a light on the surface, a micrometre and a millimetre before it, at the least distance",
       made([] {
         Picture p = wall({64, 64});
         for (uint32_t i = 0; i < 60; ++i) {
           const double away[] = {0, 1e-7, 1e-6, 1e-4, 1e-3, 0.00999, 0.01, 0.0101, 0.05};
           p.lights.push_back(point(p.position(i, 63 - i) + dvec3(0, 0, away[i % 9]), i % 2 ? 0 : 2, vec3(0.01f)));
         }
         return p;
       })},
      {"behind_the_surface", "lights behind the wall, in its plane, and a sun that grazes it from either side",
       made([] {
         Picture p = wall({64, 64});
         p.lights = {point({0, 0, -3.5}, 0, kWhite),       point({0.5, 0.1, -3}, 0, kWhite),
                     directional({0.1, 0.2, 1}, kWhite),   directional({1, 0, 1e-6}, kWhite),
                     directional({1, 0.3, -1e-6}, kWhite), directional({0, 1, 0}, kWhite)};
         for (size_t i = 0; i < p.base.size(); ++i)
           p.base[i] = base_code(200, 150, 100, static_cast<uint32_t>(i % 256));
         return p;
       })},
      {"against_the_eye", "light from straight behind the surface towards the eye: the half vector vanishes", made([] {
         Picture p = wall({32, 32});
         for (uint32_t y = 0; y < 32; ++y)
           for (uint32_t x = 0; x < 32; ++x) {
             const dvec3 ray = glm::normalize(p.ray(x + 0.5, y + 0.5)),
                         side = glm::normalize(glm::cross(ray, dvec3(0, 1, 0)));
             p.face(x, y, side + (0.001 * x - 0.016) * ray);
             if (y % 4 == 0) p.lights.push_back(directional(-ray + 1e-4 * (x - 16.0) * side, kWhite));
           }
         return p;
       })},
      {"along_the_normal", "normal, eye and light in one line: all sines 0, all cosines 1", made([] {
         Picture p = wall({33, 33});
         for (uint32_t y = 0; y < 33; ++y)
           for (uint32_t x = 0; x < 33; ++x) p.face_eye(x, y), p.base[p.at(x, y)] = base_code(200, 150, 100, 8 * y);
         p.lights = {directional({0, 0, -1}, vec3(1)), point({0, 0, 0}, 0, kWhite)};
         return p;
       })},
      {"range_edge", "ranges of the distance itself, one float more and less, twice it; 0 and negative, which are none",
       made([] {
         Picture p = wall({48, 48});
         for (uint32_t i = 0; i < 24; ++i) {
           const dvec3 at = p.position(2 * i, i);
           const dvec3 from = at + dvec3(0.1, 0, 0.4 + 0.02 * i);
           const auto d = static_cast<float>(glm::length(from - at));
           const float ranges[] = {d, std::nextafter(d, 0.0f), std::nextafter(d, 9.0f), 1.1f * d, 2 * d, 0, -1};
           p.lights.push_back(point(from, 0, vec3(0.5f)));
           p.lights.back().range = ranges[i % 7];
         }
         return p;
       })},
      {"cone_edge", "pixels across the edges of wide, narrow and hard cones; a half angle of 90 degrees and of 0",
       made([] {
         Picture p = wall({96, 64});
         const double inner[] = {0, 0.2, 0.3, 0.001, 0}, outer[] = {0.6, 0.2, 0.31, 0.01, 1.5707963};
         for (uint32_t i = 0; i < 15; ++i) {
           const dvec3 target = p.position(6 * i, 4 * i);
           p.lights.push_back(
               spot(target + dvec3(0.2, 0.1, 1.2), dvec3(-0.2, -0.1, -1.2), 5, inner[i % 5], outer[i % 5], vec3(3)));
         }
         return p;
       })},
      {"light_in_one_pixel", "lights that reach one pixel each: no wave may leave them out, whatever its first lane",
       made([] {
         Picture p = wall({64, 64});
         for (uint32_t i = 0; i < 64; ++i)
           p.lights.push_back(point(p.position(i, i * 29 % 64) + dvec3(0, 0, 0.02), 0.05, vec3(0.01f)));
         return p;
       })},
      {"depth_steps", "near and far surfaces in one wave, each with its own lights", made([] {
         Picture p = wall({64, 64});
         for (uint32_t y = 0; y < 64; ++y)
           for (uint32_t x = 0; x < 64; ++x) p.place(x, y, (x + y) % 2 ? 1.5 : 40);
         Pcg32 rng(11);
         add_lights(p, rng, 40, 1);
         return p;
       })},
      {"one_light_over_two_batches", "129 lights: the last batch holds one and 63 stale ones", made([] {
         return lit_wall({40, 40}, 129);
       })},
      {"many_lights", "several batches, over waves of which some have no surface and run ahead", made([] {
         Picture p = lit_wall({48, 48}, 300);
         for (uint32_t y = 0; y < 48; ++y)
           for (uint32_t x = 0; x < 48; ++x)
             if (y % 16 < 4) p.depth[p.at(x, y)] = 0;
         return p;
       })},
      {"lights_4096", "the sum of 4096", made([] {
         return lit_wall({17, 17}, 4096);
       })},
      {"too_many_lights", "one past kMostLights, and the brightest: it is not looked at", made([] {
         Picture p = wall({3, 2});
         p.lights.assign(kMostLights, point({0, 0, -2}, 1.5, vec3(1e-4f)));
         p.lights.push_back(point({0, 0, -2}, 0, vec3(1000)));
         return p;
       })},
  };
}

std::vector<HardCase> hostile_cases() {
  return {
      {"unknown_kind", "kinds 3, 4 and 2^32 - 1 shed no light", made([] {
         Picture p = lit_wall({33, 33}, 6);
         const uint32_t kinds[] = {3, 4, 0xffffffffu};
         for (uint32_t i = 0; i < 6; ++i) p.lights[i].kind = kinds[i % 3];
         p.lights.push_back(point({0, 0, -2}, 5, vec3(1)));
         return p;
       })},
      {"no_numbers", "NaN and both infinities in each field of each kind, among sound lights", made([] {
         Picture p = lit_wall({33, 33}, 4);
         for (uint32_t kind = 0; kind < 3; ++kind)
           for (const float bad : {kNan, kInf, -kInf})
             for (uint32_t field = 0; field < 6; ++field) {
               LightRecord light = spot({0.1, 0.2, -2}, {0.05, 0.1, -1}, 4, 0.3, 0.9, vec3(1, 2, 3));
               light.kind = kind;
               float* const fields[] = {&light.position.x,  &light.range,      &light.colour.y,
                                        &light.direction.z, &light.cone_scale, &light.cone_offset};
               *fields[field] = bad;
               p.lights.push_back(light);
             }
         for (size_t i = 0; i < p.features.size(); ++i)
           p.features[i] = i % 3 == 0 ? kFeatureSkin : i % 3 == 1 ? kFeatureSubsurface : kFeatureOpaque;
         return p;
       })},
      {"huge_numbers", "colours, positions, scales at the ends of float, and denormals", made([] {
         Picture p = wall({33, 33});
         for (const float big : {1e15f, 1e19f, 1e30f, 3e38f, 1e-30f, 1e-40f}) {
           p.lights.push_back(point({0, 0, -2}, 4, vec3(1)));
           p.lights.back().position.z = big;
           p.lights.push_back(spot({0, 0, -2}, {0, 0, -1}, 4, 0.2, 0.5, vec3(1)));
           p.lights.back().cone_scale = big;
           p.lights.push_back(point({0, 0, -2}, 4, vec3(1)));
           p.lights.back().range = big;
         }
         for (const float small : {1e-30f, 1e-40f}) p.lights.push_back(point({0, 0, -2}, 4, vec3(small)));
         return p;
       })},
      {"too_bright", "more than a half holds: 65504", made([] {
         Picture p = wall({33, 33});
         p.lights = {point({0, 0, -2}, 4, vec3(1e5f, 3e6f, 1)), directional({0, 0, -1}, vec3(1, 1e9f, 4e5f))};
         return p;
       })},
      {"overflowing", "sums past the largest float, and a direction whose square is: no infinity, no NaN", made([] {
         Picture p = wall({33, 33});
         p.lights = {point({1, 0, -2}, 0, vec3(1e30f, 0, 0)), point({1, 1, -2}, 0, vec3(0, 3e38f, 3e38f)),
                     directional({0, 0, -1}, vec3(1e34f, 1e6f, 0)), directional({0, 0, -1}, vec3(1))};
         p.lights.back().direction = vec3(1e20f, -1, -3e38f);
         return p;
       })},
      {"negative_light", "a light of negative colour darkens, and nothing falls below 0", made([] {
         Picture p = lit_wall({33, 33}, 2);
         p.lights.push_back(point({0, 0, -2}, 4, vec3(-3, -0.2f, 1)));
         return p;
       })},
  };
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto& more :
       {size_cases(), surface_cases(), light_cases(), hostile_cases(), cell_cases(), primary_cases(), shadow_cases()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace assay::deferred_lighting
