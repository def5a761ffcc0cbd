// Shadows of a view (Sousa, Geffroy 2016): the tiles of its lights, and of them those that must be drawn: a tile's
// still depths where the light or what is still in it changed, and all of it where that was drawn or what moves in it
// did.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "harness/scene/gather.h"
#include "harness/scene/shadow_views.h"

namespace assay::scene {
namespace {

bool moves(const Instance& i) { return i.motion.reach != glm::dvec3(0) || i.motion.turn_rad != 0; }

// An instance's part that may cast shadows.
struct Thing {
  uint32_t range;  // kShadowStill...
  uint32_t mesh, part, instance;
  Bounds box;  // the mesh's
};

std::vector<Thing> things_of(const Scene& scene) {
  std::vector<std::vector<Bounds>> boxes(scene.meshes.size());
  for (size_t m = 0; m < boxes.size(); ++m)
    for (const Part& part : scene.meshes[m].parts) boxes[m].push_back(bounds_of(scene.meshes[m], part));
  std::vector<Thing> things;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (uint32_t p = 0; p < mesh.parts.size(); ++p) {
      const AlphaMode alpha = scene.materials[mesh.parts[p].material].alpha;
      const Bounds& box = boxes[scene.instances[i].mesh][p];
      if (alpha == AlphaMode::blended || box.empty()) continue;
      const bool masked = alpha == AlphaMode::masked;
      const uint32_t range = moves(scene.instances[i]) ? masked ? kShadowMovingMasked : kShadowMoving
                             : masked                  ? kShadowStillMasked
                                                       : kShadowStill;
      things.push_back({range, scene.instances[i].mesh, p, i, box});
    }
  }
  return things;
}

// Beyond one plane of the view with all of its box; a little more is kept, as gather.cpp does.
bool outside(const LightView& v, const glm::dmat4& to_world, const Bounds& box) {
  const std::array rows = {v.x * to_world, v.y * to_world, v.w * to_world};
  double out[5] = {1e300, 1e300, 1e300, 1e300, 1e300}, scale = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 p = {i & 1 ? box.highest.x : box.lowest.x, i & 2 ? box.highest.y : box.lowest.y,
                          i & 4 ? box.highest.z : box.lowest.z, 1};
    const double x = dot(rows[0], p), y = dot(rows[1], p), w = dot(rows[2], p);
    const double beyond[5] = {x - w, -x - w, y - w, -y - w, w - v.farthest};
    for (int k = 0; k < 5; ++k) out[k] = std::min(out[k], beyond[k]);
    for (const glm::dvec4& row : rows) scale = std::max(scale, dot(abs(row), abs(p)));
  }
  return *std::max_element(out, out + 5) > 1e-5 * scale;
}

// Small tiles are of lights that are small on the screen or far: they follow what moves in every second or fourth
// frame, each light and face in its turn.
uint32_t period_of(const ShadowTile& t) { return t.side > 2 * kLeastTile ? 1 : t.side > kLeastTile ? 2 : 4; }
uint32_t turn_of(TileKey key) { return key / tile_key(1, 0) + key % tile_key(1, 0); }

void append(std::vector<double>& to, const glm::dvec4& v) { to.insert(to.end(), {v.x, v.y, v.z, v.w}); }

struct Pair {  // a thing in a tile that is drawn
  uint32_t range, mesh, part, instance, tile;
  const LightView* view;
};

struct Gathering {
  const Scene& scene;
  const ShadowRequest& request;
  Gathered& to;
  std::vector<Thing> things;
  std::vector<Pair> pairs = {};

