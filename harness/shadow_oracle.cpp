#include "harness/shadow_oracle.h"

#include <algorithm>
#include <vector>

namespace assay::shadowing {

namespace {

using glm::dvec3;

constexpr Interval kLit = {1, 1}, kAny = {0, 1};
// Products of three numbers up to here are floats; of larger ones, what comes out is left open.
constexpr double kLarge = 1e9;
constexpr double kLeastRay = 1e-36;        // squared; views of less have no slope
constexpr double kLeastNormal = 0x1p-126;  // a device may take what is less for 0

bool finite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
double largest(const dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

struct Row {
  dvec3 turn;
  double move;
  explicit Row(const vec4& v) : turn(v.x, v.y, v.z), move(v.w) {}
  bool is_finite() const { return finite(turn) && std::isfinite(move); }
  bool is_nan() const { return glm::any(glm::isnan(turn)) || std::isnan(move); }
  Interval at(const Ball& p) const { return dot({turn, 0}, p) + exactly(move); }
};

struct Rows {
  Row x, y, z, w;
  explicit Rows(const ShadowView& v) : x(v.clip_x), y(v.clip_y), z(v.clip_z), w(v.clip_w) {}
  bool are_finite() const { return x.is_finite() && y.is_finite() && z.is_finite() && w.is_finite(); }
  double largest() const {
    double most = 0;
    for (const Row* r : {&x, &y, &z, &w}) most = std::max({most, shadowing::largest(r->turn), std::fabs(r->move)});
    return most;
  }
};

struct Point {
  Interval x, y, depth;  // x and y in [-1, 1] over the tile
};

// row - value * w's row: how x, y or depth change with the position, but for 1 / w.
Ball change_of(const Row& row, Interval value, const Row& w) {
  const double middle = 0.5 * (value.low + value.high), away = 0.5 * (value.high - value.low);
  const dvec3 at = row.turn - middle * w.turn;
  const double product = std::max(std::fabs(value.low), std::fabs(value.high)) * glm::length(w.turn);
  const double moved = away * glm::length(w.turn) + bounded::u * product;
  return {at, (moved + bounded::u * (glm::length(at) + moved)) * bounded::kSlack};
}

// facing / max(facing^2, least): 1 / facing, but where facing^2 is below least; there it falls to 0.
Interval held_inverse(Interval facing, Interval least) {
  const auto of = [](double f, double l) { return f == 0 ? 0 : f / std::max(f * f, l); };
  Interval all = {bounded::kInfinite, -bounded::kInfinite};
  for (const double l : {std::max(least.low, kLeastRay), std::max(least.high, kLeastRay)}) {
    for (const double f : {facing.low, facing.high}) all = hull(all, exactly(of(f, l)));
    for (const double peak : {-std::sqrt(l), std::sqrt(l)})
      if (facing.low < peak && peak < facing.high) all = hull(all, exactly(1 / peak));
  }
  return bounded::rounded(all, 7);
}

struct Slope {
  Interval x, y;  // of depth, a texel
};

Slope slope_of(const Rows& rows, const Point& p, const Ball& normal, double half_side) {
  const Ball a = change_of(rows.x, p.x, rows.w), b = change_of(rows.y, p.y, rows.w),
             c = change_of(rows.z, p.depth, rows.w);
  const Ball ray = cross(a, b);
  const Interval least = exactly(kLeastShadowFacing * kLeastShadowFacing) * length_squared(ray);
  const Interval inverse = held_inverse(dot(normal, ray), least);
  const auto along = [&](const Ball& change) { return dot(normal, change) * inverse / exactly(half_side); };
  return {along(cross(c, b)), along(cross(a, c))};
}

// A tile's filter at a receiver.
struct Lookup {
  const Map& map;
  ShadowTile tile;
  int taps;
  Interval x, y;  // texels from the tile's corner
  Slope slope;
  Interval depth;  // at (x, y), with all room that it is given
};

Interval depth_at(const Lookup& l, int column, int row) {
  const Interval across = exactly(column + 0.5) - l.x, down = exactly(row + 0.5) - l.y;
  return sum_of({l.depth, l.slope.x * across, l.slope.y * down});
}

// Of the i-th of the taps: 1 - part, 1, ..., 1, part.
Interval weight_of(int i, int taps, Interval part) {
  return i == 0 ? exactly(1) - part : i == taps - 1 ? part : exactly(1);
}

// The share where the filter's first tap is this one.
Interval filtered(const Lookup& l, int first_column, int first_row) {
  const double rim = 0.5 * (l.taps - 1);
  const auto part_of = [&](Interval at, int first) { return clamped(at - exactly(rim) - exactly(first), 0, 1); };
  const Interval part_x = part_of(l.x, first_column), part_y = part_of(l.y, first_row);
  const int last = static_cast<int>(l.tile.side) - 1;
  Interval dark;
  for (int j = 0; j < l.taps; ++j)
    for (int i = 0; i < l.taps; ++i) {
      const int column = std::clamp(first_column + i, 0, last), row = std::clamp(first_row + j, 0, last);
      const double stored = l.map.depths[(l.tile.y + static_cast<size_t>(row)) * l.map.extent.width + l.tile.x +
                                         static_cast<size_t>(column)];
      if (!(stored > 0)) continue;
      const Interval depth = depth_at(l, column, row);
      const Interval weight = weight_of(i, l.taps, part_x) * weight_of(j, l.taps, part_y);
      if (stored > depth.high && stored >= kLeastNormal) dark.low += weight.low;
      if (stored > depth.low) dark.high += weight.high;
    }
  if (dark.high == 0) return kLit;
  const double all = (l.taps - 1) * (l.taps - 1);
  dark = bounded::rounded(dark, l.taps * l.taps);
  return clamped(exactly(1) - dark / exactly(all), 0, 1);
}

bool is_in_atlas(const ShadowTile& t, Extent e) {
  return t.side != 0 && uint64_t{t.x} + t.side <= e.width && uint64_t{t.y} + t.side <= e.height;
}

Interval seen_share(const Map& map, int taps, const ShadowView& view, const Rows& rows, const Point& p,
                    const Ball& normal, bool is_linear) {
  const double half_side = 0.5 * view.tile.side;
  const Slope slope = slope_of(rows, p, normal, half_side);
  const Interval steep = absolute(slope.x) + absolute(slope.y);
  const Interval bias = exactly(std::clamp(double{view.bias}, -1e30, 1e30));
  const Interval moved = bias * ((is_linear ? exactly(1) : p.depth) + steep * exactly(half_side));
  const auto texel = [&](Interval at) { return (at + exactly(1)) * exactly(half_side); };
  const Lookup l = {.map = map,
                    .tile = view.tile,
                    .taps = taps,
                    .x = texel(p.x),
                    .y = texel(p.y),
                    .slope = slope,
                    .depth = p.depth + moved + steep * exactly((taps + 1) * double{kShadowSnap})};
  const double rim = 0.5 * (taps - 1);
  const auto first = [&](double at) { return static_cast<int>(std::floor(at)); };
  const Interval across = l.x - exactly(rim), down = l.y - exactly(rim);
  if (across.high - across.low > 1 || down.high - down.low > 1) return kAny;
  Interval all = {1, 0};
  for (int row = first(down.low); row <= first(down.high); ++row)
    for (int column = first(across.low); column <= first(across.high); ++column)
      all = hull(all, filtered(l, column, row));
  return all;
}

Interval share_in_view(const Map& map, int taps, const ShadowView& view, const Ball& position, const Ball& normal,
                       bool is_linear) {
  const Rows rows(view);
  if (!is_in_atlas(view.tile, map.extent) || !rows.are_finite() || std::isnan(view.bias) || !finite(normal.value))
    return kLit;
  if (std::isinf(view.bias)) return kAny;  // times a depth of 0 it is no number, which lights
  if (std::max({rows.largest(), reach(position), reach(normal)}) > kLarge) return kAny;
  const Interval x = rows.x.at(position), y = rows.y.at(position), z = rows.z.at(position), w = rows.w.at(position);
  // What the quotients may be off by.
  constexpr double kOver = 1 + 8 * bounded::u;
  const auto is_outside = [&](Interval i) { return absolute(i).low > kMostShadowOutside * kOver * w.high; };
  if (!(w.high > 0) || is_outside(x) || is_outside(y) || z.low > kOver * w.high) return kLit;
  if (!(w.low > 0)) return kAny;
  const Point p = {x / w, y / w, z / w};
  const Interval share = seen_share(map, taps, view, rows, {p.x, p.y, at_least(p.depth, 0)}, normal, is_linear);
  const bool is_inside =
      absolute(p.x).high <= kMostShadowOutside && absolute(p.y).high <= kMostShadowOutside && p.depth.high < 1;
  return is_inside ? share : hull(share, kLit);
}

// Whether a cascade holds a position.
struct Held {
  bool may, must;
};
Held held_by(const ShadowView& view, int taps, const Ball& position, float dither) {
  const Rows rows(view);
  const double side = view.tile.side;
  if (std::isnan(dither) || rows.x.is_nan() || rows.y.is_nan() || side == 0) return {false, false};
  // An infinite place is within an infinite rim, if it is a number; otherwise within none.
  const bool is_known = rows.x.is_finite() && rows.y.is_finite(), is_endless = std::isinf(dither) && dither < 0;
  if (!is_known || std::isinf(dither)) return {is_endless, is_endless && is_known};
  const Interval rim = exactly(side) - exactly(side) * (exactly(kCascadeBand) * exactly(dither)) - exactly(taps - 1);
  const auto away = [&](const Row& row) { return absolute(row.at(position)) * exactly(side); };
  const Interval x = away(rows.x), y = away(rows.y);
  return {x.low <= rim.high && y.low <= rim.high, x.high <= rim.low && y.high <= rim.low};
}

// The faces that the longest axis of a direction may name. Where it is no number, NaN is no axis but the last.
std::vector<uint32_t> faces_of(const Ball& direction) {
  const dvec3 v = direction.value, size = glm::abs(v);
  std::vector<uint32_t> faces;
  const auto face = [](int axis, bool is_negative) { return static_cast<uint32_t>(2 * axis) + (is_negative ? 1 : 0); };
  if (!finite(v)) {
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return {face(axis, v[axis] < 0)};
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] + 2 * direction.error < largest(v)) continue;
    if (v[axis] + direction.error >= 0) faces.push_back(face(axis, false));
    if (v[axis] - direction.error <= 0) faces.push_back(face(axis, true));
  }
  return faces;
}

Interval directional_share(const Map& map, int taps, std::span<const ShadowView> cascades, const Ball& position,
                           const Ball& normal, float dither) {
  Interval all = {1, 0};  // none yet
  for (const ShadowView& cascade : cascades) {
    const Held held = held_by(cascade, taps, position, dither);
    if (held.may) all = hull(all, share_in_view(map, taps, cascade, position, normal, true));
    if (held.must) return all;
  }
  return hull(all, kLit);
}

}  // namespace

