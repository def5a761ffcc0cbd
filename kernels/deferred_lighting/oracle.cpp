#include "kernels/deferred_lighting/oracle.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

#include "harness/half.h"
#include "harness/judged.h"
#include "harness/lighting_oracle.h"
#include "harness/shadow_oracle.h"
#include "kernels/deferred_lighting/layout.h"
#include "kernels/deferred_lighting/sources.h"

namespace assay::deferred_lighting {

namespace {

using glm::dvec3;
using shading::Colour;

constexpr double u = kUnitRoundoff;
constexpr double kLeastDepth = 1e-30;
constexpr uint64_t kJudgedPixels = 1u << 14;  // of a case in which every light meets every pixel of this many
constexpr uint32_t kShadowTaps = 3;
constexpr double kDecided = 0.01;
constexpr uint64_t kJudgedShades = 1u << 20;  // pixels times lights

struct View {
  const Case& c;
  LightingParams params = c.params<LightingParams>();
  std::span<const float> depth = c.input<float>("depth");
  std::span<const uint32_t> base = c.input<uint32_t>("base_roughness"), normal = c.input<uint32_t>("normal"),
                            emissive = c.input<uint32_t>("emissive"), features = c.input<uint32_t>("features");
  std::span<const uint16_t> metal = c.input<uint16_t>("metallic_occlusion");
  std::span<const LightRecord> lights =
      c.input<LightRecord>("lights").first(std::min<size_t>(params.lights, kMostLights));
  std::span<const std::array<uint16_t, 2>> gradients = c.input<std::array<uint16_t, 2>>("depth_gradients");
  shadowing::Map shadows = {
      c.input<ShadowView>("shadow_views"), {params.shadow_width, params.shadow_height}, c.input<float>("shadow_depth")};
};

uint32_t byte_of(uint32_t word, uint32_t i) { return word >> 8 * i & 255u; }

// corner + across x + down y: three roundings of each term.
Ball ray_of(const LightingParams& p, uint64_t pixel) {
  const uint64_t column = pixel % p.width, row = pixel / p.width;
  const double x = static_cast<double>(column) + 0.5, y = static_cast<double>(row) + 0.5;
  const dvec3 corner(p.rays.corner), across = dvec3(p.rays.across) * x, down = dvec3(p.rays.down) * y;
  return {corner + across + down, 3 * u * glm::length(glm::abs(corner) + glm::abs(across) + glm::abs(down))};
}

// ray * (near / depth): 5u of the quotient, u of the product.
Ball position_of(const LightingParams& p, const Ball& ray, double depth) {
  const double w = double{p.near_plane} / depth;
  return {ray.value * w, (ray.error + 6 * u * reach(ray)) * w * bounded::kSlack};
}

// Octahedral codes are whole numbers and stay so; what is off is the normalisation.
Ball normal_of(uint32_t texel) {
  const auto code = [](uint32_t bits) { return std::max(static_cast<int>(static_cast<int16_t>(bits)), -32767); };
  double x = code(texel & 0xffffu), y = code(texel >> 16);
  const double z = 32767 - std::fabs(x) - std::fabs(y);
  if (z < 0) {
    const double folded = (32767 - std::fabs(y)) * (x < 0 ? -1 : 1);
    y = (32767 - std::fabs(x)) * (y < 0 ? -1 : 1);
    x = folded;
  }
  return normalised({{x, y, z}, 0}, kShortestVector);
}

dvec3 emission_of(uint32_t code) {
  const double scale = std::ldexp(1.0, static_cast<int>(code >> 27) - 24);
  return dvec3(code & 511u, code >> 9 & 511u, code >> 18 & 511u) * scale;
}

shading::OracleSurface surface_of(const View& v, uint64_t pixel) {
  const Ball ray = ray_of(v.params, pixel);
  shading::OracleSurface s;
  s.position = position_of(v.params, ray, v.depth[pixel]);
  s.normal = normal_of(v.normal[pixel]);
  s.to_eye = -normalised(ray, kShortestVector);
  for (uint32_t i = 0; i < 3; ++i) s.base_colour[i] = square(shading::unorm8(byte_of(v.base[pixel], i)));
  s.roughness = shading::unorm8(byte_of(v.base[pixel], 3));
  s.metallic = shading::unorm8(v.metal[pixel] & 255u);
  s.features = v.features[pixel];
  return s;
}

// The lights of the pixel's cell: of the slices that begin at its depth or before, the last.
std::vector<LightRecord> listed(const View& v, uint64_t pixel) {
  const ClusterGrid& g = v.params.grid;
  const auto cells = v.c.input<uvec2>("cells");
  const auto entries = v.c.input<uint32_t>("entries");
  const auto edges = v.c.input<float>("slice_edges");
  if (cells.empty()) return {};
  uint32_t slice = 0;
  for (uint32_t k = 1; k < g.slices; ++k)
    if (v.depth[pixel] <= edges[k]) slice = k;
  const uint64_t column = std::min<uint64_t>(pixel % v.params.width / g.cell_width, g.columns - 1),
                 row = std::min<uint64_t>(pixel / v.params.width / g.cell_height, g.rows - 1);
  const uvec2 head = cells[(slice * uint64_t{g.rows} + row) * g.columns + column];
  std::vector<LightRecord> found;
  for (uint64_t i = head.x; i < uint64_t{head.x} + std::min(head.y % 4096, 256u) && i < entries.size(); ++i)
    if (const uint32_t light = entries[i] % 4096; light < v.lights.size()) found.push_back(v.lights[light]);
  return found;
}

// Of the plane whose depth changes so from pixel to pixel: the product of how positions do.
Ball plane_normal_of(const View& v, uint64_t pixel) {
  const Ball ray = ray_of(v.params, pixel), across = {dvec3(v.params.rays.across), 0},
             down = {dvec3(v.params.rays.down), 0};
  const double x = half_value(v.gradients[pixel][0]), y = half_value(v.gradients[pixel][1]);
  if (!std::isfinite(x) || !std::isfinite(y)) return {dvec3(std::numeric_limits<double>::quiet_NaN()), 0};
  const auto times = [](const Ball& a, double s) {
    return Ball{a.value * s, (a.error + u * reach(a)) * std::fabs(s) * bounded::kSlack};
  };
  return normalised(cross(across, down) + times(cross(down, ray), x) + times(cross(ray, across), y), kLeastArea);
}

struct Shares {  // of lights that arrive at a pixel
  Ball normal;
  float dither;
};
Shares shares_at(const View& v, uint64_t pixel) {
  const auto column = static_cast<uint32_t>(pixel % v.params.width),
             row = static_cast<uint32_t>(pixel / v.params.width);
  return {plane_normal_of(v, pixel), shadowing::dither_of(column, row, v.params.frame)};
}

struct Radiance {
  Colour colour;
  bool undecided = false;  // a share is open by more than a hundredth
};

Radiance radiance_of(const View& v, uint64_t pixel, std::span<const LightRecord> lights, bool shadowed) {
  const shading::OracleSurface s = surface_of(v, pixel);
  const dvec3 emission = emission_of(v.emissive[pixel]);
  Colour sum = Colour{exactly(emission.x), exactly(emission.y), exactly(emission.z)} +
               shading::shade_ambient(s, v.params.ambient) * shading::unorm8(v.metal[pixel] >> 8u);
  Radiance r = {sum};
  const Shares at = shadowed ? shares_at(v, pixel) : Shares{};
  for (const LightRecord& light : lights) {
    Interval visible = exactly(1);
    if (shadowed) visible = shadowing::share_of(v.shadows, kShadowTaps, light, s.position, at.normal, at.dither);
    const Colour arrived = shading::shade(s, light, visible);
    if (visible.high - visible.low > kDecided)
      for (const Interval& i : arrived) r.undecided |= i.low != i.high;
    r.colour = r.colour + arrived;
  }
  return r;
}

// All pixels of small cases; of others every n-th, n odd so that neighbouring rows differ.
std::vector<uint64_t> judged_pixels(const View& v) {
  const uint64_t most =
      std::min(kJudgedPixels, std::max<uint64_t>(1024, kJudgedShades / std::max<size_t>(v.lights.size(), 1)));
  std::vector<uint64_t> judged;
  if (v.c.judge_all || pixels(v.c) <= most) return judged;
  for (uint64_t i = 0; i < pixels(v.c); i += pixels(v.c) / most | 1) judged.push_back(i);
  return judged;
}

// Denormal floats may be flushed on the way, and so may halves below the least normal one.
constexpr double kFlushed = 0x1p-100, kLeastNormalHalf = 0x1p-14;
float lowest(double v) {
  const double half = half_at_most(std::clamp(v - kFlushed, 0.0, kLargestHalf));
  return half < kLeastNormalHalf ? 0 : static_cast<float>(half);
}
float highest(double v) { return static_cast<float>(half_at_least(std::clamp(v + kFlushed, 0.0, kLargestHalf))); }

}  // namespace

bool has_surface(float depth) { return depth > kLeastDepth && std::isfinite(depth); }

Layout texel_layout() { return {"", 16, {{"radiance", 0, 3, Scalar::f32}, {"surface", 12, 1, Scalar::f32}}}; }

Bytes unpack_texels(std::span<const std::byte> texels) {
  std::vector<uint16_t> halves(texels.size() / 2);
  std::memcpy(halves.data(), texels.data(), texels.size());
  std::vector<float> values(halves.begin(), halves.end());
  for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(half_value(halves[i]));
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

namespace {

struct Texels {
  vec4 low = vec4(0), high = vec4(0);  // background
  bool undecided = false;
};

// Of pixels under the lights that light_of() names, each worked out once: copies ask for their primary's.
class Lit {
 public:
  using LightsOf = std::function<std::vector<LightRecord>(uint64_t)>;
  Lit(const View& v, bool shadowed, LightsOf lights_of)
      : view_(v), shadowed_(shadowed), lights_of_(std::move(lights_of)) {}

  const Texels& at(uint64_t pixel) {
    const auto [it, is_new] = known_.try_emplace(pixel);
    Texels& t = it->second;
    if (!is_new || pixel == kFromNowhere || !has_surface(view_.depth[pixel])) return t;
    const Radiance r = radiance_of(view_, pixel, lights_of_(pixel), shadowed_);
    for (int i = 0; i < 3; ++i)
      t.low[i] = lowest(r.colour[static_cast<size_t>(i)].low),
      t.high[i] = highest(r.colour[static_cast<size_t>(i)].high);
    t.low.w = t.high.w = 1;
    t.undecided = r.undecided;
    return t;
  }

 private:
  const View& view_;
  bool shadowed_;
  LightsOf lights_of_;
  std::unordered_map<uint64_t, Texels> known_;
};

struct Answered {
  Expected e;
  std::vector<vec4> low, high;

  // Twice what is undecided.
  void add(const Texels& t) {
    for (int n = t.undecided ? 2 : 1; n > 0; --n) low.push_back(t.low), high.push_back(t.high);
  }
  Expected done() {
    e.low = expect_all(low).low, e.high = expect_all(high).low;
    return std::move(e);
  }
};

Expected each_its_own(const View& v, const std::vector<uint64_t>& judged, Lit& lit) {
  Answered a{{.first = {0}, .judged = judged}, {}, {}};
  for_each_judged(v.c, judged, [&](uint64_t pixel) {
    a.add(lit.at(pixel));
    a.e.first.push_back(static_cast<uint32_t>(a.low.size()));
  });
  return a.done();
}

// Empty: all.
std::optional<std::vector<Expected::Run>> live_in(const Sources& s) {
  if (std::ranges::find(s.first, kNobody) == s.first.end()) return {};
  std::vector<Expected::Run> runs;
  for (uint64_t i = 0; i < s.first.size(); ++i) {
    if (s.first[i] == kNobody) continue;
    if (runs.empty() || runs.back().first + runs.back().count != i) runs.push_back({i, 0});
    ++runs.back().count;
  }
  return runs;
}

Expected by_sources(const View& v, const std::vector<uint64_t>& judged, Lit& lit, const Sources& s) {
  Answered a{{.first = {0}, .live = live_in(s)}, {}, {}};
  for_each_judged(v.c, judged, [&](uint64_t pixel) {
    if (s.first[pixel] == kNobody) return;
    a.add(lit.at(s.first[pixel]));
    if (const auto more = s.others.find(pixel); more != s.others.end())
      for (const uint32_t source : more->second) a.add(lit.at(source));
    a.e.first.push_back(static_cast<uint32_t>(a.low.size()));
    if (!judged.empty()) a.e.judged.push_back(pixel);
  });
  // None of the sample is live: all that are.
  if (!judged.empty() && a.e.judged.empty()) return by_sources(v, {}, lit, s);
  return a.done();
}

}  // namespace

Answer expected_radiance(const Case& c) {
  const View v = {c};
  const auto judged = judged_pixels(v);
  const auto first = [&v](size_t most) {
    const auto some = v.lights.first(std::min(v.lights.size(), most));
    return [some](uint64_t) { return std::vector(some.begin(), some.end()); };
  };
  const auto of_cell = [&](uint64_t pixel) { return listed(v, pixel); };
  Lit by_all(v, false, first(kMostLights)), by_listed(v, false, of_cell);
  Lit shadowed_all(v, true, first(kMostShadowedLights)), shadowed_listed(v, true, of_cell);
  const Sources by_tiles = sources_by_tiles(c), by_list = sources_by_list(c);
  return {{"radiance", each_its_own(v, judged, by_all)},
          {"clustered_radiance", each_its_own(v, judged, by_listed)},
          {"plain_tile_list", by_sources(v, judged, by_all, by_tiles)},
          {"clustered_tile_list", by_sources(v, judged, by_listed, by_tiles)},
          {"clustered_list", by_sources(v, judged, by_listed, by_list)},
          {"plain_shadowed", each_its_own(v, judged, shadowed_all)},
          {"clustered_shadowed", each_its_own(v, judged, shadowed_listed)},
          {"plain_tile_list_shadowed", by_sources(v, judged, shadowed_all, by_tiles)},
          {"clustered_tile_list_shadowed", by_sources(v, judged, shadowed_listed, by_tiles)}};
}

std::vector<double> relative_widths(const Case& c) {
  const View v = {c};
  std::vector<double> widths;
  for_each_judged(c, judged_pixels(v), [&](uint64_t pixel) {
    if (!has_surface(v.depth[pixel])) return;
    for (const Interval& i : radiance_of(v, pixel, v.lights, false).colour)
      if (i.low + i.high > 2e-3) widths.push_back((i.high - i.low) / (0.5 * (i.low + i.high)));
  });
  return widths;
}

}  // namespace assay::deferred_lighting
