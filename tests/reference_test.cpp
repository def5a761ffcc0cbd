// The reference for G-buffer and radiance: surfaces of known answers, and frames made here, whole and with faults
// planted.
#include "tests/reference.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "tests/small_scenes.h"

namespace assay::tests {
namespace {

using glm::dvec2;
using glm::dvec3;
using scene::Scene;

constexpr Extent kSize = {160, 120};
constexpr uint32_t kPixels = 400;
constexpr uint64_t kSeed = 7;

std::optional<SurfacePoint> point_at(const Scene& s, double x, double y) {
  const auto hit = cast(s, s.cameras[0], kSize, x, y);
  if (!hit || hit->instance == scene::kNone) return {};
  return surface_at(s, s.cameras[0], kSize, x, y, *hit);
}

// ---- Surfaces ------------------------------------------------------------------------------------------------------

TEST(Reference, SurfacesHaveTheQuadsOwnCoordinates) {
  for (const std::string& name : small_scene_names()) {
    SCOPED_TRACE(name);
    const Scene s = small_scene(name);
    const auto p = point_at(s, 80.5, 60.5);
    ASSERT_TRUE(p.has_value());
    const dvec3 world = s.cameras[0].eye + p->position;
    EXPECT_NEAR(world.z, 0, 1e-9);  // the quad lies in z = 0, x from 9 to 11, y from -1 to 1
    EXPECT_NEAR(length(p->normal - dvec3(0, 0, 1)), 0, 1e-9);
    EXPECT_EQ(p->front, name != "double_sided");
    const dvec2 uv = name == "uvless"        ? dvec2(0)
                     : name == "tangentless" ? dvec2((11 - world.x) / 2, (1 - world.y) / 2)
                                             : dvec2((world.x - 9) / 2, (1 - world.y) / 2);
    EXPECT_NEAR(length(p->footprint.uv - uv), 0, 1e-6);
    if (name == "tangentless") {  // u runs to the left: derived tangents and their hand follow
      EXPECT_NEAR(length(p->tangent - dvec3(-1, 0, 0)), 0, 1e-6);
      EXPECT_NEAR(length(p->handedness * cross(p->normal, p->tangent) - dvec3(0, 1, 0)), 0, 1e-6);
    }
    const auto left = point_at(s, 80.499, 60.5), right = point_at(s, 80.501, 60.5), below = point_at(s, 80.5, 60.501),
               above = point_at(s, 80.5, 60.499);
    EXPECT_NEAR(length((right->footprint.uv - left->footprint.uv) / 0.002 - p->footprint.per_x), 0, 1e-7);
    EXPECT_NEAR(length((below->footprint.uv - above->footprint.uv) / 0.002 - p->footprint.per_y), 0, 1e-7);
  }
}

TEST(Reference, MirroredInstancesKeepTheirSidesAndHands) {
  Scene s = small_scene("tangentless");
  const auto before = point_at(s, 80.5, 60.5);
  s.instances[0].to_world = s.instances[0].to_world * glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const auto after = point_at(s, 80.5, 60.5);
  ASSERT_TRUE(before && after);
  EXPECT_TRUE(after->front);
  EXPECT_NEAR(length(after->normal - dvec3(0, 0, 1)), 0, 1e-9);
  EXPECT_NEAR(length(after->tangent + before->tangent), 0, 1e-9);  // u now runs to the right
  // The bitangent still goes up the image.
  EXPECT_NEAR(length(after->handedness * cross(after->normal, after->tangent) - dvec3(0, 1, 0)), 0, 1e-6);
}

// ---- Materials -----------------------------------------------------------------------------------------------------

Appearance appearance(const Scene& s, double x, double y) {
  Filter filter(s);
  return *appearance_of(s, *point_at(s, x, y), filter);
}

TEST(Reference, ATexturelessMaterialIsItsFactorsExactly) {
  const Appearance a = appearance(small_scene("textureless"), 80.5, 60.5);
  const double base[] = {0.2f, 0.4f, 0.6f}, emissive[] = {0.5f, 0.25f, 2};
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(a.base[c].low, base[c]);
    EXPECT_EQ(a.base[c].high, base[c]);
    EXPECT_EQ(a.emissive[c].low, emissive[c]);
    EXPECT_EQ(a.emissive[c].high, emissive[c]);
  }
  EXPECT_EQ(a.roughness.low, 0.5);
  EXPECT_EQ(a.metallic.high, 0.25);
  EXPECT_EQ(a.occlusion.low, 1);
  EXPECT_LT(a.normal_rad, 0.001);
}

TEST(Reference, AMaterialWithoutUvsShowsOneTexelsNeighbourhood) {
  const Scene s = small_scene("uvless");
  const Appearance a = appearance(s, 80.5, 60.5), b = appearance(s, 95.5, 50.5);
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(a.base[c].low, b.base[c].low);
    // uv 0 lies between four texels of the repeating ramp, at its corners.
    double mean = 0;
    for (const size_t texel : {0u, 31u, 31u * 32, 31u * 32 + 31})
      mean += srgb_to_linear(s.images[0].rgba[texel * 4 + c] / 255.0) / 4;
    EXPECT_TRUE(a.base[c].holds(mean));
    EXPECT_LT(a.base[c].high - a.base[c].low, 0.05);
  }
}

