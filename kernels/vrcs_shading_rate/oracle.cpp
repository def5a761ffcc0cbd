#include "kernels/vrcs_shading_rate/oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace assay::vrcs_shading_rate {

namespace {

// What a device's threshold and its comparison may be off by together (README, Bounds).
constexpr double kRoom = 0x1p-17;

enum class Passes { no, maybe, yes };

Passes passes(double error, double most) {
  if (error * (1 + kRoom) <= most) return Passes::yes;
  return error <= most * (1 + kRoom) ? Passes::maybe : Passes::no;  // a NaN passes nothing
}

template <class Visit>
void each(Passes p, const Visit& visit) {
  if (p != Passes::yes) visit(false);
  if (p != Passes::no) visit(true);
}

uint32_t half_rate(const Errors& e, bool across, bool down) {
  if (across && down) return e.across <= e.down ? kRate2x1 : kRate1x2;
  return across ? kRate2x1 : down ? kRate1x2 : kRate1x1;
}

using Rates = std::set<uint32_t>;

Rates rates_within(const Errors& e, const RateParams& p, double most) {
  Rates found;
  const Passes both = passes(e.both * p.quarter_weight, most), across = passes(e.across * p.half_weight, most),
               down = passes(e.down * p.half_weight, most);
  each(both, [&](bool quarter) {
    if (quarter) {
      found.insert(kRate2x2);
      return;
    }
    each(across, [&](bool a) { each(down, [&](bool d) { found.insert(half_rate(e, a, d)); }); });
  });
  return found;
}

Rates rates_of(const Errors& e, const RateParams& p, double tolerance) {
  const double base = (p.flags & kWeber) != 0 ? e.mean + double{p.ambient} * 255 : 255, most = tolerance * base;
  Rates found = rates_within(e, p, most * most);
  if (!(p.extra_half > 0 && p.extra_half < 1) || found.erase(kRate2x2) == 0) return found;
  const double less = most * p.extra_half;
  for (const uint32_t again : rates_within(e, p, less * less))
    found.insert(again == kRate1x1 ? half_rate(e, true, true) : again);
  return found;
}

double gain_of_place(const RateParams& p, uint32_t side, uint32_t column, uint32_t row) {
  const double x = column * side + side / 2, y = row * side + side / 2;
  const double across = 2 * x / p.width - 1, down = 2 * y / p.height - 1;
  const double gain = 1 + double{p.foveation} * (across * across + down * down) / 2;
  const double from_side = std::max(0.0, std::min({x, y, p.width - x, p.height - y}));
  return from_side < p.border ? gain * p.border_gain : gain;
}

uint32_t area(uint32_t rate) { return 1u << (rate >> 2) << (rate & 3); }

Rates rates_of_tile(Estimator estimator, const Case& c, uint32_t side, uint32_t column, uint32_t row) {
  const auto p = c.params<RateParams>();
  if ((p.flags & kAllFull) != 0) return {kRate1x1};
  const auto luma = c.input<uint8_t>("luma");
  const double tolerance = p.tolerance * gain_of_place(p, side, column, row);
  Rates of[2], found;
  for (size_t i = 0; i < 2; ++i) {
    const Codes codes = [&](int64_t x, int64_t y) { return luma[static_cast<size_t>(y * p.width + x) * 2 + i]; };
    of[i] = rates_of(errors_of(estimator, c.extent, side, column, row, codes), p, tolerance);
  }
  for (const uint32_t opaque : of[0])
    for (const uint32_t blended : of[1]) found.insert(area(blended) > area(opaque) ? blended : opaque);
  return found;
}

Expected rates_of_picture(Estimator estimator, const Case& c, uint32_t side) {
  const Extent cells = cells_of(c.extent), tiles = tiles_of(c.extent, side);
  std::vector<Rates> of_tile(pixel_count(tiles));
  for (uint32_t y = 0; y < tiles.height; ++y)
    for (uint32_t x = 0; x < tiles.width; ++x)
      of_tile[size_t{y} * tiles.width + x] = rates_of_tile(estimator, c, side, x, y);
  std::vector<uint32_t> all;
  Expected e;
  e.first.push_back(0);
  for (uint32_t y = 0; y < cells.height; ++y)
    for (uint32_t x = 0; x < cells.width; ++x) {
      const Rates& rates = of_tile[size_t{y / (side / 2)} * tiles.width + x / (side / 2)];
      all.insert(all.end(), rates.begin(), rates.end());
      e.first.push_back(static_cast<uint32_t>(all.size()));
    }
  const auto bytes = std::as_bytes(std::span(all));
  e.low.assign(bytes.begin(), bytes.end());
  e.high = e.low;
  return e;
}

}  // namespace