  // Draws what changed of a tile since it was held, and notes what it holds now.
  void add_tile(TileKey key, const ShadowTile& tile, const LightView& view, bool is_kept) {
    ShadowCache::Held now = {tile, {}, {}};
    for (const glm::dvec4& row : {view.x, view.y, view.z, view.w}) append(now.still, row);
    std::vector<const Thing*> seen;
    for (const Thing& t : things) {
      const glm::dmat4& to_world = scene.instances[t.instance].to_world;
      if (outside(view, to_world, t.box)) continue;
      seen.push_back(&t);
      std::vector<double>& state = t.range < kShadowMoving ? now.still : now.moving;
      state.insert(state.end(), {double(t.instance), double(t.part)});
      for (int column = 0; column < 4; ++column) append(state, to_world[column]);
    }
    const auto held = request.before.tiles.find(key);
    const bool fits = is_kept && held != request.before.tiles.end() && held->second.tile.x == tile.x &&
                      held->second.tile.y == tile.y && held->second.tile.side == tile.side;
    const bool draws_still = !fits || held->second.still != now.still;
    bool composes = draws_still || held->second.moving != now.moving;
    if (composes && !draws_still && request.sliced && (request.frame + turn_of(key)) % period_of(tile) != 0) {
      composes = false;
      now.moving = held->second.moving;
      ++to.shadow_statistics.put_off;
    }
    draw(tile, view, seen, draws_still, composes);
    to.shadow_cache.tiles[key] = std::move(now);
  }

  void draw(const ShadowTile& tile, const LightView& view, const std::vector<const Thing*>& seen, bool still,
            bool composes) {
    const auto still_tile = static_cast<uint32_t>(to.shadow_still_tiles.size()),
               composed_tile = static_cast<uint32_t>(to.shadow_tiles.size());
    if (still) to.shadow_still_tiles.push_back(tile);
    if (composes) to.shadow_tiles.push_back(tile);
    for (const Thing* t : seen) {
      const bool is_still = t->range < kShadowMoving;
      if (is_still ? still : composes)
        pairs.push_back({t->range, t->mesh, t->part, t->instance, is_still ? still_tile : composed_tile, &view});
    }
  }

  // A draw a part, of all its instances in all tiles.
  void append_draws(Merger& merger) {
    std::ranges::stable_sort(pairs, {}, [](const Pair& p) { return std::tuple(p.range, p.mesh, p.part); });
    uint32_t range = 0;
    for (size_t first = 0, last = 0; first < pairs.size(); first = last) {
      const Pair& p = pairs[first];
      const Part& part = scene.meshes[p.mesh].parts[p.part];
      const auto caster = static_cast<uint32_t>(to.shadow_casters.size());
      for (; last < pairs.size() &&
             std::tie(pairs[last].range, pairs[last].mesh, pairs[last].part) == std::tie(p.range, p.mesh, p.part);
           ++last) {
        const Pair& q = pairs[last];
        const glm::dmat4& to_world = scene.instances[q.instance].to_world;
        to.shadow_casters.push_back({vec4(q.view->x * to_world), vec4(q.view->y * to_world), vec4(q.view->z * to_world),
                                     vec4(q.view->w * to_world), q.tile, part.material});
      }
      while (range < p.range) to.shadow_counts.draw_first[++range] = static_cast<uint32_t>(to.shadow_draws.size());
      to.shadow_draws.push_back({part.index_count, static_cast<uint32_t>(last - first),
                                 merger.first_index(p.mesh, p.part), merger.vertex_offset(p.mesh), caster});
    }
    while (range < kShadowDraws) to.shadow_counts.draw_first[++range] = static_cast<uint32_t>(to.shadow_draws.size());
  }
};

Packing packing_of(const ShadowCache& cache) {
  Packing p = {.width = cache.width, .height = cache.height};
  for (const auto& [key, held] : cache.tiles) p.tiles[key] = held.tile;
  return p;
}

// A light keeps the side of its tiles until what it asks for is twice as much, or a quarter.
void settle(TileWish& wish, const ShadowCache& before) {
  const auto held = before.tiles.find(tile_key(wish.light, 0));
  if (held == before.tiles.end()) return;
  const uint32_t side = held->second.tile.side;
  if (wish.side < side && wish.side * 2 >= side) wish.side = side;
}

