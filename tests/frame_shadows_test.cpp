// Shadows in the frame: nothing of them where none are asked for, tiles that are kept from frame to frame, and darkness
// where rays say that there is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "harness/frame/sequence.h"
#include "harness/oracle.h"
#include "harness/scene/builtin.h"
#include "tests/drawn.h"
#include "tests/raycaster.h"

namespace assay::tests {
namespace {

using frame::Options;
using frame::Result;
using glm::dvec3;

const std::string kLit = "deferred_lighting.radiance", kDepth = "visibility.depth", kAtlas = "shadow_atlas.depth",
                  kStill = "shadow_atlas.still";

frame::Explanation explained(const scene::Scene& s, const Options& o) {
  return frame::explain(device::info(*device()), s, scene::default_camera(s), o);
}

TEST(FrameShadows, NothingOfThemIsThereWithoutThem) {
  const scene::Scene s = scene::small();
  const auto on = explained(s, {}), off = explained(s, {.shadows = false});
  const auto runs = [](const frame::Explanation& e, const std::string& what) {
    return std::ranges::any_of(e.passes, [&](const frame::PassNote& p) {
      return p.runs && (p.kernel == what || p.variant.find(what) != std::string::npos);
    });
  };
  EXPECT_TRUE(runs(on, "shadow_atlas") && runs(on, "_shadowed"));
  EXPECT_FALSE(runs(off, "shadow_atlas") || runs(off, "_shadowed"));
  for (const frame::ResourceNote& r : off.resources)
    EXPECT_TRUE(r.bytes == 0 || r.name.find("shadow") == std::string::npos) << r.name;
  EXPECT_LT(frame::total_bytes(off), frame::total_bytes(on));
  scene::Scene without = s;
  for (scene::Light& l : without.lights) l.casts_shadows = false;
  EXPECT_EQ(frame::to_text(explained(without, {})), frame::to_text(off));
  const Options options = {.size = {160, 90}, .warm_up = false};
  Options none = options;
  none.shadows = false;
  EXPECT_EQ(draw(without, options).image.texels, draw(s, none).image.texels);
}

TEST(FrameShadows, TheirViewShowsTheAtlas) {
  const scene::Scene s = scene::small();
  const Options options = {.size = {320, 180}, .view = "shadows", .keep_shadows = true, .warm_up = false};
  const Result r = draw(s, options);
  const size_t wide = r.shadow_cache.width, high = r.shadow_cache.height;
  ASSERT_EQ(wide, 2 * high) << "the picture's width is filled";
  const auto atlas = words<float>(r.downloads.at(kAtlas));
  const auto image = words<uint32_t>(r.downloads.at("debug_view.image"));
  const uint32_t beyond = image[179 * 320];
  std::set<uint32_t> colours;
  for (size_t y = 0; y < 180; ++y)
    for (size_t x = 0; x < 320; ++x) {
      const uint32_t colour = image[y * 320 + x];
      if (y >= 160) {
        ASSERT_EQ(colour, beyond);
        continue;
      }
      colours.insert(colour);
      if (atlas[y * high / 160 * wide + x * wide / 320] > 0) {
        ASSERT_NE(colour, beyond) << x << " " << y;
      }
    }
  EXPECT_GT(colours.size(), 20u);
  Options none = options;
  none.shadows = false;
  EXPECT_THROW(draw(s, none), std::invalid_argument);
}

TEST(FrameShadows, AStillSequenceDrawsItsTilesOnce) {
  const scene::Scene s = scene::small();
  const Options options = {.size = {160, 90}, .keep_shadows = true, .warm_up = false};
  const auto drawn =
      frame::render_sequence(*device(), s, scene::default_camera(s), options, {.frames = 3, .still = true});
  ASSERT_EQ(drawn.frames.size(), 3u);
  EXPECT_GT(drawn.frames[0].shadows.still_drawn, 0u);
  for (const size_t later : {1u, 2u})
    EXPECT_EQ(drawn.frames[later].shadows.still_drawn + drawn.frames[later].shadows.composed, 0u);
  const Result first = draw(s, options);
  EXPECT_EQ(drawn.last.downloads.at(kAtlas), first.downloads.at(kAtlas));
  EXPECT_EQ(drawn.last.downloads.at(kStill), first.downloads.at(kStill));
}

// What was kept is what would be drawn now: the frame after some others, and the same with every tile drawn anew.
TEST(FrameShadows, KeptTilesAreAsDrawnAnew) {
  for (const scene::Scene& s : {scene::small(), scene::default_scene()}) {
    SCOPED_TRACE(s.name);
    Options o = {.size = {160, 90}, .shadow_slices = false, .keep_shadows = true, .warm_up = false};
    scene::Scene moved = s;
    const scene::Camera camera = scene::default_camera(s);
    const auto drawn = [&] { return frame::render(*device(), moved, scene::camera_in_frame(camera, o.frame), o); };
    for (; o.frame < 3; ++o.frame) {
      scene::move_to_frame(o.frame, s, moved);
      const Result r = drawn();
      o.history = frame::history_of(r, o);
      o.shadow_cache = r.shadow_cache;
    }
    scene::move_to_frame(o.frame, s, moved);
    const Result kept = drawn();
    EXPECT_LT(kept.shadows.still_drawn, kept.shadows.views);
    EXPECT_GT(kept.shadows.composed, kept.shadows.still_drawn);
    for (auto& [key, held] : o.shadow_cache.tiles) held.still.clear();
    const Result anew = drawn();
    EXPECT_EQ(anew.shadows.still_drawn, anew.shadows.views);
    for (const std::string& name : {kStill, kAtlas, kLit})
      EXPECT_TRUE(kept.downloads.at(name) == anew.downloads.at(name)) << name;
    EXPECT_TRUE(kept.image.texels == anew.image.texels);
  }
}

// ---- Against rays

constexpr Extent kSize = {640, 360};
// An edge within so many texels may be in the filter's reach: half of its 3x3 taps, and the receiver's place in one.
constexpr double kFilterTexels = 4;

// The light's side of a receiver: a ray, and how wide the filter is about it.
struct Towards {
  scene::Camera camera;
  double distance;  // from the camera to the receiver
};

// Nothing where the lookup may take one view or another of different texels, or none.
std::optional<Towards> towards(const scene::Light& light, const scene::Gathered& g, const scene::Camera& viewer,
                               const dvec3& position) {
  const LightRecord& record = g.lights.at(0);
  uint32_t view = record.first_view;
  const dvec3 relative = position - viewer.eye, away = position - light.position;
  if (light.kind == scene::LightKind::point) {
    const dvec3 size = abs(away);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    view += static_cast<uint32_t>(2 * axis + (away[axis] < 0));
  } else if (light.kind == scene::LightKind::directional) {
    const auto along = [&](const vec4& row) { return std::abs(dot(dvec3(vec3(row)), relative) + row.w); };
    const uint32_t end = record.first_view + record.views;
    while (view < end && !(along(g.shadow_views[view].clip_x) < 0.85 && along(g.shadow_views[view].clip_y) < 0.85))
      ++view;
    if (view == end) return {};
  }
  const ShadowView& v = g.shadow_views.at(view);
  const double texel = 2 / (length(dvec3(vec3(v.clip_x))) * v.tile.side);  // metres, or tangents
  Towards t;
  const bool is_sun = light.kind == scene::LightKind::directional;
  t.distance = is_sun ? 100 : length(away);
  const dvec3 from = is_sun ? position - dvec3(light.direction) * t.distance : light.position;
  t.camera = scene::look_at(from, position, 2 * std::atan(kFilterTexels * texel / 2 / (is_sun ? t.distance : 1)));
  return t;
}

// The share of light that arrives beyond doubt, 0 or 1: the receiver itself is met first, or what is so far before it
// that no slope over the filter's width reaches it. A shadow is one of everything, whichever way it faces. The filter's
// corners must meet the same: beside a wall they meet the wall, which is before the floor's plane that goes on behind.
std::optional<int> share_by_ray(const scene::Scene& two_sided, const Towards& t) {
  const std::optional<Hit> hit = cast(two_sided, t.camera, {1, 1}, 0.5, 0.5);
  if (!hit || hit->alpha_close || hit->edge_px < 1) return {};
  for (const int corner : {0, 1, 2, 3}) {
    const std::optional<Hit> beside = cast(two_sided, t.camera, {1, 1}, corner & 1, corner >> 1);
    if (!beside || beside->instance != hit->instance) return {};
  }
  if (std::abs(hit->distance - t.distance) < 0.002) return 1;
  if (hit->distance < t.distance - 0.3) return 0;
  return {};
}

dvec3 normal_of(const scene::Scene& s, const Hit& hit) {
  const scene::Instance& i = s.instances[hit.instance];
  const scene::Mesh& m = s.meshes[i.mesh];
  dvec3 p[3];
  for (uint32_t k = 0; k < 3; ++k)
    p[k] =
        dvec3(i.to_world * glm::dvec4(m.positions[m.indices[m.parts[hit.part].first_index + 3 * hit.triangle + k]], 1));
  return normalize(cross(p[1] - p[0], p[2] - p[0]));
}

struct Counts {
  uint32_t lit = 0, dark = 0, wrong = 0;
};

// The scene under one light: what it sheds where a ray meets nothing is there as if it cast no shadows, and where one
// meets something it is as if the light were black, bit for bit.
Counts compare(scene::Scene s, const scene::Light& light, uint32_t pixels) {
  const scene::Camera camera = scene::default_camera(s);
  // The second sheds nothing, but has shadows drawn and looked up in all three pictures.
  scene::Light idle = {.position = camera.eye, .intensity = 0, .range = 1, .casts_shadows = true};
  s.lights = {light, idle};
  const Options o = {.size = kSize, .goals = {kLit, kDepth}, .warm_up = false};
  const Result shadowed = draw(s, o);
  const scene::ShadowRequest request;
  const scene::Gathered g = gather(s, camera, kSize, &request);
  s.lights[0].casts_shadows = false;
  const Result lit = draw(s, o);
  s.lights[0].intensity = 0;
  const Result black = draw(s, o);
  const auto depth = words<float>(shadowed.downloads.at(kDepth));
  const auto on = words<uint64_t>(shadowed.downloads.at(kLit)), all = words<uint64_t>(lit.downloads.at(kLit)),
             none = words<uint64_t>(black.downloads.at(kLit));

  scene::Scene two_sided = s;
  for (scene::Material& m : two_sided.materials) m.double_sided = true;
  const ViewRays rays = view_rays(camera, kSize);
  Pcg32 rng(1);
  Counts counts;
  for (uint32_t i = 0; i < pixels; ++i) {
    const uint32_t x = rng.below(kSize.width), y = rng.below(kSize.height), at = y * kSize.width + x;
    if (all[at] == none[at]) continue;
    const auto seen = cast(s, camera, kSize, x + 0.5, y + 0.5);
    if (!seen || doubt_of(seen) != Doubt::none || seen->edge_px < 1) continue;
    const dvec3 position =
        camera.eye + (dvec3(rays.corner) + dvec3(rays.across) * (x + 0.5) + dvec3(rays.down) * (y + 0.5)) *
                         (camera.near_plane / double{depth[at]});
    const auto t = towards(light, g, camera, position);
    if (!t || std::abs(dot(normal_of(s, *seen), normalize(position - t->camera.eye))) < 0.2) continue;
    const auto expected = share_by_ray(two_sided, *t);
    if (!expected) continue;
    ++(*expected ? counts.lit : counts.dark);
    if (on[at] == (*expected ? all : none)[at]) continue;
    if (++counts.wrong < 10)
      ADD_FAILURE() << fmt::format("pixel ({}, {}) at ({:.3f}, {:.3f}, {:.3f}) should be {}", x, y, position.x,
                                   position.y, position.z, *expected ? "lit" : "dark");
  }
  return counts;
}

// Few large triangles, so that most of their insides are farther than a filter's width from any edge: a floor, a wall,
// a tilted top, a panel, and a sheet whose one half is a hole.
scene::Scene panels() {
  using namespace scene::builtin;
  scene::Scene s;
  s.name = "panels";
  const uint32_t plain = add_material(s, {.name = "plain", .metallic = 0});
  const uint32_t half = add_material(
      s, {.name = "half",
          .metallic = 0,
          .base_image = add_image(s, "half", 64, [](float u, float) { return glm::vec4(1, 1, 1, u < 0.5f ? 1 : 0); }),
          .alpha = scene::AlphaMode::masked});
  const auto add = [&](uint32_t material, const dvec3& at, const dvec3& right, const dvec3& up) {
    const auto quad = [&](double u, double v) { return right * (u - 0.5) + up * (v - 0.5); };
    place(s, add_patch_mesh(s, "panel", material, 1, 1, {1, 1}, quad), at);
  };
  add(plain, {0, 0, 0}, {16, 0, 0}, {0, 0, -16});
  add(plain, {0, 2, -5}, {12, 0, 0}, {0, 4, 0});
  add(plain, {-1.5, 1.6, -1}, {3, 0.4, 0}, {0, 0.2, -3});
  add(plain, {3, 1.2, 0}, {-1.2, 0, -1.6}, {0, 2.4, 0});
  add(half, {0.8, 1.4, 2}, {3, 0, 0}, {0, 0.5, -2});
  s.cameras = {scene::look_at({0, 5, 9}, {0, 0.5, -1}, 0.785398)};
  s.lights = {{.kind = scene::LightKind::directional, .direction = normalize(glm::vec3(0.4f, -1, -0.3f))},
              {.kind = scene::LightKind::spot,
               .position = {-4, 6, 4},
               .direction = normalize(glm::vec3(0.6f, -1, -0.7f)),
               .intensity = 500,
               .range = 20,
               .inner_rad = 0.4f,
               .outer_rad = 0.6f},
              {.kind = scene::LightKind::point, .position = {0.5, 3.5, 1}, .intensity = 100, .range = 12}};
  return s;
}

TEST(FrameShadows, FallWhereRaysSay) {
  const scene::Scene s = panels();
  for (scene::Light light : s.lights) {
    SCOPED_TRACE(static_cast<int>(light.kind));
    light.casts_shadows = true;
    const Counts c = compare(s, light, 10'000);
    fmt::print("light of kind {}: {} pixels lit, {} dark, {} wrong\n", static_cast<int>(light.kind), c.lit, c.dark,
               c.wrong);
    EXPECT_EQ(c.wrong, 0u);
    EXPECT_GT(c.lit, 200u);
    EXPECT_GT(c.dark, 100u);
  }
}

}  // namespace
}  // namespace assay::tests
