// Shadows of a view: tiles in the atlas, what casts into them, and what of it is drawn again.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "harness/oracle.h"
#include "harness/scene/scene.h"
#include "harness/scene/shadow_packing.h"

namespace assay::tests {
namespace {

using namespace scene;

bool overlap(const ShadowTile& a, const ShadowTile& b) {
  return a.x < b.x + b.side && b.x < a.x + a.side && a.y < b.y + b.side && b.y < a.y + a.side;
}

void expect_sound(const Packing& p) {
  for (const auto& [key, t] : p.tiles) {
    EXPECT_EQ(t.x % t.side + t.y % t.side, 0u);
    EXPECT_LE(t.x + t.side, p.width);
    EXPECT_LE(t.y + t.side, p.height);
    for (const auto& [other, u] : p.tiles) EXPECT_TRUE(other == key || !overlap(t, u)) << key << " and " << other;
  }
}

std::vector<TileWish> wishes_of(uint64_t seed, uint32_t lights) {
  Pcg32 rng(seed);
  std::vector<TileWish> wishes;
  for (uint32_t i = 0; i < lights; ++i)
    wishes.push_back({i, rng.below(4) ? 1u : 6u, 64u << rng.below(4), rng.range(0, 100)});
  return wishes;
}

TEST(Shadows, TilesNeverOverlapAndKeepTheirPlaces) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<TileWish> wishes = wishes_of(seed, 1 + static_cast<uint32_t>(seed));
    const Packing first = pack_tiles(wishes, {});
    expect_sound(first);
    size_t tiles = 0;
    for (const TileWish& w : wishes) tiles += w.views;
    EXPECT_EQ(first.tiles.size(), tiles);
    EXPECT_EQ(first.halved + first.dropped, 0u);
    std::ranges::reverse(wishes);
    const Packing again = pack_tiles(wishes, first);
    EXPECT_TRUE(std::ranges::equal(first.tiles, again.tiles, [](const auto& a, const auto& b) {
      return a.first == b.first && a.second.x == b.second.x && a.second.y == b.second.y;
    }));
    // One light less: the others stay where they are.
    const TileWish gone = wishes.back();
    wishes.pop_back();
    const Packing fewer = pack_tiles(wishes, first);
    expect_sound(fewer);
    for (const auto& [key, t] : fewer.tiles) {
      EXPECT_NE(key / 8, gone.light);
      EXPECT_TRUE(t.x == first.tiles.at(key).x && t.y == first.tiles.at(key).y);
    }
  }
}

TEST(Shadows, AFullAtlasStepsDownAndThenDrops) {
  std::vector<TileWish> wishes;
  for (uint32_t i = 0; i < 20; ++i) wishes.push_back({i, 1, 256, 100.0 - i});
  const Packing halved = pack_tiles(wishes, {}, 1024);  // 16 of them would fill it
  expect_sound(halved);
  EXPECT_EQ(halved.tiles.size(), 20u);
  EXPECT_GT(halved.halved, 0u);
  EXPECT_EQ(halved.tiles.at(tile_key(0, 0)).side, 256u);
  EXPECT_LT(halved.tiles.at(tile_key(19, 0)).side, 256u);
  uint64_t area = 0;
  for (const auto& [key, t] : halved.tiles) area += uint64_t{t.side} * t.side;
  EXPECT_GT(area + 3 * kLeastTile * kLeastTile, 1024u * 1024u) << "room is left to double a tile";
  for (uint32_t i = 20; i < 300; ++i) wishes.push_back({i, 1, 256, 100.0 - i});
  const Packing dropped = pack_tiles(wishes, {}, 1024);
  expect_sound(dropped);
  EXPECT_EQ(dropped.dropped, 300u - 256u);
  EXPECT_TRUE(dropped.tiles.contains(tile_key(255, 0)) && !dropped.tiles.contains(tile_key(256, 0)));
  EXPECT_TRUE(pack_tiles({}, dropped).tiles.empty());
}

Gathered gathered(const Scene& s, const ShadowCache& before = {}, uint32_t frame = 0) {
  const ShadowRequest request = {.before = before, .frame = frame, .sliced = false};
  return gather(s, default_camera(s), {640, 360}, &request);
}

