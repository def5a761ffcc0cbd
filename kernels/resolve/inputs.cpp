#include "kernels/resolve/inputs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/crop.h"
#include "harness/half.h"
#include "harness/tone_curve.h"
#include "kernels/resolve/layout.h"

namespace assay::resolve {
namespace {

using Texel = std::array<uint16_t, 4>;

Texel texel(double red, double green, double blue, double alpha = 1) {
  return {nearest_half(red), nearest_half(green), nearest_half(blue), nearest_half(alpha)};
}
Texel grey(double v) { return texel(v, v, v); }

struct Picture {
  Extent extent = {};
  ResolveParams params = {0, 0, kMeterMean, 1, 1};
  std::vector<Texel> texels = {};
};

template <class F>
Picture filled(Extent e, F at) {
  Picture p = {.extent = e};
  p.texels.reserve(pixel_count(e));
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) p.texels.push_back(at(x, y));
  return p;
}

void set_curve(Case& c) {
  static const std::vector<float> thresholds = code_thresholds();
  c.set_input("thresholds", thresholds);
  c.set_input("first_codes", bucket_codes(thresholds));
}

Case to_case(const std::string& name, const Picture& p) {
  Case c = {.name = name, .extent = p.extent};
  ResolveParams params = p.params;
  params.width = p.extent.width, params.height = p.extent.height;
  c.set_params(params);
  c.set_input("radiance", p.texels);
  set_curve(c);
  return c;
}

double normal(Pcg32& rng) {  // Box and Muller 1958
  return std::sqrt(-2 * std::log(1 - rng.unit())) * std::cos(6.283185307179586 * rng.unit());
}

Texel log_normal(Pcg32& rng, double median, double sigma) {
  const double v = std::min(median * std::exp(sigma * normal(rng)), 20000.0);
  return texel(v * rng.range(0.5, 1.5), v * rng.range(0.5, 1.5), v * rng.range(0.5, 1.5));
}

void add_rectangles(Picture& p, Pcg32& rng) {
  for (uint32_t i = 0; i < 20; ++i) {
    const uint32_t x0 = rng.below(p.extent.width), y0 = rng.below(p.extent.height);
    const uint32_t x1 = std::min(p.extent.width, x0 + 1 + rng.below(p.extent.width / 2 + 8));
    const uint32_t y1 = std::min(p.extent.height, y0 + 1 + rng.below(p.extent.height / 2 + 8));
    const Texel t = log_normal(rng, 0.3, 1.5);
    for (uint32_t y = y0; y < y1; ++y)
      for (uint32_t x = x0; x < x1; ++x) p.texels[size_t{y} * p.extent.width + x] = t;
  }
}

std::function<Case()> made(std::function<Picture()> make) {
  return [make = std::move(make)] { return to_case("", make()); };
}

// A named picture of N6's size, cut to `e`.
template <class F>
HardCase sum_of(const char* name, const char* why, Extent e, F at, bool nightly = false) {
  return {name, why, made([=] { return filled(e, at); }), nightly};
}

Picture metered_by(Picture p, uint32_t metering, float manual = 1, float compensation = 1) {
  p.params.metering = metering, p.params.manual_exposure = manual, p.params.compensation = compensation;
  return p;
}

Picture ramp(Extent e) {
  return filled(e, [e](uint32_t x, uint32_t y) {
    const double t = double(x + e.width * y) / double(pixel_count(e));
    return texel(8 * t, 0.5 * t * t, std::exp2(20 * t - 12));
  });
}

// All halves from 0 up in turn, so that every one is red somewhere.
Picture every_half() {
  return filled({256, 256}, [](uint32_t x, uint32_t y) {
    const auto bits = static_cast<uint16_t>(y * 256 + x);
    return Texel{bits, static_cast<uint16_t>(bits ^ 0x8000u), static_cast<uint16_t>(bits + 77), 0x3c00};
  });
}

std::vector<HardCase> size_cases() {
  const auto at = [](Extent e) { return made([e] { return ramp(e); }); };
  return {{"one_pixel", "one lane of one group is alive", at({1, 1})},
          {"block", "exactly one block of 128x128 pixels", at({128, 128})},
          {"block_less_one", "the block's last row and column are off the screen", at({127, 127})},
          {"block_and_one", "three more blocks for one row and one column", at({129, 129})},
          {"odd_extent", "rows that start in the middle of a subgroup of any width", at({31, 33})},
          {"wide", "width and height cannot be swapped", at({500, 3})},
          {"many_blocks", "more blocks than threads in the last pass", at({11009, 257})},
          {"full_hd_and_one", "an odd extent of real size", at({1921, 1081})},
          {"ultra_hd", "3840x2160, the largest frame", at({3840, 2160}), true}};
}

// The inputs whose sums go wrong: constants in a chain, one bright pixel first, magnitudes far apart.
std::vector<HardCase> sum_cases() {
  const Extent hd = {1920, 1080}, uhd = {3840, 2160};
  const auto constant = [](uint32_t, uint32_t) { return grey(0.1); };
  const auto alternating = [](uint32_t x, uint32_t y) { return grey((x + y) % 2 ? 6e4 : 1e-4); };
  return {
      sum_of("constant_tenth", "0.1 in a chain drifts by 5 %: every rounding goes one way", hd, constant),
      sum_of("constant_tenth_ultra_hd", "the same over 8.3 million pixels", uhd, constant, true),
      sum_of("constant_third", "as 0.1, the other way", hd, [](uint32_t, uint32_t) { return grey(1.0 / 3); }),
      sum_of("one_bright_pixel", "6e4 first, then 1e-3: a chain loses what follows", hd,
             [](uint32_t x, uint32_t y) { return grey(x + y == 0 ? 6e4 : 1e-3); }),
      sum_of("alternating", "1e-4 beside 6e4", hd, alternating),
      sum_of("alternating_ultra_hd", "the same over 8.3 million pixels", uhd, alternating, true),
      sum_of("bright_half", "1e4 above, 0.01 below", hd,
             [](uint32_t, uint32_t y) { return grey(y < 540 ? 1e4 : 0.01); }),
      sum_of("dark_half_first", "0.01 above, 1e4 below", hd,
             [](uint32_t, uint32_t y) { return grey(y < 540 ? 0.01 : 1e4); }),
      {"log_normal", "sigma 2, as high-dynamic-range pictures are", made([] {
         Pcg32 rng(1);
         return filled({1920, 1080}, [&](uint32_t, uint32_t) { return log_normal(rng, 0.2, 2); });
       })},
      {"log_mean", "the mean of logarithms, black pixels among them", made([] {
         Pcg32 rng(2);
         return metered_by(
             filled({300, 200}, [&](uint32_t x, uint32_t) { return x % 5 ? log_normal(rng, 0.2, 2) : grey(0); }),
             kMeterLogMean);
       })},
      {"log_mean_about_one", "logarithms about 0 cancel in the sum", made([] {
         return metered_by(filled({300, 200}, [](uint32_t x, uint32_t y) { return grey((x + y) % 2 ? 1.5 : 0.667); }),
                           kMeterLogMean);
       })},
  };
}

std::vector<HardCase> exposure_cases() {
  const auto black = [](uint32_t, uint32_t) { return grey(0); };
  return {
      {"all_black", "the mean is 0: the exposure ends at the least mean", made([=] {
         return filled({200, 130}, black);
       })},
      {"all_black_logarithm", "the logarithm of 0", made([=] {
         return metered_by(filled({200, 130}, black), kMeterLogMean);
       })},
      {"blinding", "every pixel at the largest half", made([] {
         return filled({200, 130}, [](uint32_t, uint32_t) { return grey(65504); });
       })},
      {"blinding_manual", "infinities and the largest half are white, whatever a table ends at", made([] {
         return metered_by(
             filled({64, 64}, [](uint32_t x, uint32_t) { return grey(x % 2 ? 65504 : std::exp2(x % 20)); }),
             kMeterManual);
       })},
      {"nothing_counts", "only background: exposure 1, compensated", made([] {
         return metered_by(filled({140, 140}, [](uint32_t, uint32_t) { return texel(0.3, 0.2, 0.1, 0); }), kMeterMean,
                           1, 2);
       })},
      {"background", "a bright background around one dark surface does not count", made([] {
         return filled({150, 150}, [](uint32_t x, uint32_t y) {
           return x / 32 == 1 && y / 32 == 1 ? grey(0.02) : texel(900, 900, 900, 0);
         });
       })},
      {"manual", "given exposure: nothing is summed, and the codes are exact", made([] {
         return metered_by(ramp({400, 100}), kMeterManual, 0.37f, 1.7f);
       })},
      {"every_half", "all 65,536 halves in every channel, NaN, infinities and negative ones too; exposure 1",
       made([] { return metered_by(every_half(), kMeterManual); })},
      {"every_half_metered", "the same, metered: what is no number does not count", made([] { return every_half(); })},
      {"at_the_thresholds", "exposed radiance of the thresholds themselves and a float below: >= or >", made([] {
         // Of radiance 1, the exposure is the exposed radiance.
         Picture p = metered_by(filled({3, 1}, [](uint32_t, uint32_t) { return grey(1); }), kMeterManual);
         p.params.manual_exposure = code_thresholds()[137];
         return p;
       })},
      {"below_a_threshold", "one float below a threshold", made([] {
         Picture p = metered_by(filled({3, 1}, [](uint32_t, uint32_t) { return grey(1); }), kMeterManual);
         p.params.manual_exposure = std::nextafter(code_thresholds()[137], 0.0f);
         return p;
       })},
      {"channels_apart", "red, green and blue cannot be swapped, nor their weights", made([] {
         return filled({64, 64}, [](uint32_t x, uint32_t y) { return texel(0.9 * (x % 3 == 0), 0.5 * (y % 2), 0.2); });
       })},
      {"no_numbers", "NaN and infinities in each channel and in alpha", made([] {
         return filled({99, 77}, [](uint32_t x, uint32_t y) {
           const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(), -3};
           Texel t = texel(0.3, 0.2, 0.1);
           if (x % 4 == 0) t[y % 4] = half_bits(bad[x / 4 % 4]);
           return t;
         });
       })},
      {"stops", "compensated by 16 stops either way", made([] {
         return metered_by(ramp({200, 200}), kMeterMean, 1, 0x1p-16f);
       })},
  };
}

}  // namespace

