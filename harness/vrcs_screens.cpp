#include "harness/vrcs_screens.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace assay::vrcs {

const std::vector<std::string> kRateBranches = {"rates_of_one_kind", "rates_in_blocks", "rates_by_cell",
                                                "rates_unknown"};
const std::vector<std::string> kScreenBranches = {"covered_by_none", "covered_by_one",    "covered_by_noise",
                                                  "covered_by_few",  "covered_by_meshes", "rates_of_one_kind",
                                                  "rates_in_blocks", "rates_by_cell",     "rates_unknown"};

Pictured empty_screen(Extent e) {
  return {e, std::vector<uvec2>(pixel_count(e), uvec2(kVisibilityNone)), std::vector<float>(pixel_count(e)),
          std::vector<uint>(pixel_count(e)), std::vector<uint8_t>(pixel_count(cells_of(e)))};
}

Pictured of_primaries(Extent e, uint more_than_192) {
  return drawn(e, kRate2x2, [=](uint x, uint y) {
    const uint cell = y % 16 / 2 * 8 + x % 16 / 2, i = y % 2 * 2 + x % 2;
    return uvec2(i == 3 && cell >= more_than_192 ? 0 : i, 1);
  });
}

uint focal_of(Extent e) { return std::clamp(e.width / 2, 1u, 16383u); }

namespace {

uint octahedral(glm::dvec3 n) {
  n /= std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
  const auto sign = [](double v) { return v < 0 ? -1.0 : 1.0; };
  if (n.z < 0) {
    const glm::dvec3 up = n;
    n.x = (1 - std::fabs(up.y)) * sign(up.x), n.y = (1 - std::fabs(up.x)) * sign(up.y);
  }
  const auto code = [](double v) { return static_cast<uint16_t>(static_cast<int16_t>(std::lround(v * 32767))); };
  return code(n.x) | uint{code(n.y)} << 16;
}

// A surface over a box of the screen, of squares of `side` pixels cut into two triangles each. Reversed depth over it
// is `at`, with slopes a pixel, and bumps between the squares' corners.
struct Mesh {
  uint left, top, right, bottom, side, surface;
  double at, slope_x, slope_y, bump;
};

double corner_depth(const Mesh& m, uint column, uint row) {
  const uint x = column * m.side, y = row * m.side;  // from the mesh's corner on
  Pcg32 rng(column * 7919ull + row, m.surface);
  return m.at + m.slope_x * x + m.slope_y * y + m.bump * m.at * rng.range(-1, 1);
}

void cover_pixel(Pictured& s, const Mesh& m, uint x, uint y) {
  const uint column = (x - m.left) / m.side, row = (y - m.top) / m.side;
  const double u = (x - m.left) % m.side + 0.5, v = (y - m.top) % m.side + 0.5;
  const bool lower = u + v > m.side;
  const double across = corner_depth(m, column + 1, row), down = corner_depth(m, column, row + 1);
  const double corner = lower ? corner_depth(m, column + 1, row + 1) : corner_depth(m, column, row);
  const double gx = (lower ? corner - down : across - corner) / m.side;
  const double gy = (lower ? corner - across : down - corner) / m.side;
  const double d = std::max(lower ? down + gx * u + gy * (v - m.side) : corner + gx * u + gy * v, 1e-6);
  const uint squares = (m.right - m.left) / m.side + 1;
  s.cover(x, y, {(row * squares + column) * 2 + lower, m.surface}, static_cast<float>(d));
  const double focal = focal_of(s.extent), middle_x = s.extent.width / 2.0, middle_y = s.extent.height / 2.0;
  s.face_normals[s.place(x, y)] =
      octahedral({gx * focal, gy * focal, d - gx * (x + 0.5 - middle_x) - gy * (y + 0.5 - middle_y)});
}

void add_mesh(Pictured& s, const Mesh& m) {
  for (uint y = m.top; y < m.bottom; ++y)
    for (uint x = m.left; x < m.right; ++x) cover_pixel(s, m, x, y);
}

void add_meshes(Pictured& s, Pcg32& rng, uint count) {
  const Extent e = s.extent;
  for (uint i = 0; i < count; ++i) {
    const uint left = rng.below(e.width), top = rng.below(e.height);
    const uint right = left + 1 + rng.below(std::min(e.width - left, e.width / 3 + 8));
    const uint bottom = top + 1 + rng.below(std::min(e.height - top, e.height / 3 + 8));
    const double at = std::pow(10, rng.range(-3.5, -1));
    const double slope_x = at * rng.range(-0.3, 0.3) / (right - left);
    const double slope_y = at * rng.range(-0.3, 0.3) / (bottom - top);
    const double bump = rng.below(3) == 0 ? 0 : std::pow(10, rng.range(-5, -2));
    add_mesh(s, {left, top, std::min(right, e.width), std::min(bottom, e.height), 4 + rng.below(36), i + 1, at, slope_x,
                 slope_y, bump});
  }
}

constexpr uint8_t kRates[] = {kRate1x1, kRate1x2, kRate2x1, kRate2x2};
uint8_t some_rate(Pcg32& rng) {
  constexpr uint8_t kShares[] = {0, 0, 0, 1, 1, 2, 3, 3, 3, 3};
  return kRates[kShares[rng.below(10)]];
}

}  // namespace