TEST(Reference, BackFacesOfBothSidedMaterialsAreTurned) {
  EXPECT_NEAR(appearance(small_scene("double_sided"), 80.5, 60.5).normal.z, -1, 1e-9);
  EXPECT_NEAR(appearance(small_scene("masked"), 83.5, 60.5).normal.z, 1, 1e-9);
}

TEST(Reference, NormalMapsBendAlongTheDerivedTangent) {
  const Scene s = small_scene("tangentless");
  for (double x = 60.5; x < 100; x += 4) {
    const auto p = point_at(s, x, 60.5);
    const Appearance a = appearance(s, x, 60.5);
    const double nx = 0.5 * std::sin(6.283185307 * p->footprint.uv.x), ny = 0.2;
    // Tangent -x, bitangent +y; the scale counts for x and y.
    const dvec3 expected = normalize(dvec3(-0.8 * nx, 0.8 * ny, std::sqrt(1 - nx * nx - ny * ny)));
    EXPECT_LE(std::acos(std::min(1.0, dot(expected, a.normal))), a.normal_rad) << x;
    EXPECT_LT(a.normal_rad, 0.12) << x;
  }
}

// ---- Frames --------------------------------------------------------------------------------------------------------

std::array<int16_t, 2> octahedral(const dvec3& n) {
  const dvec3 o = n / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  dvec2 e(o.x, o.y);
  if (o.z < 0) e = {(1 - std::abs(o.y)) * (o.x < 0 ? -1 : 1), (1 - std::abs(o.x)) * (o.y < 0 ? -1 : 1)};
  return {static_cast<int16_t>(std::lround(e.x * 32767)), static_cast<int16_t>(std::lround(e.y * 32767))};
}
uint32_t shared_exponent(const dvec3& v) {
  const double most = std::max({v.x, v.y, v.z});
  if (most < 0x1p-25) return 0;
  int exponent = std::max(-15, std::ilogb(most) + 1);
  if (std::lround(std::ldexp(most, 9 - exponent)) == 512) ++exponent;
  uint32_t code = static_cast<uint32_t>(exponent + 15) << 27;
  for (int c = 0; c < 3; ++c) code |= static_cast<uint32_t>(std::lround(std::ldexp(v[c], 9 - exponent))) << 9 * c;
  return code;
}
uint8_t code_of(double v) { return static_cast<uint8_t>(std::lround(std::min(1.0, std::max(0.0, v)) * 255)); }
double middle(const Range& r) { return (r.low + r.high) / 2; }

struct Frame {
  std::vector<GBufferPixel> gbuffer;
  std::vector<uint32_t> features;
  std::vector<float> depth;
  std::vector<dvec3> radiance;
};

using Alter = std::function<void(Appearance&, const SurfacePoint&)>;
using Shade = std::function<dvec3(const Shaded&, const dvec3& position, const dvec3& eye)>;

dvec3 lit_by_all(const Scene& s, const Shaded& what, const dvec3& position, const dvec3& eye) {
  return reflected(what, position, eye, s.lights).radiance;
}