Interval share_of(const Map& map, uint32_t taps, const LightRecord& light, const Ball& position, const Ball& normal,
                  float dither) {
  const auto side = static_cast<int>(taps);
  const auto from = map.views.subspan(std::min<size_t>(light.first_view, map.views.size()));
  const auto views = from.first(std::min<size_t>(light.views, from.size()));
  if (views.empty() || !finite(position.value)) return kLit;
  const auto of_view = [&](uint32_t i) {
    return i < views.size() ? share_in_view(map, side, views[i], position, normal, false) : kLit;
  };
  if (light.kind == kLightDirectional)
    return directional_share(map, side, views.first(std::min<size_t>(views.size(), kMostCascades)), position, normal,
                             dither);
  if (light.kind != kLightPoint) return of_view(0);
  Interval all = {1, 0};
  for (const uint32_t face : faces_of(position - Ball{dvec3(light.position), 0})) all = hull(all, of_view(face));
  return all;
}

// The inner sum in units of 2^-32, less its whole turns; 52.9829189 times that, less its whole turns; its upper 24
// bits.
float dither_of(uint32_t x, uint32_t y, uint32_t frame) {
  constexpr uint64_t kTurn = 1ull << 32, kAcross = 288237660, kDown = 25070368, kFrame = 1750839832,
                     kHundredths = 4221604530;  // 0.9829189
  const uint64_t inner = (x * kAcross + y * kDown + frame * kFrame) % kTurn;
  const uint64_t outer = (52 * inner + inner * kHundredths / kTurn) % kTurn;
  return static_cast<float>(std::ldexp(static_cast<double>(outer >> 8), -24));
}

}  // namespace assay::shadowing
