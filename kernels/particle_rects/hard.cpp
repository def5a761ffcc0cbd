// Named hard cases, and the faults that they must find.
#include <cmath>
#include <limits>

#include "harness/particle_scenes.h"
#include "harness/particles.h"
#include "kernels/particle_rects/inputs.h"

namespace assay::particle_rects {

using glm::dvec3;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr ParticleAtlas kSmall = {64, {16, 16, 32}};  // 2 of 32x32, 4 of 16x16, 16 of 8x8

// Whose square on a screen of 1000 pixels has so long a side: at z = 10 the half axes are side / 100, to the bit.
ParticleRecord of_side(double side, double z = 10) {
  ParticleRecord p = facing_particle({0, 0, -z}, 1);
  const auto half = static_cast<float>(side * z / 1000);
  p.right = vec3(half, 0, 0), p.up = vec3(0, half, 0);
  return p;
}
std::vector<ParticleRecord> copies(uint32_t count, const ParticleRecord& p) { return {count, p}; }

uint32_t word(uint32_t x, uint32_t y, uint32_t size) { return x / 8 | y / 8 << 9 | size << 18; }
constexpr uint32_t k8 = 1, k16 = 2, k32 = 3;

RectParams of_1000(const ParticleAtlas& atlas) { return view(atlas, 1000); }

std::vector<HardCase> counts() {
  std::vector<HardCase> cases = {
      {"none", "no particles: nothing runs, nothing is written", [] { return case_of(of_1000(kSmall), {}); }}};
  for (const uint32_t n : {1u, 255u, 256u, 257u, 5000u})
    cases.push_back({"particles_" + std::to_string(n), "beside a block's end, all sizes among them", [n] {
                       Pcg32 rng(n);
                       std::vector<ParticleRecord> all;
                       for (uint32_t i = 0; i < n; ++i) all.push_back(of_side(std::exp2(rng.range(2, 9))));
                       return case_of(of_1000(particle_atlas_of(n)), all);
                     }});
  cases.push_back({"particles_100000", "391 blocks, whose sums take two turns; the atlas is full", [] {
                     Pcg32 rng(5);
                     std::vector<ParticleRecord> all;
                     for (uint32_t i = 0; i < 100000; ++i) all.push_back(of_side(std::exp2(rng.range(2, 8))));
                     return case_of(of_1000({4096, {1024, 1024, 2048}}), all);
                   }});
  cases.push_back({"more_than_most", "131,080 particles: the last eight are not looked at", [] {
                     return case_of(of_1000({4096, {4096, 0, 0}}), copies(131080, of_side(20)));
                   }});
  return cases;
}

std::vector<HardCase> sizes() {
  return {
      {"boundaries", "quads a step of float below, at and above the size at which more texels are wanted",
       [] {
         std::vector<ParticleRecord> all;
         for (const double side : {0.03125, 64.0, 128.0})
           for (const float towards : {0.0f, kInf})
             for (int steps = 0; steps < 3; ++steps) {
               ParticleRecord p = of_side(side, 8);  // halves of 8 / 1000 are no floats; of 1024 pixels they are
               p.right.x = p.up.y = static_cast<float>(side / 128);
               for (int k = 0; k < steps; ++k) p.right.x = std::nextafter(p.right.x, towards);
               all.push_back(p);
             }
         return case_of(view({256, {64, 64, 128}}, 1024), all);
       }},
      {"distances", "the same quad ever farther away",
       [] {
         std::vector<ParticleRecord> all;
         for (double z = 0.05; z < 3e6; z *= 1.7) {
           ParticleRecord p = of_side(100, 10);
           p.centre.z = static_cast<float>(-z), all.push_back(p);
         }
         return case_of(of_1000({512, {128, 128, 256}}), all);
       }},
      {"quality", "as if larger or smaller than it is; 0 is not lit",
       [] {
         std::vector<ParticleRecord> all;
         for (const float q : {0.0f, -1.0f, 1e-4f, 0.5f, 0.6f, 1.0f, 1.5f, 2.0f, 1e6f, 1e30f, kInf, kNan}) {
           all.push_back(of_side(90)), all.back().quality = q;
         }
         return case_of(of_1000({256, {64, 64, 128}}), all);
       }},
      {"whole_screen", "one particle over all of it, the eye in it",
       [] { return case_of(of_1000(kSmall), {of_side(1e5, 0.01)}); }},
      {"across_the_near_plane", "centres behind the near plane and the eye, edges in front, and not",
       [] {
         std::vector<ParticleRecord> all;
         for (const float z : {0.05f, 0.0f, -0.05f, -3.0f})
           for (const float reach : {0.01f, 0.2f, 4.0f}) {
             ParticleRecord p = of_side(100);
             p.centre = vec3(0, 0, -z), p.up = vec3(0, 0.1f, reach);
             all.push_back(p);
           }
         return case_of(of_1000({256, {64, 64, 128}}), all);
       }},
      {"size_0", "no extent along one axis or both, or parallel axes: no area",
       [] {
         std::vector<ParticleRecord> all(4, of_side(100));
         all[0].right = vec3(0), all[1].up = vec3(0), all[1].right = vec3(0), all[2].up = all[2].right * 3.0f;
         return case_of(of_1000(kSmall), all);
       }},
      {"beside_the_picture", "wholly beyond a side, across it, and within, of all four sides",
       [] {
         std::vector<ParticleRecord> all;
         for (const dvec3& way : {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0)})
           for (const double at : {9.0, 10.2, 12.0}) {
             all.push_back(of_side(100));
             all.back().centre = vec3(way * at + dvec3(0, 0, -10));
           }
         return case_of(of_1000({256, {64, 64, 128}}), all);
       }},
  };
}