ShadowView record_of(const LightView& v, const ShadowTile& tile, const glm::dvec3& eye) {
  const auto relative = [&](const glm::dvec4& row) {
    return vec4(glm::dvec4(glm::dvec3(row), dot(glm::dvec3(row), eye) + row.w));
  };
  return {relative(v.x), relative(v.y), relative(v.z), relative(v.w), tile, static_cast<float>(v.bias)};
}

void note(const Packing& p, Gathered& to) {
  if (p.halved)
    to.notes.push_back(
        fmt::format("the shadow atlas is full: {} lights have smaller tiles than they ask for", p.halved));
  if (p.dropped) to.notes.push_back(fmt::format("the shadow atlas is full: {} lights cast no shadows", p.dropped));
}

}  // namespace

void append_shadows(const Scene& scene, const Camera& camera, Extent extent, const ShadowRequest& request,
                    Merger& merger) {
  Gathered& to = merger.to;
  if (std::ranges::none_of(to.light_source, [&](uint32_t i) { return i != kNone && scene.lights[i].casts_shadows; }))
    return;
  const Bounds bounds = bounds_of(scene);
  std::vector<TileWish> wishes;
  for (const uint32_t light : to.light_source) {
    if (light == kNone) continue;
    if (auto wish = wish_of(scene.lights[light], light, camera, extent, bounds)) {
      settle(*wish, request.before);
      wishes.push_back(*wish);
    }
  }
  const auto is_too_wide = [&](const TileWish& wish) {
    const Light& light = scene.lights[wish.light];
    return light.kind == LightKind::spot && light.outer_rad > kWidestSpot_rad;
  };
  if (const auto wide = std::ranges::count_if(wishes, is_too_wide))
    to.notes.push_back(
        fmt::format("{} spots are wider than 80 degrees: what they shine on beyond has no shadow", wide));
  const Packing packing = pack_tiles(wishes, packing_of(request.before));
  note(packing, to);
  const bool is_kept = packing.width == request.before.width && packing.height == request.before.height;
  to.shadow_cache.width = packing.width, to.shadow_cache.height = packing.height;

  Gathering gathering = {scene, request, to, things_of(scene)};
  std::vector<std::vector<LightView>> views;  // outlive the pairs that point at them
  views.reserve(to.lights.size());
  for (size_t i = 0; i < to.lights.size(); ++i) {
    const uint32_t light = to.light_source[i];
    const auto tile = packing.tiles.find(tile_key(light, 0));
    if (light == kNone || tile == packing.tiles.end()) continue;
    views.push_back(views_of(scene.lights[light], camera, extent, bounds, tile->second.side));
    to.lights[i].first_view = static_cast<uint32_t>(to.shadow_views.size());
    to.lights[i].views = static_cast<uint32_t>(views.back().size());
    for (uint32_t v = 0; v < views.back().size(); ++v) {
      const ShadowTile& t = packing.tiles.at(tile_key(light, v));
      gathering.add_tile(tile_key(light, v), t, views.back()[v], is_kept);
      to.shadow_views.push_back(record_of(views.back()[v], t, camera.eye));
    }
    ++to.shadow_statistics.lights;
  }
  gathering.append_draws(merger);
  to.shadow_statistics.views = static_cast<uint32_t>(to.shadow_views.size());
  to.shadow_statistics.still_drawn = static_cast<uint32_t>(to.shadow_still_tiles.size());
  to.shadow_statistics.composed = static_cast<uint32_t>(to.shadow_tiles.size());
  ShadowCounts& counts = to.shadow_counts;
  counts.width = packing.width, counts.height = packing.height;
  counts.views = to.shadow_statistics.views;
  counts.still_tiles = to.shadow_statistics.still_drawn;
  counts.tiles = to.shadow_statistics.composed;
  counts.casters = static_cast<uint32_t>(to.shadow_casters.size());
}

}  // namespace assay::scene