// One that cannot have what it asks for leaves the others theirs.
TEST(Shadows, AnAtlasThatOneLightWouldFillHasRoomForTheRest) {
  std::vector<TileWish> wishes = {{0, 4, 512, 1e300}};
  for (uint32_t i = 1; i < 10; ++i) wishes.push_back({i, 1, 128, 10.0 - i});
  const Packing p = pack_tiles(wishes, {}, 1024);
  expect_sound(p);
  EXPECT_EQ(p.tiles.at(tile_key(0, 0)).side, 256u);
  for (uint32_t i = 1; i < 10; ++i) EXPECT_EQ(p.tiles.at(tile_key(i, 0)).side, 128u);
  EXPECT_EQ(p.halved, 1u);
}

TEST(Shadows, WithoutCastersNothingOfItIsThere) {
  Scene s = small();
  for (Light& l : s.lights) l.casts_shadows = false;
  const Gathered g = gathered(s);
  EXPECT_EQ(g.shadow_counts.width + g.shadow_counts.views, 0u);
  EXPECT_TRUE(g.shadow_views.empty() && g.shadow_casters.empty() && g.shadow_draws.empty());
  const Gathered plain = gather(s, default_camera(s), {640, 360});
  EXPECT_EQ(g.positions.size(), plain.positions.size()) << "no mesh is there for its shadow alone";
}

TEST(Shadows, CastersLieInTheRangesOfTheirTiles) {
  const Scene s = default_scene();
  const Gathered g = gathered(s);
  const ShadowCounts n = g.shadow_counts;
  EXPECT_GT(n.views, 20u);
  EXPECT_EQ(n.tiles, n.views);
  EXPECT_EQ(n.still_tiles, n.views);
  EXPECT_EQ(n.draw_first[kShadowDraws], g.shadow_draws.size());
  uint32_t next = 0;
  for (uint32_t range = 0; range < kShadowDraws; ++range)
    for (uint32_t i = n.draw_first[range]; i < n.draw_first[range + 1]; ++i) {
      const DrawCommand& d = g.shadow_draws[i];
      EXPECT_EQ(d.first_instance, next);
      next += d.instance_count;
      EXPECT_LE(size_t{d.first_index} + d.index_count, g.indices.size());
      const bool masked = range == kShadowStillMasked || range == kShadowMovingMasked;
      for (uint32_t c = d.first_instance; c < next; ++c) {
        EXPECT_LT(g.shadow_casters[c].tile, range < kShadowMoving ? n.still_tiles : n.tiles);
        EXPECT_EQ(s.materials[g.shadow_casters[c].material].alpha == AlphaMode::masked, masked);
      }
    }
  EXPECT_EQ(next, g.shadow_casters.size());
  EXPECT_LT(n.draw_first[kShadowMoving], n.draw_first[kShadowDraws]) << "something moves";
}

TEST(Shadows, SpotsThatATileCannotHoldAreNamed) {
  const auto are_named = [](float outer_rad) {
    Scene s = small();
    for (Light& l : s.lights)
      if (l.casts_shadows && l.kind == LightKind::spot) l.outer_rad = outer_rad;
    return std::ranges::any_of(gathered(s).notes,
                               [](const std::string& n) { return n.find("wider than 80") != n.npos; });
  };
  EXPECT_FALSE(are_named(1.39f));
  EXPECT_TRUE(are_named(1.5f));
}

// What the viewer does not see casts shadows all the same.
TEST(Shadows, CastersOutsideTheViewAreThere) {
  Scene s = small();
  const Gathered before = gathered(s);
  const uint32_t instance = before.surface_instance.at(0);
  s.cameras[0] = look_at({0, 2, 0}, {0, 2, 100}, 0.3);
  const Gathered away = gathered(s);
  EXPECT_EQ(std::ranges::count(away.surface_instance, instance), 0);
  EXPECT_GT(away.shadow_casters.size(), away.surfaces.size());
}

