// Named hard cases of the lists: tiles that have decals, and primaries.
#include "harness/vrcs_lists.h"
#include "harness/vrcs_screens.h"
#include "kernels/decal_atlas_sampling/inputs.h"

namespace assay::decal_atlas_sampling {

using glm::dvec3;

namespace {

constexpr Extent kNine = {48, 48};  // tiles

// A wall under two decals, each pixel of another material.
View wall(Extent e) {
  View v(e);
  v.atlas.look = AtlasPlan::Look::loud;
  v.set_plane(0, 0, e.width, e.height, {0, 0, -8}, {0, 0, 1});
  Pcg32 rng(pixel_count(e));
  for (uint32_t& texel : v.base_roughness) texel = rng.next();
  for (uint32_t& texel : v.normal)
    texel = packed_normal(glm::normalize(dvec3(rng.range(-1, 1), rng.range(-1, 1), 1.5)));
  for (uint32_t i = 0; i < 2; ++i)
    v.decals.push_back(decal({0, 0, -8}, {0, 0, 1}, 0.3, {9.0 - 5 * i, 9.0 - 5 * i, 1}, v.atlas, 5 + i));
  return v;
}

std::function<Case()> listed(const std::vector<uint32_t>& tiles, const std::function<void(Case&)>& last = {}) {
  return [=] {
    View v = wall(kNine);
    v.tiles = tiles;
    v.rates.assign(pixel_count(vrcs::cells_of(kNine)), kRate2x2);
    Case c = v.to_case();
    if (last) last(c);
    return c;
  };
}
// All tiles, as on a screen.
std::function<Case()> seen(std::function<vrcs::Pictured()> screen, uint32_t frame = 0) {
  return [=] {
    vrcs::Pictured s = screen();
    View v = wall(s.extent);
    v.visibility = std::move(s.visibility), v.rates = std::move(s.rates);
    v.params.frame = frame;
    return v.to_case();
  };
}
std::function<Case()> of_one(Extent e, uint8_t rate, uint32_t frame) {
  return seen([=] { return vrcs::of_one(e, rate); }, frame);
}
std::function<Case()> of_primaries(uint32_t more_than_192) {
  return seen([=] { return vrcs::of_primaries({48, 32}, more_than_192); });
}
uvec2 own(uint32_t x, uint32_t y) { return {y * 16384 + x, 1}; }

std::vector<HardCase> tile_list_cases() {
  return {
      {"one_tile_of_nine", "its neighbours on all sides stay as they are", listed({4})},
      {"no_tiles", "decals everywhere, and no tile is listed", listed({})},
      {"tiles_in_disorder", "the last first", listed({8, 0, 5, 1})},
      {"groups_left_over", "more groups than tiles: others lie behind the list",
       listed({4, 2},
              [](Case& c) {
                c.set_input("decal_tile_args", std::vector{DispatchArgs{3, 2, 1}});
              })},
      {"count_beyond_room", "a count of 2^32 - 1: the room of the list is the limit",
       listed({4, 2},
              [](Case& c) {
                c.set_input("decal_tile_args", std::vector{DispatchArgs{7, 2, 1}});
                c.set_input("decal_tile_count", std::vector{0xffffffffu});
              })},
      {"tile_number_wraps", "tiles that there are not, of which one's top row wraps to that of tile 4",
       listed({0x30000004u, 8, 0xffffffffu})},
  };
}

std::vector<HardCase> primary_cases() {
  return {
      {"all_2x2", "no entries: the pixels are worked out", of_one({64, 48}, kRate2x2, 0)},
      {"all_2x2_odd_frame", "and the lower right ones", of_one({64, 48}, kRate2x2, 5)},
      {"cut_cells", "copies end at the screen's sides", of_one({37, 35}, kRate2x2, 1)},
      {"one_across", "pairs side by side", of_one({33, 31}, kRate2x1, 1)},
      {"one_below", "pairs one below the other", of_one({33, 31}, kRate1x2, 0)},
      {"diagonals", "a checkerboard: two primaries a cell, each copied across",
       seen(
           [] {
             return vrcs::drawn({64, 48}, kRate2x2, [](uint32_t x, uint32_t y) { return uvec2((x + y) % 2, 1); });
           },
           1)},
      {"primaries_224", "the longest list", of_primaries(32)},
      {"primaries_225", "one more, and every pixel is its own", of_primaries(33)},
      {"holes_where_all_are_shaded", "over 224 primaries, and pixels without a surface between them",
       [] {
         View v = wall({48, 33});
         v.visibility = vrcs::drawn(v.extent, kRate2x2, own).visibility;
         for (size_t i = 0; i < v.depth.size(); i += 11) v.depth[i] = 0;
         return v.to_case();
       }},
      {"holes_in_cells", "cells of 2x2 pixels of which one to four have no surface",
       [] {
         View v = wall({48, 33});
         v.rates.assign(pixel_count(vrcs::cells_of(v.extent)), kRate2x2);
         v.params.frame = 2;
         for (size_t i = 0; i < v.depth.size(); ++i)
           if (i * 2654435769u >> 30 & 1) v.depth[i] = 0;
         return v.to_case();
       }},
      {"all_sky", "every tile is listed, and none has a pixel",
       [] {
         View v = wall(kNine);
         v.depth.assign(v.depth.size(), 0);
         v.tiles = {0, 1, 2, 3, 4, 5, 6, 7, 8};
         return v.to_case();
       }},
  };
}

// A decal over all of the screen, and words of tiles that are nobody's: materials are not yet copied, and become so.
std::function<Case()> words(const std::function<uint32_t(uint32_t)>& word_of) {
  return [=] {
    View v = wall({40, 37});
    v.decals = {decal({0, 0, -8}, {0, 0, 1}, 0.3, {20, 20, 1}, v.atlas, 5)};
    v.params.frame = 1;
    return vrcs::changed(v.to_case(), "vrcs_tiles", [&](std::vector<uint32_t>& tiles) {
      for (uint32_t i = 0; i < tiles.size(); ++i) tiles[i] = word_of(i);
    });
  };
}

std::vector<HardCase> hostile_cases() {
  return {
      {"words_of_ones", "every flag, every count: all pixels are their own", words([](uint32_t) { return ~0u; })},
      {"counts_over", "no primary, all of a tile, and more than a tile has",
       words([](uint32_t i) { return i % 3 == 0 ? kVrcsTile2x2 : 200 + i % 3 * 100; })},
      {"worked_out_beyond_the_screen", "tiles cut by a side that say they are all 2x2",
       words([](uint32_t i) { return kVrcsTile2x2 | (10 + 50 * (i % 4)); })},
  };
}

}  // namespace

std::vector<HardCase> hard_cases_of_lists() {
  std::vector<HardCase> all = tile_list_cases();
  for (HardCase& more : hostile_cases()) all.push_back(std::move(more));
  for (HardCase& more : primary_cases()) all.push_back(std::move(more));
  return all;
}

}  // namespace assay::decal_atlas_sampling
