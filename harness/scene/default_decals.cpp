// The 1000 decals of `default`: what wears, soils and papers the hall.
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "harness/scene/default_scene.h"
#include "harness/scene/noise.h"

namespace assay::scene::builtin {
namespace {

using glm::dvec3;

constexpr uint32_t kSide = 128;  // texels of a picture
constexpr uint32_t kDecals = 1000, kOnReceivers = 200;

// ---- Pictures: what is seen at a place, its coverage, and how high it stands

struct Spot {
  glm::vec3 colour;  // as stored
  float coverage = 1, height = 0, roughness = 1;
};
using Picture = Spot (*)(float u, float v);

float radius(float u, float v) { return std::hypot(u - 0.5f, v - 0.5f); }
// 1 inside, falling to 0 towards the picture's sides, ragged by noise.
float blot(float u, float v, uint32_t seed) {
  return smooth(0.46f, 0.25f, radius(u, v) + 0.22f * (rough_noise(u, v, 4, 4, seed) - 0.5f));
}

Spot bullet_hole(float u, float v) {
  const float r = radius(u, v) + 0.05f * (noise(u, v, 16, 201) - 0.5f);
  const float hole = smooth(0.14f, 0.1f, r), chipped = smooth(0.42f, 0.2f, r + 0.2f * (noise(u, v, 8, 202) - 0.5f));
  return {glm::vec3(0.62f - 0.5f * hole), std::max(hole, 0.9f * chipped),
          -0.05f * smooth(0.2f, 0.05f, r) - 0.02f * chipped, 0.95f};
}
Spot crack(float u, float v) {
  const float bend = 0.18f * (rough_noise(u, 0.5f, 4, 4, 211) - 0.5f), branch = 0.3f * (noise(0.3f, v, 6, 213) - 0.5f);
  const float along = smooth(0, 0.15f, u) * smooth(1, 0.85f, u);
  const float main = std::fabs(v - 0.5f - bend), aside = std::fabs(u - 0.45f - branch) + (v < 0.5f ? 1.0f : 0.0f);
  const float width = 0.012f + 0.02f * noise(u, v, 8, 212);
  const float depth = along * std::max(smooth(2 * width, 0, main), smooth(1.5f * width, 0, aside) * smooth(1, 0.8f, v));
  return {{0.12f, 0.11f, 0.1f}, 0.9f * depth, -0.02f * depth, 1};
}
Spot dirt(float u, float v) {
  const float shade = 0.2f + 0.2f * rough_noise(u, v, 8, 4, 221);
  return {glm::vec3(1.1f, 0.9f, 0.65f) * shade, 0.85f * blot(u, v, 222), 0, 1};
}
Spot stain(float u, float v) {  // still wet
  const float wet = blot(u, v, 231);
  return {{0.1f, 0.11f, 0.09f}, 0.75f * wet, 0, 0.08f};
}
Spot scorch(float u, float v) {
  const float r = radius(u, v), rays = noise(std::atan2(v - 0.5f, u - 0.5f) / 6.2832f + 0.5f, 0.5f, 24, 241);
  return {glm::vec3(0.06f), smooth(0.48f, 0.1f, r + 0.12f * rays), 0, 0.9f};
}
Spot lichen(float u, float v) {
  const float grown = blot(u, v, 251) * smooth(0.35f, 0.6f, rough_noise(u, v, 12, 3, 252));
  return {glm::vec3(0.45f, 0.52f, 0.2f) * (0.7f + 0.5f * noise(u, v, 32, 253)), grown, 0.015f * grown, 1};
}
// A sheet with a frame, a disc, and lines of what may be writing.
Spot poster(float u, float v, const glm::vec3& paper, const glm::vec3& ink, uint32_t seed) {
  const float border = std::fmin(std::fmin(u, 1 - u), std::fmin(v, 1 - v));
  if (border < 0.03f + 0.03f * noise(u, v, 16, seed)) return {paper, 0, 0, 0.7f};  // torn
  const float disc = smooth(0.24f, 0.23f, std::hypot(u - 0.5f, v - 0.36f));
  const bool star = std::cos(5 * std::atan2(v - 0.36f, u - 0.5f)) * 0.07f + 0.12f > std::hypot(u - 0.5f, v - 0.36f);
  const float line = std::fmod(v, 0.075f) < 0.04f && v > 0.66f && v < 0.9f && u > 0.14f && u < 0.86f ? 1.0f : 0.0f;
  const float words = line * (random(static_cast<uint32_t>(u * 24), static_cast<uint32_t>(v / 0.075f), seed) < 0.8f);
  const float frame = smooth(0.08f, 0.075f, border) * smooth(0.065f, 0.07f, border);
  const float printed = std::max(std::max(star ? 0.0f : disc, words), frame);
  const float fold = std::fmin(std::fabs(u - 0.5f), std::fabs(v - 0.5f));
  const float aged = 0.8f + 0.2f * rough_noise(u, v, 4, 4, seed + 1);
  return {(paper + (ink - paper) * printed) * aged, 1, 0.012f * smooth(0.02f, 0, fold), 0.6f};
}
Spot red_poster(float u, float v) { return poster(u, v, {0.9f, 0.84f, 0.7f}, {0.66f, 0.1f, 0.08f}, 261); }
Spot blue_poster(float u, float v) { return poster(u, v, {0.82f, 0.85f, 0.86f}, {0.1f, 0.2f, 0.45f}, 271); }
Spot arrow(float u, float v) {  // stencilled
  const float head = 0.34f - std::fabs(v - 0.5f) - std::fmax(0.0f, u - 0.58f) * 0.9f;
  const bool inside = u > 0.55f ? head > 0 && u < 0.93f : u > 0.1f && std::fabs(v - 0.5f) < 0.12f;
  const float worn = smooth(0.3f, 0.45f, rough_noise(u, v, 8, 3, 281));
  return {{0.85f, 0.65f, 0.1f}, inside ? 0.9f * worn : 0, 0, 0.5f};
}
Spot rivets(float u, float v) {  // relief alone
  const float x = std::fabs(std::fmod(u * 4, 1.0f) - 0.5f), y = std::fabs(std::fmod(v * 4, 1.0f) - 0.5f);
  const float inside = smooth(0, 0.06f, std::fmin(std::fmin(u, 1 - u), std::fmin(v, 1 - v)));
  return {{0.5f, 0.5f, 0.52f}, inside, 0.05f * inside * smooth(0.3f, 0.1f, std::hypot(x, y)), 0.35f};
}

// Slopes of the heights between a texel's neighbours.
glm::vec4 normal_at(Picture p, float u, float v) {
  constexpr float kStep = 1.0f / kSide;
  const auto height = [p](float x, float y) { return p(std::clamp(x, 0.0f, 1.0f), std::clamp(y, 0.0f, 1.0f)).height; };
  const float along = (height(u + kStep, v) - height(u - kStep, v)) / (2 * kStep),
              down = (height(u, v + kStep) - height(u, v - kStep)) / (2 * kStep);
  return {normalize(glm::vec3(-along, down, 1)) * 0.5f + 0.5f, 1};
}

struct Kind {
  const char* name;
  Picture picture;
  glm::vec3 weights;     // a picture for each that is above 0
  double low_m, high_m;  // of half its width
  uint32_t mode = kNormalReoriented;
  bool upright = false;
  Decal decal = {};
};
// clang-format off
std::array<Kind, 10> kinds() {
  return {{{"bullet hole", bullet_hole, {1, 1, 1}, 0.05, 0.1},
           {"crack", crack, {1, 1, 0}, 0.3, 0.9},
           {"dirt", dirt, {1, 0, 1}, 0.3, 0.9},
           {"stain", stain, {0.8f, 0, 1}, 0.25, 0.8},
           {"scorch", scorch, {1, 0, 1}, 0.3, 0.7},
           {"lichen", lichen, {1, 1, 1}, 0.2, 0.6, kNormalWhiteout},
           {"red poster", red_poster, {1, 0.6f, 1}, 0.35, 0.5, kNormalLinear, true},
           {"blue poster", blue_poster, {1, 0.6f, 1}, 0.35, 0.5, kNormalLinear, true},
           {"arrow", arrow, {1, 0, 1}, 0.25, 0.45, kNormalLinear, true},
           {"rivets", rivets, {0, 1, 0.5f}, 0.2, 0.3, kNormalWhiteout, true}}};
}
// clang-format on

void paint(Scene& s, Kind& k) {
  const std::string name = k.name;
  k.decal.weights = k.weights, k.decal.normal_mode = k.mode;
  // Coverage is the colour's alpha, whichever channels the decal touches.
  k.decal.colour_image = add_image(s, name + " decal", kSide, [&](float u, float v) {
    const Spot at = k.picture(u, v);
    return glm::vec4(at.colour, at.coverage);
  });
  if (k.weights.y > 0)
    k.decal.normal_image =
        add_image(s, name + " decal normal", kSide, [&](float u, float v) { return normal_at(k.picture, u, v); });
  if (k.weights.z > 0) k.decal.roughness = k.picture(0.5f, 0.5f).roughness;
}

// ---- Places

// z along `outward`, y towards `up` and then turned by so much.
glm::dquat facing(const dvec3& outward, const dvec3& up, double turn_rad) {
  const dvec3 z = normalize(outward), x = normalize(cross(up, z));
  return quat_cast(glm::dmat3(x, cross(z, x), z)) * glm::angleAxis(turn_rad, dvec3(0, 0, 1));
}

struct Layer {
  Scene& scene;
  std::array<Kind, 10> kinds = builtin::kinds();
  uint32_t count = 0;

