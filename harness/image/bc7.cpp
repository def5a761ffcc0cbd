// Khronos Data Format Specification 1.3, BPTC Compressed Texture Image Formats, mode 6.
#include "harness/image/bc7.h"

#include <algorithm>
#include <cmath>

namespace assay::image {

namespace {

constexpr std::array<int, 16> kWeights = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};  // of 64
constexpr int kRefinements = 3;
constexpr std::array<float, 4> kRankWeights = {16, 16, 16, 48};  // of squared errors; coverage moves three colours

using Vector = std::array<float, 4>;
struct Ends {
  std::array<std::array<int, 4>, 2> codes = {};  // 8 bits; the lowest is shared by an end's channels
};
struct Encoding {
  Ends ends;
  std::array<uint8_t, 16> indices = {};
  int error = 0x7fffffff;
};

// Each texel to the nearest of the sixteen steps, by what the decoder makes of them. In floats, which hold every number
// here (below 2^24) and which the compiler makes four at a time of.
Encoding indexed(const BlockTexels& texels, const Ends& e) {
  std::array<std::array<float, 16>, 4> steps;
  for (size_t c = 0; c < 4; ++c)
    for (size_t k = 0; k < 16; ++k)
      steps[c][k] = static_cast<float>(((64 - kWeights[k]) * e.codes[0][c] + kWeights[k] * e.codes[1][c] + 32) >> 6);
  Encoding found = {e, {}, 0};
  for (size_t i = 0; i < 16; ++i) {
    // Sixteen times the error and the step: the least of both is the first where two are equal.
    std::array<float, 16> ranks = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    for (size_t c = 0; c < 4; ++c) {
      const auto code = static_cast<float>(texels[i][c]);
      for (size_t k = 0; k < 16; ++k) ranks[k] += kRankWeights[c] * ((steps[c][k] - code) * (steps[c][k] - code));
    }
    for (size_t half = 8; half > 0; half /= 2)
      for (size_t k = 0; k < half; ++k) ranks[k] = ranks[k + half] < ranks[k] ? ranks[k + half] : ranks[k];
    const auto least = static_cast<int>(ranks[0]);
    found.indices[i] = static_cast<uint8_t>(least & 15);
    found.error += least >> 4;
  }
  return found;
}

int nearest_code(float v, int lowest) {
  const int high = std::clamp(static_cast<int>(std::floor((v - static_cast<float>(lowest)) / 2 + 0.5f)), 0, 127);
  return high << 1 | lowest;
}

// The best over the ends' lowest bits; 1 and 1 first, so that what is opaque stays so where there is a choice.
void improve(Encoding& best, const BlockTexels& texels, const Vector& first, const Vector& second) {
  for (const auto& lowest : {std::array{1, 1}, {0, 1}, {1, 0}, {0, 0}}) {
    Ends e;
    for (size_t c = 0; c < 4; ++c)
      e.codes[0][c] = nearest_code(first[c], lowest[0]), e.codes[1][c] = nearest_code(second[c], lowest[1]);
    const Encoding tried = indexed(texels, e);
    if (tried.error < best.error) best = tried;
  }
}

struct Line {
  Vector mean = {}, axis = {};  // unit, or 0 where all texels are equal
};
// The principal axis: the covariance's largest eigenvector, by repeated multiplication.
Line line_through(const BlockTexels& texels) {
  Line l;
  for (const auto& t : texels)
    for (size_t c = 0; c < 4; ++c) l.mean[c] += static_cast<float>(t[c]) / 16;
  std::array<Vector, 4> covariance = {};
  for (const auto& t : texels)
    for (size_t a = 0; a < 4; ++a)
      for (size_t b = 0; b < 4; ++b)
        covariance[a][b] += (static_cast<float>(t[a]) - l.mean[a]) * (static_cast<float>(t[b]) - l.mean[b]);
  size_t widest = 0;
  for (size_t c = 1; c < 4; ++c)
    if (covariance[c][c] > covariance[widest][widest]) widest = c;
  Vector v = covariance[widest];
  for (int turn = 0; turn < 8; ++turn) {
    const float size = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2]), std::fabs(v[3])});
    if (!(size > 0)) return l;
    Vector next = {};
    for (size_t a = 0; a < 4; ++a)
      for (size_t b = 0; b < 4; ++b) next[a] += covariance[a][b] * (v[b] / size);
    v = next;
  }
  const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
  if (length > 0)
    for (size_t c = 0; c < 4; ++c) l.axis[c] = v[c] / length;
  return l;
}

