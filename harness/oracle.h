// For oracles and inputs: randomness, packed formats, wide arithmetic. Host only; shares nothing with shaders.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>

#include "harness/kernel.h"

namespace assay {

// O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms, 2014; the XSH-RR 64/32 member.
class Pcg32 {
 public:
  explicit Pcg32(uint64_t seed, uint64_t stream = 0x14057b7ef767814full) : increment_(stream << 1 | 1) {
    next();
    state_ += seed;
    next();
  }
  uint32_t next() {
    const uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto shifted = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
    return std::rotr(shifted, static_cast<int>(old >> 59));
  }
  uint32_t below(uint32_t n) { return static_cast<uint32_t>(uint64_t{next()} * n >> 32); }  // bias below n/2^32
  double unit() { return next() * 0x1p-32; }                                                // [0, 1)
  double range(double low, double high) { return low + (high - low) * unit(); }

 private:
  uint64_t state_ = 0, increment_;
};

class Random {
 public:
  explicit Random(uint64_t seed) : rng(seed), seed_(seed) {}
  uint64_t seed() const { return seed_; }
  // Takes one branch by weight and records it; returns its position.
  size_t branch(std::initializer_list<std::pair<const char*, double>> choices) {
    double total = 0;
    for (const auto& c : choices) total += c.second;
    double at = rng.range(0, total);
    size_t i = 0;
    for (const auto& c : choices) {
      if (at < c.second || i + 1 == choices.size()) {
        taken.insert(c.first);
        return i;
      }
      at -= c.second;
      ++i;
    }
    throw std::logic_error("a branch needs choices");
  }
  Pcg32 rng;
  std::set<std::string> taken;

 private:
  uint64_t seed_;
};

// An extent for a random case: a third are tiny (1 to 40 px a side), a third to a half span over 4 tiles of `tile`
// pixels a side, one in sixteen holds over 100,000 pixels; odd sizes prevail. Branches: extent_tiny, extent_middle,
// extent_tiles, extent_large.
Extent random_extent(Random&, uint32_t tile);
inline const std::vector<std::string> kExtentBranches = {"extent_tiny", "extent_middle", "extent_tiles",
                                                         "extent_large"};

// An oracle's answer for a port of which every element is live.
template <class T>
Expected expect_all(const std::vector<T>& elements) {
  const auto bytes = std::as_bytes(std::span(elements));
  return {.low = Bytes(bytes.begin(), bytes.end())};
}

// Distance in representable floats between two finite values of any sign; UINT64_MAX where either is NaN.
uint64_t ulp_distance(float a, float b);
constexpr double kUnitRoundoff = 0x1p-24;  // of float

}  // namespace assay
