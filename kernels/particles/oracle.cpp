#include "kernels/particles/oracle.h"

#include <algorithm>
#include <cmath>

#include "harness/half.h"
#include "harness/judged.h"
#include "harness/parallel.h"
#include "kernels/particles/light.h"

namespace assay::particles {

using glm::dvec3;

namespace {

constexpr uint64_t kJudgedAbove = 1u << 16;
constexpr double kLeastNormalHalf = 0x1p-14;

struct Frame {
  const Case& c;
  View view = {c.params<ParticlesParams>(), c.extent, std::ldexp(1.0, static_cast<int>(c.device.sub_pixel_bits))};
  std::span<const ParticleRecord> particles = c.input<ParticleRecord>("particles");
  std::span<const uint32_t> order = c.input<uint32_t>("order"), rects = c.input<uint32_t>("rects");
  std::span<const float> depth = c.input<float>("depth");
  std::span<const LightRecord> lights =
      c.input<LightRecord>("lights").first(std::min<size_t>(view.params.lights, kMostLights));
  Atlas atlas = {c.input<uint32_t>("atlas"), view.params.atlas_side, view.params.encoding};
};

// What half arithmetic makes of a number: either neighbour, and nothing of what is below the normal ones.
Interval halved(Interval v) {
  Interval h = {half_at_most(v.low), v.high > kLargestHalf ? double{kNotFinite} : half_at_least(v.high)};
  if (std::fabs(h.low) < kLeastNormalHalf) h.low = std::min(h.low, 0.0);
  if (std::fabs(h.high) < kLeastNormalHalf) h.high = std::max(h.high, 0.0);
  return h;
}
Interval times(Interval a, Interval b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return halved({low, high});
}

using Texel = std::array<Interval, 4>;

// Vulkan blends at no less than the target's precision: each operand and each result may be a half.
Interval blended(Interval below, Interval colour, Interval alpha) {
  const Interval a = halved(alpha), rest = halved({1 - a.high, 1 - a.low});
  // An H100 holds infinities within the largest half as it blends; lavapipe keeps them.
  if (below.low >= kNotFinite) return {times(exactly(kLargestHalf), rest).low, kNotFinite};
  const Interval over = times(halved(colour), a), under = times(below, rest);
  Interval sum = halved({over.low + under.low, over.high + under.high});
  if (below.high >= kNotFinite) sum.high = kNotFinite;
  return sum;
}
Texel blended(const Texel& below, const Colour& colour, Interval alpha) {
  Texel t;
  for (size_t i = 0; i < 3; ++i) t[i] = blended(below[i], colour[i], alpha);
  t[3] = blended(below[3], exactly(1), alpha);
  return t;
}
Texel hull(const Texel& a, const Texel& b) {
  Texel t;
  for (size_t i = 0; i < 4; ++i) t[i] = assay::hull(a[i], b[i]);
  return t;
}

Interval profile(const Place& p) {
  const Interval inside = at_least(exactly(1) - (square(p.x) + square(p.y)), 0);
  return square(inside);
}
// A gap of 0 or less shows nothing, whatever the softness.
Interval soft(const Frame& f, uint64_t pixel, const ParticleRecord& p, Interval depth) {
  const float d = f.depth[pixel];
  if (!(d > kLeastDepth && std::isfinite(d))) return exactly(1);
  const Interval gap = exactly(f.view.params.near_plane) / exactly(d) - depth;
  if (gap.high <= 0) return exactly(0);
  if (!(p.softness > 0)) return {gap.low > 0 ? 1.0 : 0.0, 1};
  return clamped(at_least(gap, 0) / exactly(p.softness), 0, 1);
}
Interval near_fade(const Frame& f, Interval depth) {
  return clamped(depth / exactly(f.view.params.near_plane) - exactly(1), 0, 1);
}

// Opacity at a place; wide open where the place is not known.
Interval alpha_of(const Frame& f, uint64_t pixel, const ParticleRecord& p, const Place& place) {
  const Interval opacity = exactly(std::min(p.opacity, 1.0f));
  if (!place.known) return {0, opacity.high};
  if (place.depth.high <= 0) return exactly(0);
  const Interval depth = at_least(place.depth, 0);
  return opacity * profile(place) * soft(f, pixel, p, depth) * near_fade(f, depth);
}

// Held within 0 and the largest half.
Colour colour_of(const ParticleRecord& p, const Colour& light) {
  Colour colour;
  for (size_t i = 0; i < 3; ++i) {
    colour[i] = clamped(exactly(p.albedo[static_cast<int>(i)]) * light[i], 0, kGreatestRadiance);
  }
  return colour;
}

// Light of a particle at its entry and a place on it.
using LightAt =
    std::function<Colour(size_t entry, const ParticleRecord&, uint32_t number, const Place&, const Ball& ray)>;

void draw(const Frame& f, const Quad& q, size_t entry, const LightAt& light_at, uint32_t y,
          std::span<const uint64_t> row, std::span<Texel> texels) {
  const uint32_t width = f.c.extent.width;
  const auto first = std::ranges::lower_bound(row, uint64_t{y} * width + q.x_first);
  for (auto it = first; it != row.end() && *it < uint64_t{y} * width + q.x_end; ++it) {
    const auto x = static_cast<uint32_t>(*it % width);
    const Place place = place_of(f.view, q, x, y);
    const Interval alpha = alpha_of(f, *it, q.record, place);
    if (!(alpha.high > 0)) continue;
    const Times times = times_covered(f.view, q, x, y);
    const Colour colour =
        colour_of(q.record, light_at(entry, q.record, f.order[entry], place, ray_of(f.view.params, x, y)));
    Texel& t = texels[static_cast<size_t>(it - row.begin())];
    const Texel once = blended(t, colour, alpha), twice = times.most > 1 ? blended(once, colour, alpha) : once;
    // Where the opacity may be 0 the fragment may be discarded.
    t = times.least == 0 || alpha.low <= 0 ? hull(t, hull(once, twice)) : hull(once, twice);
  }
}

struct Judged {
  std::vector<uint64_t> listed;  // empty: all
  std::vector<uint64_t> all;
};

Expected picture(const Frame& f, const Judged& judged, const LightAt& light_at) {
  const auto halves = f.c.input<std::array<uint16_t, 4>>("radiance");
  std::vector<std::optional<Quad>> quads;
  for (const uint32_t number : f.order.first(std::min<size_t>(f.order.size(), f.view.params.drawn)))
    quads.push_back(number < f.view.params.particles ? quad_of(f.view, f.particles[number]) : std::optional<Quad>());
  std::vector<vec4> low(judged.all.size()), high(judged.all.size());
  in_parallel(f.c.extent.height, [&](uint64_t y) {
    const uint64_t width = f.c.extent.width;
    const auto from = std::ranges::lower_bound(judged.all, y * width),
               to = std::ranges::lower_bound(judged.all, (y + 1) * width);
    const std::span<const uint64_t> row(from, to);
    std::vector<Texel> texels(row.size());
    for (size_t i = 0; i < row.size(); ++i)
      for (size_t c = 0; c < 4; ++c) {
        const double v = half_value(halves[row[i]][c]);
        texels[i][c] = exactly(std::isfinite(v) ? v : double{kNotFinite});
      }
    for (size_t e = 0; e < quads.size(); ++e)
      if (quads[e] && quads[e]->y_first <= y && y < quads[e]->y_end)
        draw(f, *quads[e], e, light_at, static_cast<uint32_t>(y), row, texels);
    for (size_t i = 0; i < row.size(); ++i)
      for (size_t c = 0; c < 4; ++c) {
        const auto at = static_cast<size_t>(from - judged.all.begin()) + i;
        low[at][static_cast<int>(c)] = static_cast<float>(texels[i][c].low);
        high[at][static_cast<int>(c)] = static_cast<float>(texels[i][c].high);
      }
  });
  Expected e = {.low = expect_all(low).low, .high = expect_all(high).low, .judged = judged.listed};
  for (uint32_t i = 0; i <= low.size(); ++i) e.first.push_back(i);
  return e;
}

LightAt by_atlas(const Frame& f, Filter filter) {
  return [&f, filter](size_t, const ParticleRecord& p, uint32_t number, const Place& place, const Ball&) {
    const auto light = from_atlas(f.atlas, f.rects[number], filter, place);
    return light ? *light : lit(p, {dvec3(p.centre), 0}, f.view.params.ambient, {});
  };
}

// The ray times the depth; of a place that is not known, all of the quad.
LightAt by_pixel(const Frame& f) {
  return [&f](size_t, const ParticleRecord& p, uint32_t, const Place& place, const Ball& ray) {
    const double middle = (place.depth.low + place.depth.high) / 2, off = (place.depth.high - place.depth.low) / 2;
    const Ball seen = {ray.value * middle,
                       (ray.error * (middle + off) + reach(ray) * off + kUnitRoundoff * reach(ray) * (middle + off)) *
                           bounded::kSlack};
    const Ball anywhere = {dvec3(p.centre), glm::length(dvec3(p.right)) + glm::length(dvec3(p.up))};
    return lit(p, place.known ? seen : anywhere, f.view.params.ambient, f.lights);
  };
}

Colour stored(Colour light) {
  for (Interval& i : light) i = clamped(i, 0, kGreatestRadiance);
  return light;
}
std::vector<std::array<Colour, 4>> corner_lights(const Frame& f) {
  constexpr glm::dvec2 kAt[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<std::array<Colour, 4>> all(f.view.params.drawn);
  in_parallel(all.size(), [&](uint64_t i) {
    if (f.order[i] >= f.view.params.particles || !is_drawn(f.particles[f.order[i]])) return;
    const ParticleRecord& p = f.particles[f.order[i]];
    const double size = glm::length(abs(dvec3(p.centre)) + abs(dvec3(p.right)) + abs(dvec3(p.up)));
    for (size_t k = 0; k < 4; ++k)
      all[i][k] = stored(
          lit(p, {position(p, kAt[k]), 2 * kUnitRoundoff * bounded::kSlack * size}, f.view.params.ambient, f.lights));
  });
  return all;
}

constexpr double kFlushed = 0x1p-100;  // denormal floats may be
Expected expected_corners(const std::vector<std::array<Colour, 4>>& lights) {
  std::vector<vec3> low, high;
  Expected e = {.first = {0}};
  for (const auto& corners : lights)
    for (const Colour& c : corners) {
      vec3 least, most;
      for (size_t i = 0; i < 3; ++i) {
        least[static_cast<int>(i)] = std::nextafter(static_cast<float>(std::max(c[i].low - kFlushed, 0.0)), -1.0f);
        most[static_cast<int>(i)] = std::nextafter(static_cast<float>(c[i].high + kFlushed), 1e30f);
      }
      low.push_back(least), high.push_back(most);
      e.first.push_back(static_cast<uint32_t>(low.size()));
    }
  e.low = expect_all(low).low, e.high = expect_all(high).low;
  return e;
}

Judged judged_of(const Case& c) {
  Judged j = {.listed = judged_pixels(c, kJudgedAbove, JudgedBorders::last)};
  for_each_judged(c, j.listed, [&](uint64_t pixel) { j.all.push_back(pixel); });
  return j;
}

}  // namespace

Layout texel_layout() { return {"", 16, {{"radiance", 0, 3, Scalar::f32}, {"alpha", 12, 1, Scalar::f32}}}; }

Bytes unpack_texels(std::span<const std::byte> texels) {
  std::vector<uint16_t> halves(texels.size() / 2);
  std::memcpy(halves.data(), texels.data(), texels.size());
  std::vector<float> values;
  for (const uint16_t h : halves) {
    const double v = half_value(h);
    values.push_back(std::isfinite(v) ? static_cast<float>(v) : kNotFinite);
  }
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

Answer drawn(const Case& c) {
  const Frame f = {c};
  const Judged judged = judged_of(c);
  const auto corners = corner_lights(f);
  return {{"bilinear", picture(f, judged, by_atlas(f, Filter::bilinear))},
          {"b_spline", picture(f, judged, by_atlas(f, Filter::b_spline))},
          {"catmull_rom", picture(f, judged, by_atlas(f, Filter::catmull_rom))},
          {"per_pixel", picture(f, judged, by_pixel(f))},
          {"per_vertex", picture(f, judged,
                                 [&](size_t entry, const ParticleRecord&, uint32_t, const Place& place, const Ball&) {
                                   return from_corners(corners[entry], place);
                                 })},
          {"corners", expected_corners(corners)}};
}

}  // namespace assay::particles