// What a right renderer would make of the scene, from the middle of what is allowed; `alter` and `shade` plant faults.
Frame made(const Scene& s, const Alter& alter = {}, const Shade& shade = {}) {
  Frame f;
  Filter filter(s);
  const scene::Camera& camera = s.cameras[0];
  for (uint32_t y = 0; y < kSize.height; ++y)
    for (uint32_t x = 0; x < kSize.width; ++x) {
      f.gbuffer.emplace_back(), f.features.push_back(0), f.depth.push_back(0), f.radiance.emplace_back(0);
      const auto p = point_at(s, x + 0.5, y + 0.5);
      if (!p) continue;
      Appearance a = *appearance_of(s, *p, filter);
      if (alter) alter(a, *p);
      GBufferPixel& g = f.gbuffer.back();
      dvec3 emissive;
      for (size_t c = 0; c < 3; ++c)
        g.base_roughness[c] = code_of(std::sqrt(middle(a.base[c]))),
        emissive[static_cast<int>(c)] = middle(a.emissive[c]);
      g.base_roughness[3] = code_of(middle(a.roughness));
      g.metallic_occlusion = {code_of(middle(a.metallic)), code_of(middle(a.occlusion))};
      g.normal = octahedral(a.normal);
      g.emissive = shared_exponent(emissive);
      f.features.back() = feature_bits(s, s.materials[p->material]);
      const double w = dot(p->position, camera.orientation * dvec3(0, 0, -1));
      f.depth.back() = static_cast<float>(camera.near_plane / w);
      const Shaded what = shaded_of(g, f.features.back());
      const dvec3 position = camera.eye + p->position;
      f.radiance.back() = (shade ? shade(what, position, camera.eye) : lit_by_all(s, what, position, camera.eye)) +
                          shared_exponent_radiance(g.emissive);
    }
  return f;
}

Verdict judged_gbuffer(const Scene& s, const Frame& f) {
  return judge_gbuffer({s, s.cameras[0], kSize}, f.gbuffer, kPixels, kSeed);
}
Verdict judged_radiance(const Scene& s, const Frame& f) {
  return judge_radiance({s, s.cameras[0], kSize}, {f.gbuffer, f.features, f.depth, f.radiance}, s.lights, kPixels,
                        kSeed);
}

TEST(Reference, RightFramesAreFoundRight) {
  for (const std::string& name : small_scene_names()) {
    const Scene s = small_scene(name);
    const Frame f = made(s);
    const Verdict g = judged_gbuffer(s, f), r = judged_radiance(s, f);
    EXPECT_TRUE(g.wrong.empty()) << name << ": " << to_text(g);
    EXPECT_TRUE(r.wrong.empty()) << name << ": " << to_text(r);
    EXPECT_GE(g.judged - g.background, kPixels / 10) << name << ": " << to_text(g);
    EXPECT_EQ(g.classes, 0u);
  }
}