TEST(Shadows, AStillSceneDrawsNoTileAgain) {
  for (const Scene& s : {small(), default_scene()}) {
    const Gathered first = gathered(s), second = gathered(s, first.shadow_cache, 1);
    EXPECT_GT(first.shadow_statistics.still_drawn, 0u) << s.name;
    EXPECT_EQ(second.shadow_statistics.still_drawn + second.shadow_statistics.composed, 0u) << s.name;
    EXPECT_TRUE(second.shadow_casters.empty() && second.shadow_draws.empty()) << s.name;
    EXPECT_EQ(second.shadow_views.size(), first.shadow_views.size());
  }
}

// The tiles whose list of moving things has the instance.
std::set<uint32_t> seeing(const ShadowCache& cache, uint32_t instance) {
  std::set<uint32_t> keys;
  for (const auto& [key, held] : cache.tiles)
    for (size_t i = 0; i < held.moving.size(); i += 18)
      if (held.moving[i] == instance) keys.insert(key);
  return keys;
}

TEST(Shadows, AThingThatMovesIsDrawnInTheTilesThatSeeIt) {
  Scene s = default_scene();
  const Gathered first = gathered(s);
  uint32_t instance = 0;
  while (seeing(first.shadow_cache, instance).empty()) ++instance;
  s.instances[instance].to_world[3].x += 0.05;
  const Gathered second = gathered(s, first.shadow_cache, 1);
  std::set<uint32_t> keys = seeing(first.shadow_cache, instance);
  keys.merge(seeing(second.shadow_cache, instance));
  EXPECT_EQ(second.shadow_statistics.still_drawn, 0u);
  EXPECT_EQ(second.shadow_statistics.composed, keys.size());
  EXPECT_LT(keys.size(), second.shadow_views.size());
  std::set<std::pair<uint32_t, uint32_t>> places, expected;
  for (const ShadowTile& t : second.shadow_tiles) places.insert({t.x, t.y});
  for (const uint32_t key : keys)
    expected.insert({first.shadow_cache.tiles.at(key).tile.x, first.shadow_cache.tiles.at(key).tile.y});
  EXPECT_EQ(places, expected);
}

// Small tiles follow what moves by turns, at most three frames late.
TEST(Shadows, SmallTilesFollowInTurn) {
  const Scene s = default_scene();
  Scene moved = s;
  ShadowCache sliced;
  std::vector<ShadowCache> prompt;
  std::set<std::set<uint32_t>> put_off;
  for (uint32_t frame = 0; frame < 9; ++frame) {
    move_to_frame(frame, s, moved);
    const ShadowRequest request = {.before = sliced, .frame = frame};
    const Gathered g = gather(moved, default_camera(s), {640, 360}, &request);
    sliced = g.shadow_cache;
    prompt.push_back(gathered(moved, prompt.empty() ? ShadowCache{} : prompt.back(), frame).shadow_cache);
    std::set<uint32_t> late;
    for (const auto& [key, held] : sliced.tiles) {
      uint32_t age = 0;
      while (age < 4 && age <= frame && prompt[frame - age].tiles.at(key).moving != held.moving) ++age;
      ASSERT_LT(age, std::min(frame + 1, 4u)) << "tile " << key << " in frame " << frame;
      if (age) late.insert(key);
      EXPECT_TRUE(held.tile.side <= 128 || age == 0) << "tile " << key << " is large";
    }
    EXPECT_EQ(late.size(), g.shadow_statistics.put_off) << frame;
    if (!late.empty()) put_off.insert(late);
  }
  EXPECT_GE(put_off.size(), 4u) << "not always the same";
}

TEST(Shadows, ALightThatMovesIsDrawnAnewAlone) {
  Scene s = default_scene();
  const Gathered first = gathered(s);
  uint32_t light = 0;
  while (!s.lights[light].casts_shadows || !first.shadow_cache.tiles.contains(tile_key(light, 0))) ++light;
  s.lights[light].position.y -= 0.01;
  const Gathered second = gathered(s, first.shadow_cache, 1);
  EXPECT_EQ(second.shadow_statistics.still_drawn, s.lights[light].kind == LightKind::point ? kCubeFaces : 1u);
  EXPECT_EQ(second.shadow_statistics.composed, second.shadow_statistics.still_drawn);
}

}  // namespace
}  // namespace assay::tests
