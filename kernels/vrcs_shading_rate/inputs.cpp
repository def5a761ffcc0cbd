#include "kernels/vrcs_shading_rate/inputs.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "harness/crop.h"
#include "harness/oracle.h"

namespace assay::vrcs_shading_rate {

namespace {

using Luma = std::vector<glm::u8vec2>;

constexpr double kPi = 3.14159265358979323846;

RateParams usual(Extent e) {
  return {.width = e.width,
          .height = e.height,
          .flags = 0,
          .tolerance = kUsualTolerance,
          .ambient = 0.05f,
          .half_weight = 1,
          .quarter_weight = 1,
          .extra_half = 0,
          .foveation = 0,
          .border = 0,
          .border_gain = 1};
}

Case case_of(Extent e, const Luma& luma, RateParams p) {
  Case c{.extent = e};
  c.set_params(p);
  c.set_input("luma", luma);
  return c;
}

uint8_t code(double v) { return static_cast<uint8_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); }

// A picture of both lumas alike.
using Paint = std::function<double(double x, double y)>;
Luma painted(Extent e, const Paint& paint) {
  Luma luma;
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) luma.emplace_back(code(paint(x, y)));
  return luma;
}

double noise(int64_t x, int64_t y) {
  return Pcg32(static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15ull ^ static_cast<uint64_t>(y)).unit();
}
// Values on a grid of `step` pixels, mixed smoothly between.
double smooth_noise(double x, double y, double step) {
  const double u = x / step, v = y / step, i = std::floor(u), j = std::floor(v);
  const auto eased = [](double t) { return t * t * (3 - 2 * t); };
  const auto at = [&](int dx, int dy) { return noise(static_cast<int64_t>(i) + dx, static_cast<int64_t>(j) + dy); };
  const double a = eased(u - i), b = eased(v - j);
  return std::lerp(std::lerp(at(0, 0), at(1, 0), a), std::lerp(at(0, 1), at(1, 1), a), b);
}

// Numerics.md 5.2: patches of 128 pixels, off the grid: slopes, smooth and fine noise, edges, stripes.
double patchwork(double x, double y) {
  const double u = x - 37.3, v = y - 21.7;
  const int64_t column = static_cast<int64_t>(std::floor(u / 128)), row = static_cast<int64_t>(std::floor(v / 128));
  const double in_x = u - 128.0 * static_cast<double>(column), in_y = v - 128.0 * static_cast<double>(row);
  switch ((column * 3 + row * 5) & 7) {
    case 0:
      return 0.2 + 0.6 * in_x / 128;
    case 1:
      return 0.1 + 0.5 * smooth_noise(x, y, 40) + 0.2 * smooth_noise(x, y, 13);
    case 2:
      return 0.3 + 0.3 * smooth_noise(x, y, 5) + 0.15 * smooth_noise(x, y, 2.3);
    case 3:
      return in_x + 0.4 * in_y < 90 ? 0.25 : 0.7;
    case 4:
      return 0.5 + 0.3 * std::sin(2 * kPi * in_x / 18);
    case 5:
      return 0.5 + 0.3 * std::sin(2 * kPi * in_y / 5.2);
    case 6:
      return 0.4;
    default:
      return 0.6 - 0.4 * in_y / 128 + 0.02 * noise(static_cast<int64_t>(x), static_cast<int64_t>(y));
  }
}

}  // namespace

// Blended surfaces are a bright haze over a third of it.
Case typical(Extent e) {
  Luma luma = painted(e, patchwork);
  for (uint32_t y = e.height / 3; y < 2 * e.height / 3; ++y)
    for (uint32_t x = 0; x < e.width; ++x) {
      uint8_t& blended = luma[size_t{y} * e.width + x].y;
      blended = static_cast<uint8_t>((blended + 2 * 200) / 3);
    }
  RateParams p = usual(e);
  p.extra_half = kUsualExtraHalf;
  Case c = case_of(e, luma, p);
  c.name = "typical";
  return c;
}

// With full rates everywhere there are no cells.
namespace {
void follow_resolution(float share, RateParams& p) {
  p.tolerance *= 1 + (kEvenShare - share) * kToleranceSlope;
  p.foveation = std::max(0.0f, (kFoveatedShare - share) * kFoveationSlope);
}
}  // namespace

