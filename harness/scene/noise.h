// Value noise for the pictures of `default`, the same on every machine.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace assay::scene::builtin {

inline uint32_t hash(uint32_t x, uint32_t y, uint32_t seed) {
  uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return h ^ h >> 15;
}
inline float random(uint32_t x, uint32_t y, uint32_t seed) {
  return static_cast<float>(hash(x, y, seed) >> 8) * 0x1p-24f;
}
inline float fraction(float x) { return x - std::floor(x); }
inline float smooth(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}
inline float mix(float a, float b, float t) { return a + (b - a) * t; }

// Values on a lattice of `cells` a side, smoothly between: 0 to 1.
inline float noise(float u, float v, uint32_t cells, uint32_t seed) {
  const float x = u * static_cast<float>(cells), y = v * static_cast<float>(cells);
  const auto cx = static_cast<uint32_t>(x), cy = static_cast<uint32_t>(y);
  const float tx = smooth(0, 1, x - static_cast<float>(cx)), ty = smooth(0, 1, y - static_cast<float>(cy));
  const auto at = [&](uint32_t i, uint32_t j) { return random((cx + i) % cells, (cy + j) % cells, seed); };
  return mix(mix(at(0, 0), at(1, 0), tx), mix(at(0, 1), at(1, 1), tx), ty);
}
inline float rough_noise(float u, float v, uint32_t cells, uint32_t octaves, uint32_t seed) {
  float sum = 0, weight = 0.5f, all = 0;
  for (uint32_t i = 0; i < octaves; ++i, cells *= 2, weight *= 0.5f)
    sum += weight * noise(u, v, cells, seed + i), all += weight;
  return sum / all;
}

}  // namespace assay::scene::builtin