void improve_along(Encoding& best, const BlockTexels& texels, const Line& l) {
  float low = 0, high = 0;
  for (const auto& t : texels) {
    float along = 0;
    for (size_t c = 0; c < 4; ++c) along += (static_cast<float>(t[c]) - l.mean[c]) * l.axis[c];
    low = std::min(low, along), high = std::max(high, along);
  }
  Vector first, second;
  for (size_t c = 0; c < 4; ++c) first[c] = l.mean[c] + low * l.axis[c], second[c] = l.mean[c] + high * l.axis[c];
  improve(best, texels, first, second);
}

// The ends of least squared error for the indices as they are: sum of (1-w)^2, w(1-w), w^2 against the texels' sums.
// False where all texels have one index.
bool improve_ends(Encoding& best, const BlockTexels& texels) {
  float aa = 0, ab = 0, bb = 0;
  Vector a_texels = {}, b_texels = {};
  for (size_t i = 0; i < 16; ++i) {
    const float b = static_cast<float>(kWeights[best.indices[i]]) / 64, a = 1 - b;
    aa += a * a, ab += a * b, bb += b * b;
    for (size_t c = 0; c < 4; ++c)
      a_texels[c] += a * static_cast<float>(texels[i][c]), b_texels[c] += b * static_cast<float>(texels[i][c]);
  }
  const float determinant = aa * bb - ab * ab;
  if (!(determinant > 1e-3f)) return false;
  Vector first, second;
  for (size_t c = 0; c < 4; ++c) {
    first[c] = (bb * a_texels[c] - ab * b_texels[c]) / determinant;
    second[c] = (aa * b_texels[c] - ab * a_texels[c]) / determinant;
  }
  const int before = best.error;
  improve(best, texels, first, second);
  return best.error < before;
}

// One colour: with lowest bits 0 and 1, step 5 or 10 (21 and 43 of 64) makes of every code an even and an odd end that
// meet it. Of 0 only the former, of 255 only the latter.
void improve_single(Encoding& best, const BlockTexels& texels) {
  for (const size_t step : {size_t{5}, size_t{10}}) {
    Ends e;
    for (size_t c = 0; c < 4; ++c) {
      int least = 0x7fffffff;
      for (int even = std::max(texels[0][c] - 4, 0) & ~1; even <= std::min(texels[0][c] + 4, 254); even += 2)
        for (int odd = std::max(texels[0][c] - 4, 0) | 1; odd <= std::min(texels[0][c] + 4, 255); odd += 2) {
          const int got = ((64 - kWeights[step]) * even + kWeights[step] * odd + 32) >> 6;
          if (const int off = std::abs(got - texels[0][c]); off < least)
            least = off, e.codes[0][c] = even, e.codes[1][c] = odd;
        }
    }
    const Encoding tried = indexed(texels, e);
    if (tried.error < best.error) best = tried;
  }
}

// The first texel's highest bit is not stored, and 0: ends and indices are turned about where it is not.
void anchor(Encoding& e) {
  if (e.indices[0] < 8) return;
  std::swap(e.ends.codes[0], e.ends.codes[1]);
  for (uint8_t& i : e.indices) i = static_cast<uint8_t>(15 - i);
}

struct Bits {
  std::array<std::byte, 16> bytes = {};
  uint32_t at = 0;
  void put(uint32_t value, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i, ++at) bytes[at / 8] |= static_cast<std::byte>((value >> i & 1) << at % 8);
  }
};

}  // namespace

std::array<std::byte, 16> bc7_block(const BlockTexels& texels) {
  Encoding best;
  const Line l = line_through(texels);
  improve_along(best, texels, l);
  for (int i = 0; i < kRefinements && best.error > 0; ++i)
    if (!improve_ends(best, texels)) break;
  if (best.error > 0 && std::ranges::all_of(texels, [&](const auto& t) { return t == texels[0]; }))
    improve_single(best, texels);
  anchor(best);
  Bits bits;
  bits.put(1u << 6, 7);
  const auto code = [&](size_t end, size_t c) { return static_cast<uint32_t>(best.ends.codes[end][c]); };
  for (size_t c = 0; c < 4; ++c)
    for (size_t end = 0; end < 2; ++end) bits.put(code(end, c) >> 1, 7);
  for (size_t end = 0; end < 2; ++end) bits.put(code(end, 0) & 1, 1);
  for (size_t i = 0; i < 16; ++i) bits.put(best.indices[i], i == 0 ? 3 : 4);
  return bits.bytes;
}

}  // namespace assay::image