Case in_frame(const FrameInputs& f) {
  if (!f.vrcs) return case_of({0, 0}, {}, usual({0, 0}));
  RateParams p = usual(f.extent);
  p.tolerance = f.vrcs_tolerance;
  p.extra_half = kUsualExtraHalf;
  if (f.vrcs_resolution > 0) follow_resolution(f.vrcs_resolution, p);
  p.border = f.vrcs_border, p.border_gain = kBorderGain;
  p.flags = f.history.luma.empty() ? kAllFull : 0;
  Case c = case_of(f.extent, {}, p);
  c.name = "frame";
  c.inputs["luma"] = f.history.luma.empty() ? Bytes(pixel_count(f.extent) * 2) : f.history.luma;
  return c;
}

namespace {

RateParams random_params(Random& r, Extent e) {
  RateParams p = usual(e);
  const auto real = [&](double low, double high) { return static_cast<float>(r.rng.range(low, high)); };
  p.tolerance = static_cast<float>(std::pow(10, r.rng.range(-3, -0.5)));
  if (r.branch({{"threshold_constant", 0.5}, {"threshold_weber", 0.5}}) == 1)
    p.flags = kWeber, p.ambient = real(0, 0.2);
  if (r.branch({{"still", 0.6}, {"moving", 0.4}}) == 1) p.half_weight = real(0.05, 1), p.quarter_weight = real(0.01, 2);
  if (r.branch({{"half_plain", 0.5}, {"half_extra", 0.5}}) == 1) p.extra_half = real(0.2, 0.9);
  if (r.branch({{"foveation_off", 0.6}, {"foveation_on", 0.4}}) == 1) p.foveation = real(0, 3);
  if (r.branch({{"border_none", 0.6}, {"border_safe", 0.4}}) == 1)
    p.border = r.rng.below(40), p.border_gain = real(0.5, 3);
  switch (r.branch({{"params_usual", 0.92}, {"params_all_full", 0.03}, {"params_odd", 0.05}})) {
    case 1:
      p.flags |= kAllFull;
      break;
    case 2: {
      constexpr float kOdd[] = {NAN, INFINITY, 0, -0.02f, 1e-30f, 1e30f};
      float* const any[] = {&p.tolerance, &p.ambient, &p.half_weight, &p.quarter_weight, &p.extra_half, &p.border_gain};
      *any[r.rng.below(6)] = kOdd[r.rng.below(6)];
      break;
    }
    default:
      break;
  }
  return p;
}

Luma random_luma(Random& r, Extent e) {
  const double dx = r.rng.range(0, 1000), dy = r.rng.range(0, 1000);
  const auto shifted = [&](double x, double y) { return patchwork(x + dx, y + dy); };
  Luma luma;
  switch (
      r.branch({{"picture_patchwork", 0.5}, {"picture_flat", 0.1}, {"picture_noise", 0.2}, {"picture_steps", 0.2}})) {
    case 0:
      luma = painted(e, shifted);
      break;
    case 1:
      luma.assign(pixel_count(e), glm::u8vec2(static_cast<uint8_t>(r.rng.next())));
      break;
    case 2: {
      const uint32_t reach = 1 + r.rng.below(60), least = r.rng.below(196);
      for (uint64_t i = 0; i < pixel_count(e); ++i) luma.emplace_back(static_cast<uint8_t>(least + r.rng.below(reach)));
      break;
    }
    default: {
      const double slope = r.rng.range(-2, 2), at = r.rng.range(0, 400), step = r.rng.range(0.02, 1);
      luma = painted(e, [&](double x, double y) { return x + slope * y < at ? 0.0 : step; });
    }
  }
  if (r.branch({{"blended_none", 0.4}, {"blended_some", 0.6}}) == 1)
    for (glm::u8vec2& l : luma)
      if (r.rng.below(16) == 0) l.y = static_cast<uint8_t>(l.y / 2 + r.rng.below(100));
  return luma;
}

Case random_case(Random& r) {
  const Extent e = random_extent(r, 32);
  const RateParams p = random_params(r, e);
  return case_of(e, random_luma(r, e), p);
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case s = c;
    s.extent = crop.size;
    RateParams p = c.params<RateParams>();
    p.width = crop.size.width, p.height = crop.size.height;
    s.set_params(p), s.set_input("luma", cropped(c.input<glm::u8vec2>("luma"), c.extent, crop));
    cases.push_back(std::move(s));
  }
  return cases;
}

// ---- Hard cases