  double chance(uint32_t stream) const { return double{random(count, stream, 301)}; }
  // Of a kind, on a surface through `at`.
  void lay(uint32_t kind, const dvec3& at, const dvec3& outward, const dvec3& up, double deep, double most,
           uint32_t receiver = kNone) {
    const Kind& k = kinds[kind];
    Decal d = k.decal;
    const double half = std::min(most, k.low_m + (k.high_m - k.low_m) * chance(1));
    d.centre = at, d.half_extents = {half, k.upright && kind < 8 ? 1.3 * half : half, deep};
    d.orientation = facing(outward, up, k.upright ? 0.08 * (chance(2) - 0.5) : kTau * chance(2));
    d.receiver = receiver;
    if (half < 0.15) d.fade_distance = 30;  // a pixel, there
    scene.decals.push_back(d);
    ++count;
  }
};

void add_floor_decals(Layer& l, uint32_t last) {
  constexpr uint32_t kLie[] = {1, 2, 2, 3, 3, 4, 5, 1};
  while (l.count < last) {
    const double x = 19 * (l.chance(3) - 0.5), z = 54 * (l.chance(4) - 0.5);
    l.lay(kLie[l.count % std::size(kLie)], {x, 0, z}, {0, 1, 0}, {0, 0, -1}, 0.06, 1);
  }
}
void add_wall_decals(Layer& l, uint32_t last) {
  constexpr uint32_t kHang[] = {6, 0, 1, 7, 2, 0, 3, 8, 0, 5, 9, 4};
  while (l.count < last) {
    const uint32_t kind = kHang[l.count % std::size(kHang)];
    const double side = l.count % 2 ? 1 : -1, z = 54 * (l.chance(3) - 0.5);
    const double y = l.kinds[kind].upright ? 1.6 + 0.4 * l.chance(4) : 0.3 + 6 * l.chance(4);
    // The wall's base stands a little before the rest.
    l.lay(kind, {side * (kHallWidth_m / 2 - 0.05), y, z}, {-side, 0, 0}, {0, 1, 0}, 0.12, 0.9);
  }
}

// Round upright things: from a point of their axis outwards, in their own space.
struct Upright {
  const char* mesh;
  double radius, low, high, deep, most;
};
constexpr Upright kUprights[] = {{"column", 0.5, 1.2, 5.2, 0.2, 0.4},
                                 {"obelisk", 0.42, 0.4, 2.4, 0.2, 0.3},
                                 {"growth", 0.9, -0.5, 0.6, 0.35, 0.4},
                                 {"planter", 0.6, 0.1, 0.4, 0.12, 0.25}};

void add_receiver_decals(Layer& l, uint32_t last) {
  struct Standing {
    uint32_t instance;
    const Upright* as;
  };
  std::vector<Standing> standing;
  for (uint32_t i = 0; i < l.scene.instances.size(); ++i)
    for (const Upright& u : kUprights)
      if (l.scene.meshes[l.scene.instances[i].mesh].name == u.mesh) standing.push_back({i, &u});
  constexpr uint32_t kStick[] = {0, 5, 1, 6, 2, 8, 0, 4, 9, 7, 3};
  for (uint32_t n = 0; l.count < last; ++n) {
    const Standing& at = standing[n % standing.size()];
    const double turn = at.as->radius == 0.42 ? kTau / 4 * static_cast<double>(n % 4) : kTau * l.chance(3);
    const dvec3 outward(std::sin(turn), 0, std::cos(turn));
    const double y = at.as->low + (at.as->high - at.as->low) * l.chance(4);
    l.lay(kStick[n % std::size(kStick)], outward * at.as->radius + dvec3(0, y, 0), outward, {0, 1, 0}, at.as->deep,
          at.as->most, at.instance);
  }
}

}  // namespace

void add_default_decals(Scene& s) {
  Layer l = {s};
  for (Kind& k : l.kinds) paint(s, k);
  add_floor_decals(l, 450);
  add_wall_decals(l, kDecals - kOnReceivers);
  add_receiver_decals(l, kDecals);
}

}  // namespace assay::scene::builtin
