// Named hard cases; hostile.cpp has those that no frame should hold.
#include <cmath>
#include <functional>

#include "kernels/shadow_atlas/builder.h"

namespace assay::shadow_atlas {

using namespace raster;

namespace {

constexpr ShadowTile kMiddle = {32, 32, 32};  // of an atlas of 96 x 96, loud all about

// One tile, in both lists.
Case in_middle(const std::function<void(Builder&)>& add) {
  Builder b(96, 96);
  b.add_both(kMiddle);
  add(b);
  return b.finish();
}

// Flat triangles by texels of a tile of 32, at these distances of kFlat.
Mesh flat(const std::vector<vec3>& corners) {
  Mesh m;
  for (const vec3& c : corners) m.indices.push_back(add_vertex(m, kFlat.at(c.x / 32, c.y / 32, c.z), vec2(0)));
  return m;
}
Mesh triangle(const vec3& a, const vec3& b, const vec3& c) {
  Mesh m;
  for (const vec3& p : {a, b, c}) m.indices.push_back(add_vertex(m, p, vec2(p.x, p.y)));
  return m;
}

Texture alphas(uint32_t width, uint32_t height, const std::function<uint32_t(uint32_t, uint32_t)>& alpha) {
  return alpha_texture(width, height, 1, Format::rgba8_unorm,
                       [&](uint32_t x, uint32_t y, uint32_t) { return alpha(x, y); });
}
// A cut quad before an opaque one, still or moving.
Case cut(const Look& look, uint32_t constant, bool stripes) {
  return in_middle([&](Builder& b) {
    b.add_texture(alphas(8, 2, [&](uint32_t x, uint32_t) { return stripes ? x % 2 * 255 : constant; }));
    b.add(cover(kFlat, 0.75), {}, {{0, kFlat}});
    b.add(cover(kFlat, 0.5), look, {{0, kFlat}});
    Look moving = look;
    moving.moving = true;
    b.add(flat({{0, 0, 0.25}, {0, 20, 0.25}, {20, 0, 0.25}}), moving, {{0, kFlat}});
  });
}

std::vector<HardCase> tile_cases() {
  return {
      {"nothing", "no tile and no caster: both images keep every bit", [] { return Builder(33, 31).finish(); }},
      {"empty_tile", "a tile without casters is clear to its last row and column",
       [] { return in_middle([](Builder&) {}); }},
      {"covers_everything", "a caster over its tile and half a tile beyond: all of it and not a texel more",
       [] { return in_middle([](Builder& b) {
              b.add(cover({}, 2), {}, {{0, {}}});
            }); }},
      {"neighbours", "casters of four tiles, each far larger than its own: none reaches another",
       [] {
         Builder b(64, 64);
         std::vector<Placed> placed;
         for (uint32_t i = 0; i < 4; ++i) {
           placed.push_back({b.add_both({i % 2 * 32, i / 2 * 32, 32}), {}});
           const double d = 1 + i;
           b.add(triangle(vec3(-9 * d, -7 * d, -d), vec3(11 * d, -2 * d, -2 * d), vec3(0, 13 * d, -d)), {}, {{i, {}}});
         }
         return b.finish();
       }},
      {"instances", "one command, a caster a tile: each is its own",
       [] {
         Builder b(64, 64);
         std::vector<Placed> placed;
         for (uint32_t i = 0; i < 4; ++i)
           placed.push_back({b.add_both({i % 2 * 32, i / 2 * 32, 32}), {.half_width = 1.0 + i}});
         const Mesh m = triangle(vec3(-1, -1, -2), vec3(1, -1, -3), vec3(0, 1, -2));
         b.add(m, {}, placed);
         b.add(m, {.moving = true}, placed);
         return b.finish();
       }},
      {"moving_over_still", "a moving caster before a still one, and behind another",
       [] {
         return in_middle([](Builder& b) {
           b.add(flat({{2, 2, 0.5}, {2, 30, 0.5}, {18, 2, 0.5}, {30, 30, 0.25}, {30, 2, 0.25}, {14, 30, 0.25}}), {},
                 {{0, kFlat}});
           b.add(flat({{0, 16, 0.375}, {32, 8, 0.375}, {32, 24, 0.375}}), {.moving = true}, {{0, kFlat}});
         });
       }},
      {"cached_tile", "only what moves is drawn: still depths of an earlier frame are under it, and stay",
       [] {
         Builder b(96, 96);
         const uint32_t tile = b.add_tile(kMiddle);
         b.add(flat({{0, 0, 0.625}, {0, 32, 0.5}, {32, 0, 0.75}}), {.moving = true}, {{tile, kFlat}});
         return b.finish();
       }},
      {"still_alone", "still depths are drawn anew, and depth keeps its own",
       [] {
         Builder b(96, 96);
         const uint32_t tile = b.add_still_tile(kMiddle);
         b.add(flat({{0, 0, 0.625}, {0, 32, 0.5}, {32, 0, 0.75}}), {}, {{tile, kFlat}});
         return b.finish();
       }},
      {"lists_differ", "tiles of two lists and one of both, with casters of each",
       [] {
         Builder b(96, 32);
         b.add_both({0, 0, 32});
         b.add_still_tile({32, 0, 32});
         b.add_tile({64, 0, 32});
         const Mesh m = flat({{-8, 3, 0.5}, {3, 40, 0.5}, {40, -3, 0.25}}),
                    n = flat({{0, 0, 0.4}, {9, 40, 0.4}, {40, 9, 0.4}});
         b.add(m, {}, {{0, kFlat}, {1, kFlat}});
         b.add(n, {.moving = true}, {{0, kFlat}, {1, kFlat}});
         return b.finish();
       }},
      {"one_texel", "tiles of a texel, beside and within large ones",
       [] {
         Builder b(16, 16);
         b.add_both({0, 0, 1}), b.add_both({1, 0, 1}), b.add_both({15, 15, 1}), b.add_both({8, 0, 8});
         for (uint32_t i = 0; i < 3; ++i) b.add(cover({}, 1.0 + i), {}, {{i, {}}});
         b.add(triangle(vec3(-9, -9, -1), vec3(9, -9, -1), vec3(0, 9, -1)), {}, {{3, {}}});
         return b.finish();
       }},
      {"thousand_tiles", "1024 tiles of 8 texels, two casters each",
       [] {
         Builder b(256, 256);
         std::vector<Placed> placed;
         for (uint32_t i = 0; i < 1024; ++i)
           placed.push_back({b.add_both({i % 32 * 8, i / 32 * 8, 8}), {.half_width = 0.5 + i * 0x1p-9}});
         const Mesh m = triangle(vec3(-1, -1, -2), vec3(1, -1, -3), vec3(0, 1, -2));
         b.add(m, {}, placed);
         b.add(m, {.moving = true}, placed);
         return b.finish();
       }},
      {"overlapping_tiles", "a tile within another: each caster keeps to its own",
       [] {
         Builder b(64, 64);
         b.add_both({0, 0, 64}), b.add_both({16, 16, 16});
         b.add(flat({{-8, -8, 0.5}, {-8, 40, 0.5}, {40, -8, 0.5}}), {}, {{0, kFlat}, {1, kFlat}});
         return b.finish();
       }},
      {"odd_atlas", "sides that are no powers of two: the tile's place in the atlas is rounded",
       [] {
         Builder b(97, 61);
         b.add_both({3, 5, 32}), b.add_both({65, 29, 32});
         for (uint32_t i = 0; i < 2; ++i) b.add(flat({{-3, -2, 0.5}, {5, 37, 0.25}, {40, 3, 0.125}}), {}, {{i, kFlat}});
         return b.finish();
       }},
      {"few_move", "typical in the next frame: in an eighth of the tiles something moved, and no light did",
       [] {
         return few_move({1024, 1024});
       }},
      {"large_atlas", "4096 x 4096",
       [] {
         return typical({4096, 4096});
       },
       true},
  };
}

std::vector<HardCase> draw_cases() {
  return {
      {"edges_on_centres", "edges along rows and columns of texel centres: top and left are in",
       [] {
         return in_middle([](Builder& b) {
           b.add(flat({{4.5, 4.5, 0.5},
                       {4.5, 20.5, 0.5},
                       {20.5, 4.5, 0.5},
                       {20.5, 4.5, 0.5},
                       {4.5, 20.5, 0.5},
                       {20.5, 20.5, 0.5}}),
                 {}, {{0, kFlat}});
         });
       }},
      {"depth_order", "a stack from far to near and from near to far",
       [] {
         return in_middle([](Builder& b) {
           for (int i = 0; i < 8; ++i)
             for (const bool left : {true, false}) {
               const float d = static_cast<float>(left ? 8 - i : i + 1) / 16, x = left ? 0 : 16;
               b.add(flat({{x, 2, d}, {x, 30, d}, {x + 14, 16, d}}), {}, {{0, kFlat}});
             }
         });
       }},
      {"through_light", "a floor from behind the light to far ahead: cut at the near plane and at the sides",
       [] {
         return in_middle([](Builder& b) {
           b.add(triangle(vec3(-40, -0.5f, 9), vec3(40, -0.5f, 9), vec3(0, -0.5f, -90)), {}, {{0, {}}});
           b.add(triangle(vec3(-1, 1, -0.125f), vec3(1, 1, 0.5f), vec3(0, 1, -3)), {.moving = true}, {{0, {}}});
         });
       }},
      {"behind_light", "nothing behind a spot is drawn",
       [] {
         return in_middle([](Builder& b) {
           b.add(triangle(vec3(-1, -1, 2), vec3(1, -1, 2), vec3(0, 1, 3)), {}, {{0, {}}});
         });
       }},
      {"sun_planes", "before a sun's near plane, through it, through the far plane and beyond it",
       [] {
         return in_middle([](Builder& b) {
           b.add(flat({{0, 0, -0.5},
                       {0, 16, -0.25},
                       {16, 0, -0.75},
                       {0, 16, -0.5},
                       {0, 32, 0.5},
                       {16, 16, 0.25},
                       {16, 0, 0.5},
                       {16, 16, 1.5},
                       {32, 0, 0.75},
                       {16, 16, 1.25},
                       {16, 32, 1.5},
                       {32, 16, 2}}),
                 {}, {{0, kFlat}});
         });
       }},
      {"sides_cut_slivers", "corners that leave the tile by little: what is left falls into thin pieces",
       [] {
         return in_middle([](Builder& b) {
           for (int i = 0; i < 14; ++i) {
             const float out = std::ldexp(8.0f, -i), y = 2.0f * static_cast<float>(i);
             b.add(flat({{1, y, 0.875}, {32 + out, y + 2, 0.125f}, {1.25f, y + 1.5f, 0.25f}}), {}, {{0, kFlat}});
             b.add(flat({{-out, y, 0.5}, {31, y + 0.7f, 0.1f}, {29.7f, y + 2.3f, 0.9f}}), {.moving = true},
                   {{0, kFlat}});
           }
         });
       }},
      {"turned_by_a_cut", "a sliver whose cut corner is snapped past its edge: the piece covers a texel beyond it",
       [] {
         return in_middle([](Builder& b) {
           b.add(cover(kFlat, 0.9), {}, {{0, kFlat}});
           b.add(flat({{35.768733f, 12.068658f, 0.5f}, {31.959877f, 14.894113f, 0.5f}, {26.917171f, 18.691037f, 0.5f}}),
                 {}, {{0, kFlat}});
         });
       }},
      {"far_coordinates", "corners millions of near distances away: rounding moves the cuts by texels",
       [] {
         return in_middle([](Builder& b) {
           const LightView near = {.first = 0.015625};
           const auto add = [&](const vec3& p, const vec3& q, const vec3& r) {
             b.add(triangle(p, q, r), {}, {{0, near}});
           };
           add(vec3(-3e5f, -1.7f, 2e5f), vec3(5e5f, -1.3f, 3e5f), vec3(1e3f, -1.1f, -7e5f));
           add(vec3(-3e7f, 1.7f, 2e6f), vec3(-1, 1.3f, -3), vec3(1e3f, 3e6f, -7e5f));
           for (int i = 1; i < 8; ++i) {  // floors that pass the light by less than its near distance
             const auto n = static_cast<float>(i);
             add(vec3(-3.1e5f * n, -0.0015f * n, 2e5f), vec3(5.3e5f, -0.0013f * n, 3e5f * n),
                 vec3(1e3f, -0.001f, -7e5f));
             add(vec3(0.0013f * n, -3.1e5f * n, 2e5f), vec3(0.0011f * n, 5.3e5f, 3e5f * n), vec3(0.001f, 1e3f, -7e5f));
           }
         });
       }},
      {"degenerate", "corners in a line, and in a point",
       [] {
         return in_middle([](Builder& b) {
           b.add(flat({{4, 4, 0.5}, {20, 20, 0.5}, {28, 28, 0.5}, {9.5, 9.5, 0.5}, {9.5, 9.5, 0.5}, {9.5, 9.5, 0.5}}),
                 {}, {{0, kFlat}});
         });
       }},
  };
}

std::vector<HardCase> masked_cases() {
  return {
      {"masked_all_cut", "every texel is a hole",
       [] { return cut(masked_look(1, 0.5f, texture_name(0, 0)), 0, false); }},
      {"masked_none_cut", "no texel is a hole",
       [] { return cut(masked_look(1, 0.5f, texture_name(0, 0)), 255, false); }},
      {"masked_stripes", "one column in two of the texture is a hole: u and v differ",
       [] { return cut(masked_look(1, 0.5f, texture_name(0, 0)), 0, true); }},
      {"masked_factor", "the material's own alpha counts",
       [] { return cut(masked_look(0.25f, 0.5f, texture_name(0, 0)), 255, false); }},
      {"cutoff_equal", "alpha equal to the cutoff is kept",
       [] { return cut(masked_look(0.625f, 0.625f), 255, false); }},
  };
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto& more : {tile_cases(), draw_cases(), masked_cases()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"tile.glsl", 1, "past the list's end its last tile is drawn to", "tile_past_end"},
      {"tile.glsl", 2, "tiles beyond the atlas are drawn", "tile_beyond_atlas"},
      {"quad.glsl", 3, "a tile's last row and column stay", "empty_tile"},
      {"caster.glsl", 4, "every instance is the command's first", "instances"},
      {"caster.glsl", 5, "the tile's middle taken for its corner", "edges_on_centres"},
      {"caster.glsl", 6, "the tile's last column is not its own", "covers_everything"},
      {"caster.glsl", 7, "y by the row of x", "edges_on_centres"},
      {"caster.glsl", 8, "what is no number is drawn", "position_nan"},
      {"caster.glsl", 9, "depths of 0.9999", "edges_on_centres"},
      {"caster.glsl", 10, "cut at the tile's middle", "covers_everything"},
      {"caster_masked.glsl", 11, "u and v swapped", "masked_stripes"},
      {"bounds.glsl", 13, "what rounding left beside the tile stays", "far_coordinates"},
      {"copy.frag", 12, "still depths are not copied", "moving_over_still"},
      {"cut.glsl", 9501, "alpha at most the cutoff is cut", "cutoff_equal"},
      {"cut.glsl", 9502, "nothing is cut", "masked_all_cut"},
      {"cut.glsl", 9503, "the material's alpha is forgotten", "masked_factor"},
  };
}

}  // namespace assay::shadow_atlas