HardCase of_picture(const char* name, const char* why, Extent e, Paint paint, float tolerance = 0.02f) {
  return {name, why, [=] {
            RateParams p = usual(e);
            p.tolerance = tolerance;
            return case_of(e, painted(e, paint), p);
          }};
}
HardCase of_params(const char* name, const char* why, const std::function<void(RateParams&)>& change) {
  return {name, why, [=] {
            const Extent e{200, 130};
            RateParams p = usual(e);
            change(p);
            return case_of(e, painted(e, patchwork), p);
          }};
}

std::vector<HardCase> pictures() {
  const Extent e{96, 64};
  return {
      of_picture(
          "constant", "no error: 2x2 everywhere, whatever the tolerance", e, [](double, double) { return 0.3; }, 0),
      of_picture("ramp_across", "no second difference: a slope is not seen", e,
                 [](double x, double) { return x * 2 / 255; }),
      of_picture("ramp_diagonal", "neither across, nor down, nor diagonally", e,
                 [](double x, double y) { return (x + y) / 255; }),
      of_picture("stripes_even", "one pixel on, one off: a forward difference of even pixels has all of it", e,
                 [](double x, double) { return static_cast<int>(x) & 1 ? 0.3 : 0.33; }),
      of_picture("stripes_odd", "the other phase", e,
                 [](double x, double) { return static_cast<int>(x) & 1 ? 0.33 : 0.3; }),
      of_picture("stripes_down", "and across: 2x1 alone", e,
                 [](double, double y) { return static_cast<int>(y) & 1 ? 0.2 : 0.9; }),
      of_picture("checkerboard", "neither half rate is any better", e,
                 [](double x, double y) { return (static_cast<int>(x) + static_cast<int>(y)) & 1 ? 0.2 : 0.9; }),
      of_picture("step_on_a_tile", "an edge between two tiles: seen by the ring alone", e,
                 [](double x, double) { return x < 48 ? 0.2 : 0.8; }),
      of_picture("step_before_a_tile", "an edge in a tile's last column", e,
                 [](double x, double) { return x < 47 ? 0.2 : 0.8; }),
      of_picture("corner_of_a_tile", "a pixel that only a diagonal reaches", e,
                 [](double x, double y) { return x == 48 && y == 32 ? 1.0 : 0.2; }),
      of_picture("dark_beside_bright", "10^-4 beside white", e, [](double x, double y) { return x < y ? 1e-4 : 1.0; }),
      of_picture(
          "threshold", "codes whose errors are equal to the tolerance, or a code beside it", e,
          [](double x, double y) { return std::floor(x / 8) * (static_cast<int>(x) & 1) / 255 + 0.1 + y * 0; },
          4.0f / 255),
      of_picture("one_pixel", "a picture of a pixel", {1, 1}, [](double, double) { return 0.5; }),
      of_picture("one_row", "a row has no neighbours down", {37, 1}, [](double x, double) { return x / 40; }),
      of_picture("one_column", "nor a column across", {1, 37}, [](double, double y) { return y / 40; }),
      of_picture("mirrored", "slopes that end at the sides: beyond them is what lies before", {40, 40},
                 [](double x, double y) { return (std::min(x, 39 - x) + std::min(y, 39 - y)) * 6 / 255; }),
      of_picture(
          "slopes", "of 2 and of 12 codes a pixel, 20 pixels long: all error is the slope's, just within 2x2's doubled",
          {120, 16},
          [](double x, double) {
            const int block = static_cast<int>(x) / 20, in = static_cast<int>(x) % 20;
            return (5 + in * (block & 1 ? 12 : 2)) / 255.0;
          },
          0.00804f),
      of_picture("odd_extent", "the last column and row are half a cell", {61, 35}, patchwork),
      of_picture("odd_and_a_tile", "one pixel beyond a tile", {65, 49}, patchwork),
      of_picture("whole_groups", "no pixel beyond the sides", {64, 48}, patchwork),
  };
}

// Noise across, down and both ways whose strength grows from tile to tile: some tile is at whatever threshold there is.
HardCase sweep(const char* name, const char* why, const std::function<void(RateParams&)>& change) {
  return {name, why, [=] {
            const Extent e{197, 131};
            RateParams p = usual(e);
            change(p);
            return case_of(
                e,
                painted(e,
                        [](double x, double y) {
                          const int64_t column = static_cast<int64_t>(x) / 8, row = static_cast<int64_t>(y) / 8;
                          const double strength = 0.3 * noise(column + 7000, row), kind = noise(column, row + 9000);
                          const int64_t u = kind < 0.3 ? 0 : static_cast<int64_t>(x),
                                        v = kind > 0.7 ? 0 : static_cast<int64_t>(y);
                          return 0.4 + strength * strength * 3 * (noise(u, v) - 0.5);
                        }),
                p);
          }};
}