// Each fault of a texturing pass is found in the scene that is there for it.
TEST(Reference, WrongGBuffersAreFound) {
  struct Fault {
    const char *what, *scene;
    Alter alter;
  };
  using Change = std::function<void(SurfacePoint&)>;
  const auto again = [](const Scene& scene, const Change& change) -> Alter {
    return [&scene, change, filter = std::make_shared<Filter>(scene)](Appearance& a, SurfacePoint p) {
      change(p);
      a = *appearance_of(scene, p, *filter);
    };
  };
  const Scene masked = small_scene("masked"), bent = small_scene("tangentless");
  const Fault faults[] = {
      {"back faces keep their normal", "double_sided", [](Appearance& a, const auto&) { a.normal = -a.normal; }},
      {"colour is not decoded", "masked",
       [](Appearance& a, const auto&) {
         for (Range& r : a.base) r = {linear_to_srgb(r.low), linear_to_srgb(r.high)};
       }},
      {"v runs up", "masked", again(masked, [](SurfacePoint& q) { q.footprint.uv.y = -q.footprint.uv.y; })},
      {"two texels beside", "masked", again(masked, [](SurfacePoint& q) { q.footprint.uv += 2.0 / 32; })},
      {"two levels too coarse", "masked",
       again(masked, [](SurfacePoint& q) { q.footprint.per_x *= 64, q.footprint.per_y *= 64; })},
      {"roughness and metallic change places", "tangentless",
       [](Appearance& a, const auto&) { std::swap(a.roughness, a.metallic); }},
      {"occlusion without its strength", "tangentless",
       [](Appearance& a, const auto&) {
         a.occlusion = {a.occlusion.low * 2 - 1, a.occlusion.high * 2 - 1};
       }},
      {"the hand is forgotten", "tangentless", again(bent, [](SurfacePoint& q) { q.handedness = -q.handedness; })},
      {"the normal map is forgotten", "tangentless", [](Appearance& a, const SurfacePoint& p) { a.normal = p.normal; }},
      {"the texture is forgotten", "uvless",
       [](Appearance& a, const auto&) {
         for (Range& r : a.base) r = {1, 1};
       }},
      {"emission is forgotten", "textureless", [](Appearance& a, const auto&) { a.emissive = {}; }},
      {"a colour two codes off", "textureless",
       [](Appearance& a, const auto&) {
         a.base[1] = {std::pow(std::sqrt(0.4) + 2.0 / 255, 2), std::pow(std::sqrt(0.4) + 2.0 / 255, 2)};
       }},
  };
  for (const Fault& fault : faults) {
    const Scene s = small_scene(fault.scene);
    const Verdict v = judged_gbuffer(s, made(s, fault.alter));
    EXPECT_GT(v.wrong.size(), 5u) << fault.what << ": " << to_text(v);
  }
}

TEST(Reference, WrongLightIsFound) {
  const Scene s = small_scene("textureless");
  const auto with = [&](const std::function<void(std::vector<scene::Light>&)>& change) -> Shade {
    std::vector<scene::Light> lights = s.lights;
    change(lights);
    return [lights](const Shaded& what, const dvec3& position, const dvec3& eye) {
      return reflected(what, position, eye, lights).radiance;
    };
  };
  using Lights = std::vector<scene::Light>;
  const std::pair<const char*, Shade> faults[] = {
      {"a light is missing", with([](Lights& l) { l.pop_back(); })},
      {"a light is moved by 5 cm", with([](Lights& l) { l[1].position.x += 0.05; })},
      {"a light is a hundredth too bright", with([](Lights& l) { l[1].intensity *= 1.01f; })},
      {"the range is forgotten", with([](Lights& l) { l[1].range = 0; })},
      {"the cone has a hard edge", with([](Lights& l) { l[0].inner_rad = l[0].outer_rad; })},
      {"a spot is a point", with([](Lights& l) { l[0].kind = scene::LightKind::point; })},
      {"roughness for its square",
       [&](const Shaded& what, const dvec3& position, const dvec3& eye) {
         Shaded other = what;
         other.roughness = std::sqrt(what.roughness);
         return lit_by_all(s, other, position, eye);
       }},
      {"the eye is at the origin", [&](const Shaded& what, const dvec3& position, const dvec3&) {
         return lit_by_all(s, what, position, dvec3(0));
       }}};
  for (const auto& [what, shade] : faults) {
    const Verdict v = judged_radiance(s, made(s, {}, shade));
    EXPECT_GT(v.wrong.size(), 5u) << what << ": " << to_text(v);
  }
  Frame off = made(s);
  for (float& d : off.depth) d *= 1.001f;
  EXPECT_GT(judged_radiance(s, off).wrong.size(), 5u);
}

TEST(Reference, ASurfaceWhereThereIsNoneIsFound) {
  const Scene s = small_scene("textureless");
  Frame f = made(s);
  for (GBufferPixel& g : f.gbuffer) g.base_roughness[0] = std::max<uint8_t>(g.base_roughness[0], 1);
  for (dvec3& r : f.radiance) r += 0.01;
  EXPECT_GT(judged_gbuffer(s, f).wrong.size(), 5u);
  EXPECT_GT(judged_radiance(s, f).wrong.size(), 5u);
}

}  // namespace
}  // namespace assay::tests
