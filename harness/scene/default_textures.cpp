// Textures of `default`: a height field a look, its colour, normal and surface images derived from it. All repeat.
#include <algorithm>
#include <cmath>

#include "harness/scene/default_scene.h"
#include "harness/scene/noise.h"

namespace assay::scene::builtin {
namespace {

// ---- Height fields, 0 to 1 -----------------------------------------------------------------------------------------

// Blocks in rows, every other row shifted by half; their edges fall into the joint.
float masonry(float u, float v, uint32_t across, uint32_t rows, float joint, uint32_t seed) {
  const float y = v * static_cast<float>(rows);
  const auto row = static_cast<uint32_t>(y);
  const float x = fraction(u + (row % 2 ? 0.5f / static_cast<float>(across) : 0.0f)) * static_cast<float>(across);
  const float dx = 0.5f - std::fabs(fraction(x) - 0.5f), dy = 0.5f - std::fabs(fraction(y) - 0.5f);
  const float edge = std::fmin(dx / static_cast<float>(across), dy / static_cast<float>(rows));
  const float lift = 0.7f + 0.2f * random(static_cast<uint32_t>(x), row, seed);
  return smooth(0, joint, edge) * (lift + 0.1f * rough_noise(u, v, 16, 3, seed));
}
float planks(float u, float v, uint32_t seed) {
  const float x = u * 4, edge = 0.5f - std::fabs(fraction(x) - 0.5f);
  const float grain = noise(u, fraction(v + 0.37f * std::floor(x)), 32, seed) * 0.3f + noise(u, v, 64, seed + 1) * 0.2f;
  return smooth(0, 0.06f, edge) * (0.5f + grain);
}
float plates(float u, float v, uint32_t seed) {
  const float x = fraction(u * 2), y = fraction(v * 2);
  const float edge = 0.5f - std::fmax(std::fabs(x - 0.5f), std::fabs(y - 0.5f));
  const float rx = std::fabs(x - 0.5f) - 0.42f, ry = std::fabs(y - 0.5f) - 0.42f;
  const float rivet = 1 - smooth(0.02f, 0.03f, std::sqrt(rx * rx + ry * ry));
  return smooth(0.005f, 0.02f, edge) * 0.7f + rivet * 0.2f + 0.1f * rough_noise(u, v, 8, 4, seed);
}
float weave_height(float u, float v) {
  const float x = fraction(u * 32), y = fraction(v * 32);
  const bool over = (static_cast<int>(u * 32) + static_cast<int>(v * 32)) % 2;
  return 0.4f + 0.6f * (over ? 1 - std::fabs(x * 2 - 1) : 1 - std::fabs(y * 2 - 1));
}
// Rounded cells around one point each.
float cells(float u, float v, uint32_t count, uint32_t seed) {
  const float x = u * static_cast<float>(count), y = v * static_cast<float>(count);
  float nearest = 9;
  for (uint32_t j = 0; j < 3; ++j)
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t cx = static_cast<uint32_t>(x) + count + i - 1, cy = static_cast<uint32_t>(y) + count + j - 1;
      const float px = static_cast<float>(cx) + random(cx % count, cy % count, seed) - static_cast<float>(count);
      const float py = static_cast<float>(cy) + random(cx % count, cy % count, seed + 1) - static_cast<float>(count);
      nearest = std::fmin(nearest, (px - x) * (px - x) + (py - y) * (py - y));
    }
  return 1 - std::fmin(1.0f, nearest);
}
// Distance, in cells, to the nearer of two quarter circles a cell, turned at random: they join into winding lines.
float winding(float u, float v, uint32_t count, uint32_t seed) {
  float x = u * static_cast<float>(count), y = v * static_cast<float>(count);
  const bool turned = hash(static_cast<uint32_t>(x), static_cast<uint32_t>(y), seed) & 1;
  x = fraction(x), y = fraction(y);
  if (turned) x = 1 - x;
  return std::fmin(std::fabs(std::hypot(x, y) - 0.5f), std::fabs(std::hypot(1 - x, 1 - y) - 0.5f));
}

// ---- Looks ---------------------------------------------------------------------------------------------------------

struct Look {
  const char* name;
  uint32_t side;
  float depth;     // of the relief, in texture widths
  float metallic;  // where it is high
  float rough_low, rough_high;
  glm::vec3 low, high;  // colours as stored
  std::function<float(float, float)> height;
};

Finish add_look(Scene& s, const Look& look) {
  const uint32_t n = look.side;
  const float texel = 1.0f / static_cast<float>(n);
  std::vector<float> heights;
  heights.reserve(size_t{n} * n);
  for (uint32_t y = 0; y < n; ++y)
    for (uint32_t x = 0; x < n; ++x)
      heights.push_back(look.height((static_cast<float>(x) + 0.5f) * texel, (static_cast<float>(y) + 0.5f) * texel));
  const auto at = [&](uint32_t x, uint32_t y) { return heights[size_t{y % n} * n + x % n]; };
  const auto index = [n](float t) { return static_cast<uint32_t>(t * static_cast<float>(n)); };
  const std::string name = look.name;
  const float slope = look.depth * static_cast<float>(n) / 2;
  return {add_image(s, name + " colour", n,
                    [&](float u, float v) {
                      return glm::vec4(look.low + (look.high - look.low) * at(index(u), index(v)), 1);
                    }),
          add_image(s, name + " normal", n,
                    [&](float u, float v) {  // x to the right, y up the image
                      const uint32_t x = index(u), y = index(v);
                      const glm::vec3 up((at(x + n - 1, y) - at(x + 1, y)) * slope,
                                         (at(x, y + 1) - at(x, y + n - 1)) * slope, 1);
                      return glm::vec4(normalize(up) * 0.5f + 0.5f, 1);
                    }),
          add_image(s, name + " surface", n, [&](float u, float v) {
            const float h = at(index(u), index(v));
            return glm::vec4(mix(0.55f, 1, smooth(0, 0.6f, h)), mix(look.rough_low, look.rough_high, h),
                             look.metallic * smooth(0.3f, 0.5f, h), h);
          })};
}

void paint_solid(Scene& s, Looks& l) {
  l.stone = add_look(
      s, {"flagstones", 256, 0.02f, 0, 0.95f, 0.6f, {0.25f, 0.23f, 0.2f}, {0.74f, 0.71f, 0.66f}, [](float u, float v) {
            return masonry(u, v, 3, 4, 0.02f, 11);
          }});
  l.brick =
      add_look(s, {"brick", 256, 0.02f, 0, 1, 0.8f, {0.5f, 0.47f, 0.43f}, {0.68f, 0.4f, 0.31f}, [](float u, float v) {
                     return masonry(u, v, 4, 12, 0.012f, 23);
                   }});
  l.marble = add_look(
      s, {"marble", 256, 0.001f, 0, 0.35f, 0.2f, {0.45f, 0.44f, 0.46f}, {0.93f, 0.92f, 0.9f}, [](float u, float v) {
            return smooth(0, 0.12f, std::fabs(rough_noise(u, v, 4, 5, 31) - 0.5f));
          }});
  l.plaster = add_look(
      s, {"plaster", 128, 0.006f, 0, 0.95f, 0.85f, {0.72f, 0.69f, 0.63f}, {0.9f, 0.88f, 0.83f}, [](float u, float v) {
            return rough_noise(u, v, 8, 4, 41);
          }});
  l.wood = add_look(
      s, {"planks", 128, 0.012f, 0, 0.9f, 0.55f, {0.22f, 0.14f, 0.09f}, {0.62f, 0.45f, 0.3f}, [](float u, float v) {
            return planks(u, v, 53);
          }});
  l.metal = add_look(
      s, {"plates", 128, 0.008f, 1, 0.7f, 0.3f, {0.3f, 0.26f, 0.22f}, {0.8f, 0.79f, 0.78f}, [](float u, float v) {
            return plates(u, v, 61);
          }});
  l.rune =
      add_look(s, {"runes", 128, 0.02f, 0, 0.4f, 0.7f, {0.1f, 0.1f, 0.12f}, {0.36f, 0.36f, 0.4f}, [](float u, float v) {
                     return smooth(0.04f, 0.1f, winding(u, v, 4, 71)) * 0.8f + 0.2f * noise(u, v, 32, 72);
                   }});
}

void paint_soft(Scene& s, Looks& l) {
  l.moss =
      add_look(s, {"moss", 128, 0.03f, 0, 1, 0.85f, {0.12f, 0.17f, 0.06f}, {0.45f, 0.55f, 0.2f}, [](float u, float v) {
                     return rough_noise(u, v, 16, 4, 83);
                   }});
  l.sand = add_look(
      s, {"sand", 128, 0.02f, 0, 0.95f, 0.9f, {0.55f, 0.46f, 0.32f}, {0.86f, 0.77f, 0.6f}, [](float u, float v) {
            const float bend = rough_noise(u, v, 4, 2, 91);
            return 0.5f + 0.3f * std::sin(static_cast<float>(kTau) * (6 * v + bend)) +
                   0.2f * (noise(u, v, 64, 92) - 0.5f);
          }});
  l.fabric = add_look(s, {"fabric",
                          128,
                          0.004f,
                          0,
                          0.9f,
                          0.8f,
                          {0.5f, 0.5f, 0.5f},
                          {0.95f, 0.95f, 0.95f},
                          [](float u, float v) {  // damask: a figure raised from the weave
                            const float figure = std::sin(static_cast<float>(kTau) * 2 * u) *
                                                     std::sin(static_cast<float>(kTau) * 2 * v) +
                                                 0.4f * std::cos(static_cast<float>(kTau) * 4 * (u + v));
                            return 0.45f * smooth(-0.05f, 0.05f, figure) + 0.5f * weave_height(u, v);
                          }});
  l.skin =
      add_look(s, {"skin", 128, 0.02f, 0, 0.7f, 0.4f, {0.5f, 0.25f, 0.22f}, {0.85f, 0.6f, 0.53f}, [](float u, float v) {
                     return 0.7f * cells(u, v, 12, 101) + 0.3f * cells(u, v, 32, 103);
                   }});
}

// ---- Images with holes: alpha falls over two texels, the cut lies between -----------------------------------------

float cut(float inside) { return 0.5f + inside * 32; }
glm::vec4 fern(float u, float v) {
  const float spine = 0.5f + 0.04f * std::sin(v * 5), x = std::fabs(u - spine), reach = 0.46f * (0.15f + 0.85f * v);
  const float leaflet = 0.028f - std::fabs(fraction(v * 9 + x * 2.5f) - 0.5f) * 0.09f + 0.012f;
  const float inside = std::fmax(0.012f - x, std::fmin(leaflet, reach - x));
  return {0.16f + 0.2f * x, 0.42f + 0.15f * (1 - v), 0.1f, cut(inside)};
}
glm::vec4 blades(float u, float v) {
  float inside = -1;
  for (uint32_t i = 0; i < 9; ++i) {
    const float root = (static_cast<float>(i) + 0.5f) / 9, lean = (random(i, 0, 7) - 0.5f) * 0.3f;
    const float up = 1 - v, tall = 0.6f + 0.4f * random(i, 1, 7);
    if (up < tall) inside = std::fmax(inside, 0.035f * (1 - up / tall) - std::fabs(u - root - lean * up * up));
  }
  return {0.36f, 0.5f - 0.2f * v, 0.12f, cut(inside)};
}
glm::vec4 lattice(float u, float v) {
  const float a = std::fabs(fraction((u + v) * 5) - 0.5f), b = std::fabs(fraction((u - v) * 5 + 5) - 0.5f);
  return {0.42f, 0.3f, 0.2f, 0.5f + (std::fmax(a, b) - 0.38f) * 8};
}
glm::vec4 rings(float u, float v) {
  const float x = fraction(u * 6) - 0.5f, y = fraction(v * 6) - 0.5f;
  return {0.55f, 0.53f, 0.5f, 0.5f + (0.1f - std::fabs(std::hypot(x, y) - 0.42f)) * 8};
}

void paint_maps(Scene& s, Looks& l) {
  l.leaves = add_image(s, "leaves", 128, leaves);
  l.fern = add_image(s, "fern", 128, fern);
  l.blades = add_image(s, "blades", 128, blades);
  l.bars = add_image(s, "bars", 128, grille);
  l.lattice = add_image(s, "lattice", 128, lattice);
  l.rings = add_image(s, "rings", 128, rings);
  l.glow = add_image(s, "glow", 128, [](float u, float v) {
    return glm::vec4(glm::vec3(1 - smooth(0.03f, 0.09f, winding(u, v, 4, 71))), 1);
  });
  l.layer_mask = add_image(s, "layer mask", 256, [](float u, float v) {
    return glm::vec4(glm::vec3(smooth(0.35f, 0.65f, rough_noise(u, v, 4, 4, 111))), 1);
  });
  l.wet_mask = add_image(s, "wet mask", 256, [](float u, float v) {
    return glm::vec4(glm::vec3(smooth(0.4f, 0.55f, rough_noise(u, v, 3, 4, 121))), 1);
  });
  l.thickness =
      add_image(s, "thickness", 128, [](float u, float v) { return glm::vec4(glm::vec3(noise(u, v, 6, 131)), 1); });
  l.weave = add_image(s, "weave", 128,
                      [](float u, float v) { return glm::vec4(glm::vec3(0.5f + 0.5f * weave_height(u, v)), 1); });
  l.scan = add_image(s, "scan lines", 128, [](float u, float v) {
    const float line = 0.6f + 0.4f * std::sin(static_cast<float>(kTau) * 16 * v), grain = noise(u, v, 64, 141);
    return glm::vec4(line, line * mix(0.8f, 1, grain), mix(0.7f, 1, grain), 1);
  });
}

}  // namespace

Looks paint_looks(Scene& s) {
  Looks looks = {};
  paint_solid(s, looks);
  paint_soft(s, looks);
  paint_maps(s, looks);
  return looks;
}

}  // namespace assay::scene::builtin