const char* name_of(Estimator e) {
  constexpr const char* kNames[] = {"sobel", "first_difference", "second_difference", "second_and_slope"};
  return kNames[static_cast<int>(e)];
}

Errors errors_of(Estimator estimator, Extent picture, uint32_t side, uint32_t column, uint32_t row,
                 const Codes& codes) {
  const int64_t width = picture.width, height = picture.height;
  const auto inside = [](int64_t i, int64_t n) {
    if (i < 0) i = -i;
    if (i >= n) i = 2 * (n - 1) - i;
    return std::clamp<int64_t>(i, 0, n - 1);
  };
  const auto square = [](double v) { return v * v; };
  double pixels = 0;
  Errors e, slope;
  const int64_t left = int64_t{column} * side, top = int64_t{row} * side;
  for (int64_t y = top; y < std::min(top + side, height); ++y)
    for (int64_t x = left; x < std::min(left + side, width); ++x) {
      const auto at = [&](int64_t dx, int64_t dy) -> double {
        return codes(inside(x + dx, width), inside(y + dy, height));
      };
      const double here = at(0, 0), diagonals = at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1);
      pixels += 1, e.mean += here;
      if (estimator == Estimator::sobel) {
        const double across = at(1, -1) + 2 * at(1, 0) + at(1, 1) - at(-1, -1) - 2 * at(-1, 0) - at(-1, 1);
        const double down = at(-1, 1) + 2 * at(0, 1) + at(1, 1) - at(-1, -1) - 2 * at(0, -1) - at(1, -1);
        e.across = std::max(e.across, square(across / 8)), e.down = std::max(e.down, square(down / 8));
        continue;
      }
      slope.across += square(at(1, 0) - here), slope.down += square(at(0, 1) - here);
      slope.both += square(at(1, 1) - here);  // the diagonal alone as yet
      e.across += square((at(-1, 0) - 2 * here + at(1, 0)) / 2);
      e.down += square((at(0, -1) - 2 * here + at(0, 1)) / 2);
      e.both += square(here - diagonals / 4);
    }
  e.mean /= pixels;
  if (estimator == Estimator::sobel) {
    e.both = std::max(e.across, e.down);
    return e;
  }
  for (Errors* part : {&e, &slope}) {
    part->both += part->across + part->down;
    part->across /= pixels, part->down /= pixels, part->both /= pixels;
  }
  slope.mean = e.mean;
  if (estimator == Estimator::first_difference) return slope;
  if (estimator == Estimator::second_and_slope) {  // of slopes an eighth, squared
    e.across = std::max(e.across, slope.across / 64), e.down = std::max(e.down, slope.down / 64);
    e.both = std::max(e.both, slope.both / 64);
  }
  return e;
}

Answer rates(const Case& c) {
  Answer answer;
  for (const Estimator e :
       {Estimator::sobel, Estimator::first_difference, Estimator::second_difference, Estimator::second_and_slope})
    for (const uint32_t side : {2u, 8u}) answer[fmt::format("{}_{}", name_of(e), side)] = rates_of_picture(e, c, side);
  return answer;
}

}  // namespace assay::vrcs_shading_rate