std::vector<HardCase> odd_particles() {
  return {
      {"not_seen", "opacity 0, below it, NaN",
       [] {
         std::vector<ParticleRecord> all;
         for (const float o : {0.0f, -0.0f, -1.0f, kNan, kInf, -kInf, 1e-40f, 2.0f})
           all.push_back(of_side(100)), all.back().opacity = o;
         return case_of(of_1000(kSmall), all);
       }},
      {"not_numbers", "NaN and infinities in centre and axes",
       [] {
         std::vector<ParticleRecord> all;
         for (const float bad : {kNan, kInf, -kInf})
           for (int i = 0; i < 9; ++i) {
             ParticleRecord p = of_side(100);
             (i < 3 ? p.centre : i < 6 ? p.right : p.up)[i % 3] = bad;
             all.push_back(p);
           }
         all.push_back(of_side(100));
         return case_of(of_1000(kSmall), all);
       }},
      {"huge_and_tiny", "numbers that would overflow, and denormal ones",
       [] {
         std::vector<ParticleRecord> all;
         for (const float v : {3e38f, 1e20f, 1e10f, 8192.0f, 1e-10f, 1e-20f, 1e-40f})
           for (int i = 0; i < 9; ++i) {
             ParticleRecord p = of_side(100);
             (i < 3 ? p.centre : i < 6 ? p.right : p.up)[i % 3] = i % 2 ? -v : v;
             all.push_back(p);
           }
         return case_of(of_1000({256, {64, 64, 128}}), all);
       }},
      {"odd_view", "a view of no pixels, and planes that are no numbers",
       [] {
         RectParams p = of_1000(kSmall);
         p.pixels = kInf, p.near_plane = kNan, p.left = vec3(kNan), p.top = vec3(kInf, 0, 0);
         return case_of(p, {of_side(100), of_side(10), of_side(1e-3)});
       }},
  };
}

std::vector<HardCase> rooms() {
  return {
      {"steps_down", "three of 32x32 where two fit, and the rest of 16x16 goes to who is before",
       [] {
         std::vector<ParticleRecord> all = copies(3, of_side(200));
         for (int i = 0; i < 3; ++i) all.push_back(of_side(100));
         return case_of(of_1000(kSmall), all);
       }},
      {"steps_down_twice", "all want 32x32: 2, 4 and 16 have something, 8 nothing",
       [] { return case_of(of_1000(kSmall), copies(30, of_side(200))); }},
      {"full_by_one", "a slot for all but the last",
       [] {
         return case_of(of_1000({32, {8, 0, 0}}), copies(5, of_side(20)));
       }},
      {"no_room", "no atlas at all: all are dropped",
       [] {
         return case_of(of_1000({0, {0, 0, 0}}), copies(3, of_side(100)));
       }},
      {"one_region", "there is room for 32x32 only, and small ones do not step up",
       [] {
         return case_of(of_1000({64, {0, 0, 64}}), {of_side(200), of_side(100), of_side(20)});
       }},
      {"odd_atlas", "sides that are no multiples, regions beyond the side: cut down",
       [] {
         return case_of(of_1000({1000, {4000000000u, 100, 333}}), copies(2000, of_side(100)));
       }},
      {"atlas_too_large", "beyond 4096 a side",
       [] {
         return case_of(of_1000({5000, {5000, 5000, 5000}}), copies(300, of_side(200)));
       }},
  };
}

