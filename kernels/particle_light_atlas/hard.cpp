// Named hard cases.
#include <limits>

#include "harness/clusters.h"
#include "harness/light_records.h"
#include "harness/particle_scenes.h"
#include "kernels/particle_light_atlas/inputs.h"

namespace assay::particle_light_atlas {

using glm::dvec3;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
const vec3 kWhite = vec3(10, 10, 10), kRed = vec3(10, 0.5f, 0.5f), kBlue = vec3(0.3f, 0.5f, 8);

std::function<Case()> made(std::function<Scene()> make) {
  return [make = std::move(make)] { return to_case(make()); };
}

// One puff 3 m away, of a size, a lamp to its right and nearer, a sun from the left above.
Scene puff(uint32_t size, double radius = 0.5) {
  Scene s(64);
  s.add(facing_particle({0.3, -0.2, -3}, radius, 0.4), size);
  s.lights = {point({1.5, 0.5, -2.2}, 9, kRed), directional({0.5, -1, -0.5}, vec3(0.4f, 0.6f, 0.9f))};
  return s;
}

Scene under(const std::vector<LightRecord>& lights) {
  Scene s = puff(2);
  s.lights = lights;
  return s;
}

std::vector<HardCase> particle_cases() {
  return {
      {"one_particle", "32x32, sixteen blocks of one rectangle", made([] { return puff(3); })},
      {"one_block", "8x8: a quarter of a group", made([] { return puff(1); })},
      {"no_particles", "a dispatch of no groups: nothing is written", made([] { return Scene(64); })},
      {"every_size", "an atlas full to the last slot", made([] {
         Scene s = puff(3);
         Pcg32 rng(3);
         for (uint32_t size = 3; size > 0; --size)
           while (s.add(random_particle(rng, 1, 9), size)) {
           }
         return s;
       })},
      {"many_blocks", "100,000 particles' records, of which 4,096 are lit, eight by eight", made([] {
         Scene s(1024);
         s.lights = puff(1).lights;
         Pcg32 rng(9);
         for (uint32_t i = 0; i < 100000; ++i) s.add(random_particle(rng, 1, 30), 1);
         return s;
       })},
      {"whole_screen", "a quad that the eye is nearly in, 100 m wide", made([] {
         Scene s = puff(3);
         s.particles[0] = facing_particle({0.01, 0, -0.12}, 100);
         return s;
       })},
      {"tiny_particle", "axes of 10 micrometres, whose cross product is below the shortest vector", made([] {
         Scene s = puff(2, 1e-5);
         s.lights[0].position = vec3(0.5f, 0, -2.9f);
         return s;
       })},
      {"size_0", "no axes: no plane, no normal, and no light but ambient light", made([] {
         Scene s = puff(1);
         s.particles[0].right = s.particles[0].up = vec3(0);
         return s;
       })},
      {"one_axis", "axes that are parallel: any normal will do", made([] {
         Scene s = puff(1);
         s.particles[0].up = s.particles[0].right * 3.0f;
         return s;
       })},
      {"edge_on", "the eye in the quad's plane: either side may be the front", made([] {
         Scene s = puff(2);
         s.particles[0].right = vec3(0.5f, 0, 0), s.particles[0].up = vec3(0, 0, 0.5f);
         s.particles[0].centre = vec3(0.25f, 0, -3);
         return s;
       })},
      {"off_the_picture", "quads across the picture's sides and behind the eye: the nearest cells", made([] {
         Scene s(64);
         for (const dvec3& at :
              {dvec3(3, 0, -3), dvec3(-3, 0.5, -3), dvec3(0, 3.2, -3), dvec3(0, -3, -3), dvec3(0.5, 0, 1)})
           s.add(facing_particle(at, 1.5), 1);
         s.lights = puff(1).lights;
         return s;
       })},
      {"not_numbers", "NaN, infinite and far too large numbers: lit by ambient light alone", made([] {
         Scene s = puff(1);
         for (const float bad : {kNan, kInf, -kInf, 2e6f, 3e38f})
           for (int i = 0; i < 9 && s.placed[1] < s.region(1).slots; i += 4) {
             ParticleRecord p = s.particles[0];
             (i < 3 ? p.centre : i < 6 ? p.right : p.up)[i % 3] = bad;
             s.add(p, 1);
           }
         return s;
       })},
  };
}

std::vector<HardCase> light_cases() {
  return {
      {"no_light", "no record to read: ambient light, and a direction of none", made([] { return under({}); })},
      {"two_lights", "a strong one and a weak one: the direction is near the strong one's", made([] {
         return under({point({2, 0, -3}, 9, kWhite), point({-2, 0.5, -2}, 9, vec3(0.1f))});
       })},
      {"light_behind", "half of it comes through", made([] {
         return under({point({0.2, 0.1, -5}, 9, kBlue)});
       })},
      {"light_in_the_particle", "on the quad, at a texel and between texels: no nearer than 1 cm", made([] {
         Scene s = puff(3);
         const ParticleRecord& p = s.particles[0];
         s.lights = {point(dvec3(p.centre), 2, kRed), point(dvec3(p.centre + p.right * 0.03125f), 2, kBlue)};
         return s;
       })},
      {"light_close_by", "5 cm before the quad: within a rectangle it changes by orders of magnitude", made([] {
         Scene s = puff(2);
         s.lights = {point(dvec3(s.particles[0].centre) * 0.984, 2, kWhite)};
         return s;
       })},
      {"opposite_lights", "two that cancel: no direction dominates", made([] {
         Scene s = puff(2);
         s.particles[0] = facing_particle({0, 0, -4}, 0.5);
         s.lights = {directional({1, 0, -1}, kWhite), directional({-1, 0, 1}, kWhite)};
         return s;
       })},
      {"bright", "more than any encoding holds: the largest of each", made([] {
         return under({directional({0, 0, -1}, vec3(1e6f, 3e5f, 2e5f)), directional({0, 0, -1}, vec3(0, 0, 1e30f))});
       })},
      {"dark", "denormal codes, and less than the least", made([] {
         Scene s = under({directional({0.2, 0, -1}, vec3(1e-4f, 1e-5f, 1e-6f)),
                          directional({0, 0.3, -1}, vec3(3e-6f, 1e-7f, 1e-8f))});
         s.params.ambient = vec3(0);
         return s;
       })},
      {"negative_light", "it darkens, to 0 at most, and has no direction", made([] {
         return under({directional({0, 0, -1}, vec3(-1, -2, 0.5f)), point({1, 0, -2}, 9, vec3(0.2f))});
       })},
      {"lights_no_numbers", "NaN and infinities in a light: it sheds none", made([] {
         Scene s = puff(2);
         for (const float bad : {kNan, kInf, -kInf}) {
           s.lights.push_back(point({1, 0, -2}, 9, vec3(bad, 1, 1)));
           s.lights.push_back(point({bad, 0, -2}, 9, kWhite));
           s.lights.push_back(directional({0, 0, -1}, kWhite));
           s.lights.back().direction.y = bad;
         }
         return s;
       })},
      {"unknown_kind", "no light of a kind that does not exist", made([] {
         Scene s = puff(2);
         s.lights[0].kind = 3, s.lights.push_back(s.lights[0]), s.lights[2].kind = 0xffffffffu;
         return s;
       })},
  };
}

std::vector<HardCase> list_cases() {
  return {
      {"cells_of_one_light", "each cell lists another light, cells smaller than a block, ten slices", made([] {
         Scene s = puff(3, 1.2);
         Pcg32 rng(4);
         s.particles[0] = facing_particle({0, 0, -3}, 1.2);
         s.particles[0].up.z = 1.5f;
         for (uint32_t i = 0; i < 64; ++i)
           s.lights.push_back(point({rng.range(-2, 2), rng.range(-2, 2), rng.range(-3, 0)}, 9,
                                    vec3(rng.range(1, 9), rng.range(1, 9), rng.range(1, 9))));
         s.add_cells(8, slice_edges(1, 8, 10), [](uint32_t cell) { return std::vector<uint32_t>{cell * 7 % 66}; });
         return s;
       })},
      {"no_cells", "a grid of none: no light but ambient light, of those that walk lists", made([] {
         Scene s = puff(1);
         s.add_cells(64, slice_edges(1, 8, 2), [](uint32_t) { return std::vector<uint32_t>{0}; });
         s.params.grid = {0, 0, 0, 1, 1}, s.slice_edges.resize(1);
         s.cells.clear();
         return s;
       })},
      {"lists_past_the_end", "entries past the last, lights past the last", made([] {
         Scene s = puff(2);
         s.add_cells(64, slice_edges(1, 8, 2), [](uint32_t) { return std::vector<uint32_t>{0, 1, 2, 4095}; });
         for (uvec2& cell : s.cells) cell += uvec2(1, 40);
         return s;
       })},
      {"lights_4096", "all that cells can name, of 300 in each the first 256", made([] {
         Scene s = puff(1);
         Pcg32 rng(8);
         s.lights.clear();
         for (uint32_t i = 0; i < 4096; ++i)
           s.lights.push_back(point({rng.range(-2, 2), rng.range(-2, 2), rng.range(-4, 0)}, 3, vec3(0.1f)));
         s.add_cells(64, slice_edges(1, 8, 2), [](uint32_t cell) {
           std::vector<uint32_t> all;
           for (uint32_t i = 0; i < 300; ++i) all.push_back((cell + 13 * i) % 4096);
           return all;
         });
         return s;
       })},
  };
}

std::vector<HardCase> word_cases() {
  return {
      {"garbage_words", "rectangles out of the atlas and of none, blocks past them, particles past the last", made([] {
         Scene s(128);
         for (uint32_t i = 0; i < 6; ++i) s.add(puff(1).particles[0], 1 + i % 3);
         s.lights = puff(1).lights;
         s.rects[0] = 0xffffffffu, s.rects[1] |= kRectXBits, s.rects[2] = 0;
         for (const uint32_t word : {0xffffffffu, 6u << 4, 3u << 4 | 15, 4u << 4 | 4, 0x80000000u})
           s.blocks.push_back(word);
         return s;
       })},
      {"rects_overlap", "two particles' rectangles over one another, the light of either", made([] {
         Scene s = puff(2);
         s.add(facing_particle({-1, 0, -2}, 0.2), 2);
         s.rects[1] = s.rects[0] + 1;
         return s;
       })},
      {"count_overflows", "a count of more blocks than the list has: those that there are",
       [] {
         Case c = to_case(puff(2));
         c.set_input("counts", std::vector<ParticleRectCounts>{{0xffffffffu, 0, 0, 0}});
         c.set_input("args", std::vector<DispatchArgs>{{70, 3, 1}});
         return c;
       }},
      {"rows_of_groups", "65,536 blocks and more, of which most are listed twice: two rows of groups",
       [] {
         Scene s = puff(2);
         const std::vector<uint32_t> four = s.blocks;
         while (s.blocks.size() <= 4 * 65535) s.blocks.insert(s.blocks.end(), four.begin(), four.end());
         s.add(facing_particle({-1, 0, -2}, 0.2), 2);
         return to_case(s);
       }},
  };
}

std::vector<HardCase> shadow_cases() {
  constexpr uint32_t kSide = 32;
  const auto lit_through = [](float depth) {
    return made([depth] {
      Scene s = puff(3);
      s.lights.push_back(spot({-1, 1.5, -2}, {1, -1.5, -1}, 9, 0.3, 0.6, kBlue));
      s.shadows = shadowing::Atlas({6 * kSide, 3 * kSide});
      s.lights[0].views = 6;
      s.lights[0].first_view = s.shadows.add_cube({0, 0, kSide}, dvec3(s.lights[0].position), 0.05, 9);
      s.lights[1].views = 1;
      s.lights[1].first_view =
          s.shadows.add_cascade({0, kSide, kSide}, {0, 0, -3}, dvec3(s.lights[1].direction), 8, 10, 9);
      s.lights[2].views = 1;
      s.lights[2].first_view = s.shadows.add_spot({0, 2 * kSide, kSide}, dvec3(s.lights[2].position),
                                                  dvec3(s.lights[2].direction), 0.7, 0.05, 9);
      for (const ShadowView& view : s.shadows.views) s.shadows.fill(view.tile, depth);
      return s;
    });
  };
  return {{"all_lit", "maps that hold nothing: as without shadows", lit_through(0)},
          {"all_dark", "maps of the nearest depth: ambient light alone, and no direction", lit_through(1)},
          {"step_shadow", "an edge across the quad", made([] {
             Scene s = puff(3);
             s.lights = {point({0, 0, -1}, 9, kWhite)};
             s.shadows = shadowing::Atlas({6 * kSide, kSide});
             s.lights[0].views = 6, s.lights[0].first_view = s.shadows.add_cube({0, 0, kSide}, {0, 0, -1}, 0.05, 9);
             for (uint32_t view = 0; view < 6; ++view) s.shadows.draw(view, {{0.9, 0, -2}, {0, 0, 1}, 0.8});
             return s;
           })}};
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = particle_cases();
  for (auto& more : {light_cases(), list_cases(), word_cases(), shadow_cases()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace assay::particle_light_atlas
