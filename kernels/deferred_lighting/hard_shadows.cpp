// Hard cases of shadows. The lookup's own are in kernels/shadow_lookup.
#include <cmath>

#include "kernels/deferred_lighting/inputs.h"
#include "kernels/deferred_lighting/picture.h"

namespace assay::deferred_lighting {

using glm::dvec3;

namespace {

constexpr uint32_t kSide = 32;
const vec3 kWhite = vec3(10, 10, 10);

std::function<Case()> made(std::function<Picture()> make) {
  return [make = std::move(make)] { return to_case("", make()); };
}

// The wall under a sun, a lamp and a spot with views of it; all maps hold one depth.
Picture under_three(Extent e, float depth) {
  Picture p = wall(e);
  const dvec3 lamp = {0.5, 0.4, -1}, cone = {-0.8, 0.6, -0.5}, down = {0.2, -0.3, -1};
  p.lights = {directional(down, vec3(1, 2, 3)), point(lamp, 9, kWhite), spot(cone, down, 9, 0.4, 0.7, kWhite)};
  p.atlas = shadowing::Atlas({kCubeFaces * kSide, 3 * kSide});
  p.lights[0].views = 1, p.lights[0].first_view = p.atlas.add_cascade({0, 0, kSide}, {0, 0, -3}, down, 8, 10, 9);
  p.lights[1].views = 6, p.lights[1].first_view = p.atlas.add_cube({0, kSide, kSide}, lamp, 0.05, 9);
  p.lights[2].views = 1, p.lights[2].first_view = p.atlas.add_spot({0, 2 * kSide, kSide}, cone, down, 0.8, 0.05, 9);
  for (const ShadowView& view : p.atlas.views) p.atlas.fill(view.tile, depth);
  return p;
}

// A slanted wall through a point of the axis, drawn into the maps of its lights.
Picture leaning(Extent e, const dvec3& normal) {
  Picture p = under_three(e, 0);
  const dvec3 centre = {0, 0, -3};
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) {
      p.place(x, y, glm::dot(normal, centre) / glm::dot(normal, p.ray(x + 0.5, y + 0.5)));
      p.face(x, y, normal), p.lean(x, y, normal);
    }
  for (uint32_t view = 0; view < p.atlas.views.size(); ++view) p.atlas.draw(view, {centre, normal});
  return p;
}

}  // namespace

std::vector<HardCase> shadow_cases() {
  return {
      {"all_lit", "maps that hold nothing: as without shadows", made([] {
         return under_three({48, 40}, 0);
       })},
      {"all_dark", "maps of the nearest depth: ambient light alone", made([] {
         return under_three({48, 40}, 1);
       })},
      {"half_dark", "a step across each map, with every share between", made([] {
         Picture p = under_three({64, 64}, 0);
         for (const ShadowView& view : p.atlas.views)
           for (uint32_t y = 0; y < kSide; ++y)
             for (uint32_t x = 0; x < kSide / 2 + y % 4; ++x) p.atlas.fill({view.tile.x + x, view.tile.y + y, 1}, 1);
         return p;
       })},
      {"leaning_planes", "a wall at 60 degrees, drawn into the maps itself: lit all over, if its plane is known",
       made([] {
         return leaning({64, 64}, glm::normalize(dvec3(0.8, 0.9, 0.7)));
       })},
      {"dithered_cascades", "pixels at the rims of cascades, alternately dark, in a frame that is not the first",
       made([] {
         Picture p = wall({64, 64});
         p.params.frame = 7;
         p.lights = {directional({0, 0, -1}, kWhite)};
         p.atlas = shadowing::Atlas({3 * kSide, kSide});
         for (uint32_t i = 0; i < 3; ++i) {
           p.atlas.add_cascade({i * kSide, 0, kSide}, {0, 0, -3}, {0, 0, -1}, 0.8 * std::exp2(i), 10, 9);
           if (i % 2 == 0) p.atlas.fill({i * kSide, 0, kSide}, 1);
         }
         p.lights[0].views = 3;
         return p;
       })},
      {"gradients_of_no_plane", "NaN, infinite, largest, least and denormal gradients", made([] {
         Picture p = under_three({64, 64}, 0.4f);
         const uint16_t codes[] = {0x7e00, 0x7c00, 0xfc00, 0x7bff, 0xfbff, 0x0001, 0x8001, 0x0400, 0, 0x3c00};
         for (uint32_t i = 0; i < 64 * 64; ++i) p.gradients.push_back({codes[i % 10], codes[i / 10 % 10]});
         return p;
       })},
      {"views_that_are_none", "first views past the end, more views than there are", made([] {
         Picture p = under_three({40, 40}, 1);
         p.lights[0].first_view = 8, p.lights[1].first_view = 6, p.lights[2].views = 0xffffffffu;
         p.lights.push_back(p.lights[2]);
         p.lights.back().first_view = 0xffffffffu;
         return p;
       })},
  };
}

}  // namespace assay::deferred_lighting