std::vector<HardCase> frames() {
  return {
      {"kept", "each where it was, in the other order",
       [] {
         return case_of(of_1000(kSmall), copies(4, of_side(100)),
                        {word(48, 32, k16), word(32, 32, k16), word(16, 32, k16), word(0, 32, k16)});
       }},
      {"kept_though_later", "one that was there keeps its own before one that is new and comes first",
       [] {
         return case_of(of_1000(kSmall), copies(3, of_side(200)), {kNoRect, word(0, 0, k32), word(32, 0, k32)});
       }},
      {"claimed_twice", "a rectangle that two or three say was theirs: the lowest has it",
       [] {
         return case_of(of_1000(kSmall), copies(4, of_side(100)),
                        {word(0, 32, k16), word(32, 32, k16), word(32, 32, k16), word(32, 32, k16)});
       }},
      {"another_size", "what had 32x32 and now wants 16x16, and the other way round",
       [] {
         return case_of(of_1000(kSmall), {of_side(100), of_side(200), of_side(20)},
                        {word(32, 0, k32), word(48, 32, k16), word(32, 32, k16)});
       }},
      {"stepped_down_before", "what found a smaller one in the frame before keeps that",
       [] {
         return case_of(of_1000(kSmall), copies(4, of_side(200)),
                        {word(0, 0, k32), word(32, 0, k32), word(48, 32, k16), word(16, 32, k16)});
       }},
      {"previous_garbage", "words of no slot: between slots, in another region, out of the atlas, bits above",
       [] {
         return case_of(of_1000(kSmall), copies(9, of_side(100)),
                        {word(8, 32, k16), word(0, 40, k16), word(0, 0, k16), word(0, 48, k16), word(64, 32, k16),
                         word(16, 32, k16) | 1u << 20, 0xffffffffu, word(0, 32, k8), word(0, 32, k32)});
       }},
      {"words_between_slots", "rectangles of 16x16 that begin in the middle of one, and one that is whole",
       [] {
         return case_of(of_1000({128, {0, 128, 0}}), copies(3, of_side(100)),
                        {word(24, 8, k16), word(40, 16, k16), word(48, 32, k16)});
       }},
  };
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = counts();
  for (auto& more : {sizes(), odd_particles(), rooms(), frames()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {{"wanted.glsl", 1, "of a quad its centre alone is looked at", "whole_screen"},
          {"wanted.glsl", 2, "what lies above the picture is lit", "beside_the_picture"},
          {"wanted.glsl", 3, "at a boundary the smaller", "boundaries"},
          {"wanted.glsl", 4, "opacity 0 is lit", "not_seen"},
          {"wanted.glsl", 5, "no least distance", "whole_screen"},
          {"common.glsl", 6, "a rectangle of another size is taken for one of this", "another_size"},
          {"common.glsl", 7, "slots that begin where none does", "previous_garbage"},
          {"common.glsl", 8, "to the highest of those that had it", "claimed_twice"},
          {"common.glsl", 9, "none is smaller than wanted", "steps_down"},
          {"common.glsl", 10, "who finds no room is dropped", "steps_down"},
          {"common.glsl", 11, "a particle's last block is left out", "particles_1"},
          {"count.glsl", 12, "who keeps his own counts as one that wants another", "kept"},
          {"list.glsl", 13, "free slots from the second place on", "particles_1"},
          {"place.glsl", 14, "the smaller rectangles are all given anew", "kept"},
          {"single_group.comp", 15, "every run begins at the first rank", "particles_255"},
          {"harness/glsl/scan.glsl", 9821, "the barrier between steps dropped", "particles_257"}};
}

}  // namespace assay::particle_rects