Case random_case(Random& r) {
  const Extent extent = random_extent(r, 32);
  const double median = std::exp2(r.rng.range(-10, 8)), sigma = r.rng.range(0, 2);
  Picture p;
  switch (r.branch({{"log_normal", 0.5}, {"constant", 0.15}, {"noise", 0.15}, {"rectangles", 0.2}})) {
    case 0:
      p = filled(extent, [&](uint32_t, uint32_t) { return log_normal(r.rng, median, sigma); });
      break;
    case 1:
      p = filled(extent, [&](uint32_t, uint32_t) { return grey(median); });
      break;
    case 2:  // every bit pattern is a picture
      p = filled(extent, [&](uint32_t, uint32_t) {
        Texel t;
        for (uint16_t& half : t) half = static_cast<uint16_t>(r.rng.next());
        return t;
      });
      break;
    default:
      p = filled(extent, [&](uint32_t, uint32_t) { return grey(median); });
      add_rectangles(p, r.rng);
  }
  if (r.branch({{"all_covered", 0.6}, {"holes", 0.4}}) != 0)
    for (Texel& t : p.texels)
      if (r.rng.below(3) == 0) t[3] = 0;
  const uint32_t meters[] = {kMeterMean, kMeterLogMean, kMeterManual, 77};
  p.params.metering =
      meters[r.branch({{"mean", 0.5}, {"log_mean", 0.2}, {"manual", 0.25}, {"unknown_metering", 0.05}})];
  p.params.manual_exposure = static_cast<float>(0.2 / median);
  p.params.compensation = static_cast<float>(std::exp2(r.rng.range(-3, 3)));
  return to_case("random", p);
}

std::vector<std::string> branches() {
  std::vector<std::string> all = kExtentBranches;
  for (const char* b : {"log_normal", "constant", "noise", "rectangles", "all_covered", "holes", "mean", "log_mean",
                        "manual", "unknown_metering"})
    all.push_back(b);
  return all;
}

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto& more : {size_cases(), sum_cases(), exposure_cases()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case part = c;
    auto params = c.params<ResolveParams>();
    params.width = crop.size.width, params.height = crop.size.height;
    part.extent = crop.size;
    part.set_params(params);
    part.set_input("radiance", cropped(c.input<Texel>("radiance"), c.extent, crop));
    found.push_back(std::move(part));
  }
  return found;
}

Case typical(Extent extent) {
  Pcg32 rng(1);
  return to_case("typical", filled(extent, [&](uint32_t, uint32_t) { return log_normal(rng, 0.3, 1.2); }));
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(ResolveParams{f.extent.width, f.extent.height, kMeterMean, 1, std::exp2(f.exposure_stops)});
  set_curve(c);
  return c;
}

}  // namespace assay::resolve