std::vector<HardCase> settings() {
  std::vector<HardCase> cases = {
      of_params("all_full", "no picture before: 1x1", [](RateParams& p) { p.flags = kAllFull; }),
      of_params("weber", "dark tiles are finer", [](RateParams& p) { p.flags = kWeber, p.tolerance = 0.04f; }),
      of_params("motion", "what moves may be coarser",
                [](RateParams& p) { p.half_weight = 0.2f, p.quarter_weight = 0.6f; }),
      of_params("extra_half", "half rates where 2x2 is not quite good enough",
                [](RateParams& p) { p.tolerance = 0.1f, p.extra_half = 0.1f; }),
      of_params("foveation", "coarser in the corners", [](RateParams& p) { p.foveation = 2; }),
      of_params("safe_border", "coarser at the sides", [](RateParams& p) { p.border = 20, p.border_gain = 3; }),
      of_params("border_over_all", "a border wider than the picture",
                [](RateParams& p) { p.border = 5000, p.border_gain = 2; }),
      sweep("sweep", "errors of every size, at the sides too", [](RateParams&) {}),
      sweep("sweep_moving", "and with motion", [](RateParams& p) { p.half_weight = 0.2f, p.quarter_weight = 0.3f; }),
      sweep("sweep_extra_half", "and a second threshold",
            [](RateParams& p) { p.tolerance = 0.06f, p.extra_half = 0.2f; }),
      of_params("tolerance_none", "what has no error at all", [](RateParams& p) { p.tolerance = 0; }),
      of_params("tolerance_all", "anything passes", [](RateParams& p) { p.tolerance = 1e30f; }),
      of_params("tolerance_nan", "nothing passes", [](RateParams& p) { p.tolerance = NAN; }),
  };
  cases.push_back(
      {"blended_coarser", "blended surfaces may coarsen, never refine; on a tie of halves the opaque one", [] {
         const Extent e{96, 64};
         Luma luma = painted(e, patchwork);
         for (uint32_t y = 0; y < e.height; ++y)
           for (uint32_t x = 0; x < e.width; ++x) {
             glm::u8vec2& l = luma[size_t{y} * e.width + x];
             if (x < 32)
               l.y = 128;
             else if (x < 64)
               l = {static_cast<uint8_t>(x & 1 ? 60 : 90), static_cast<uint8_t>(y & 1 ? 60 : 90)};
             else
               l = {100, static_cast<uint8_t>((x ^ y) & 1 ? 200 : 20)};
           }
         return case_of(e, luma, usual(e));
       }});
  cases.push_back({"ultra_hd", "3840x2160, the largest frame", [] { return typical({3840, 2160}); }, true});
  return cases;
}

}  // namespace

Inputs inputs() {
  Inputs in = {.random = random_case, .branches = kExtentBranches, .hard = pictures(), .smaller = smaller};
  for (HardCase& c : settings()) in.hard.push_back(std::move(c));
  for (const char* branch :
       {"threshold_constant", "threshold_weber", "still", "moving", "half_plain", "half_extra", "foveation_off",
        "foveation_on", "border_none", "border_safe", "params_usual", "params_all_full", "params_odd",
        "picture_patchwork", "picture_flat", "picture_noise", "picture_steps", "blended_none", "blended_some"})
    in.branches.emplace_back(branch);
  return in;
}

std::vector<Mutant> mutants() {
  return {{"common.glsl", 1, "beyond the sides the outermost pixel goes on", "sweep"},
          {"common.glsl", 2, "differences of even pixels alone", "slopes"},
          {"common.glsl", 3, "pixels beyond the sides count", "sweep"},
          {"common.glsl", 4, "the border is the middle", "safe_border"},
          {"common.glsl", 5, "motion is forgotten", "sweep_moving"},
          {"common.glsl", 6, "1x1 is allowed where 2x2 is not quite good enough", "sweep_extra_half"},
          {"common.glsl", 7, "the last cell of a tile is left out", "sweep"},
          {"common.glsl", 8, "blended surfaces refine", "blended_coarser"}};
}

}  // namespace assay::vrcs_shading_rate