std::vector<uint8_t> rates_in_blocks(Extent e, Pcg32& rng, uint side) {
  const Extent cells = cells_of(e), blocks = tiles_of(cells, side);
  std::vector<uint8_t> of_block(pixel_count(blocks)), rates;
  for (uint8_t& rate : of_block) rate = some_rate(rng);
  for (uint y = 0; y < cells.height; ++y)
    for (uint x = 0; x < cells.width; ++x) rates.push_back(of_block[size_t{y / side} * blocks.width + x / side]);
  return rates;
}

std::vector<uint8_t> random_rates(Random& r, Extent e) {
  std::vector<uint8_t> rates(pixel_count(cells_of(e)));
  switch (r.branch(
      {{"rates_of_one_kind", 0.25}, {"rates_in_blocks", 0.35}, {"rates_by_cell", 0.25}, {"rates_unknown", 0.15}})) {
    case 0:
      std::ranges::fill(rates, kRates[r.rng.below(4)]);
      break;
    case 1:
      rates = rates_in_blocks(e, r.rng, 1u << r.rng.below(6));
      break;
    case 2:
      for (uint8_t& rate : rates) rate = some_rate(r.rng);
      break;
    default:
      for (uint8_t& rate : rates) rate = static_cast<uint8_t>(r.rng.next() >> r.rng.below(4) * 8);
  }
  return rates;
}

Pictured typical_screen(Extent e) {
  Pictured s = empty_screen(e);
  Pcg32 rng(0x52c5);
  const uint horizon = e.height / 3;
  add_mesh(s, {0, horizon, e.width, e.height, 24, 0, 1e-3, 0, 0.03 / (e.height - horizon), 1e-4});
  add_meshes(s, rng, 30);
  s.rates = rates_in_blocks(e, rng, 4);
  return s;
}

Pictured uneven_screen(Extent e, uint side) {
  Pictured s = empty_screen(e);
  add_mesh(s, {0, 0, e.width, e.height, side, 0, 1e-3, 0, 0.01 / e.height, 1e-4});
  std::ranges::fill(s.rates, kRate2x2);
  return s;
}

Pictured random_screen(Random& r, Extent e) {
  Pictured s = empty_screen(e);
  const auto any_of = [&](uint triangles) { return uvec2(r.rng.below(triangles), r.rng.below(2)); };
  switch (r.branch({{"covered_by_none", 0.05},
                    {"covered_by_one", 0.1},
                    {"covered_by_noise", 0.15},
                    {"covered_by_few", 0.3},
                    {"covered_by_meshes", 0.4}})) {
    case 0:
      break;
    case 1:
      for (uint y = 0; y < e.height; ++y)
        for (uint x = 0; x < e.width; ++x) s.cover(x, y, {7, 3});
      break;
    case 2:
      for (uint y = 0; y < e.height; ++y)
        for (uint x = 0; x < e.width; ++x) s.cover(x, y, any_of(1u << 20), static_cast<float>(r.rng.unit()));
      break;
    case 3: {  // several partitions of every cell, and holes
      const uint one_in = 1 + r.rng.below(6), triangles = 1 + r.rng.below(3);
      for (uint y = 0; y < e.height; ++y)
        for (uint x = 0; x < e.width; ++x)
          if (r.rng.below(one_in + 1) != 0)
            s.cover(x, y, any_of(triangles), 0.01f + 0.001f * static_cast<float>(x % 3));
      break;
    }
    default:
      add_meshes(s, r.rng, 1 + r.rng.below(12));
  }
  s.rates = random_rates(r, e);
  return s;
}

}  // namespace assay::vrcs
