// How far the deblocked picture is from one shaded at full rate, beside the picture of copies: PSNR over a synthetic
// scene.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "harness/half.h"
#include "harness/vrcs_scene.h"
#include "kernels/vrcs_deblock/inputs.h"

namespace assay::vrcs_deblock {

namespace {

constexpr uint kSide = 512;

double stripes_18(double x, double) { return vrcs::stripes(x, 18); }
double stripes_5(double x, double) { return vrcs::stripes(x, 5.2); }

// Moved to the right and about half as far down.
Picture shaded(double (*at)(double, double), uint rate, double moved) {
  return at_rate(painted({kSide, kSide}, [=](uint x, uint y) { return grey(at(x - moved, y - 0.55 * moved)); }), rate);
}

// Discs, each its own surface nearer than the scene, all of triangles of 10 pixels.
Picture silhouettes() {
  Picture p = shaded(vrcs::scene, kRate2x2, 0);
  for (uint y = 0; y < kSide; ++y)
    for (uint x = 0; x < kSide; ++x) {
      const uint column = x / 64, row = y / 64;
      const bool disc = std::hypot(x % 64 - 31.5, y % 64 - 31.5) < 20;
      p.visibility[p.place(x, y)] = uvec2(x / 10 + y / 10 * 128, disc ? 1 + column + row * 16 : 0);
      p.depth[p.place(x, y)] = disc ? 0.05f : 0.01f;
      if (disc) p.texels[p.place(x, y)] = grey(2 * vrcs::scene(y, x));
    }
  return p;
}

struct Class {
  std::string_view name;
  const char* why;
  uint rate;
  double moved;
  double (*at)(double, double);  // none: silhouettes
};
constexpr Class kClasses[] = {{"2x1", "uniform, static", kRate2x1, 0, vrcs::scene},
                              {"1x2", "uniform, static", kRate1x2, 0, vrcs::scene},
                              {"2x2", "uniform, static", kRate2x2, 0, vrcs::scene},
                              {"2x1, moved 0.37", "off the pixel grid", kRate2x1, 0.37, vrcs::scene},
                              {"1x2, moved 0.37", "off the pixel grid", kRate1x2, 0.37, vrcs::scene},
                              {"2x2, moved 0.37", "off the pixel grid", kRate2x2, 0.37, vrcs::scene},
                              {"2x1, moved 3.3", "three pixels on", kRate2x1, 3.3, vrcs::scene},
                              {"1x2, moved 3.3", "three pixels on", kRate1x2, 3.3, vrcs::scene},
                              {"2x2, moved 3.3", "three pixels on", kRate2x2, 3.3, vrcs::scene},
                              {"2x1, stripes of 18", "slow change is mended well", kRate2x1, 0, stripes_18},
                              {"2x1, stripes of 5.2", "quick change is not", kRate2x1, 0, stripes_5},
                              {"2x2, silhouettes", "surfaces and triangles", kRate2x2, 0, nullptr}};

Picture picture_of(const Class& c) { return c.at ? shaded(c.at, c.rate, c.moved) : silhouettes(); }

using Values = std::vector<double>;
Values values(std::span<const Texel> texels) {
  Values v;
  for (const Texel& t : texels) v.push_back(half_value(t[0]));
  return v;
}

// Mean square over the pixels that have all neighbours.
template <class Of>
double mean_square(const Of& of) {
  double sum = 0;
  for (size_t y = 1; y + 1 < kSide; ++y)
    for (size_t x = 1; x + 1 < kSide; ++x) sum += std::pow(of(y * kSide + x), 2);
  return sum / std::pow(kSide - 2.0, 2);
}
double mean_square_of_difference(const Values& a, const Values& b) {
  return mean_square([&](size_t i) { return a[i] - b[i]; });
}

// What the mean of neighbours can be off by, all of it on the phase of the duplicates (README, Error).
double largest_mean_square(const Values& v, uint rate) {
  const auto off = [&](size_t side) {
    return mean_square([&](size_t i) { return v[i] - (v[i - side] + v[i + side]) / 2; });
  };
  const double across = rate / 4 != 0 ? off(1) : 0, down = rate % 4 != 0 ? off(kSide) : 0;
  const double corners = rate != kRate2x2 ? 0 : mean_square([&](size_t i) {
    return v[i] - (v[i - kSide - 1] + v[i - kSide + 1] + v[i + kSide - 1] + v[i + kSide + 1]) / 4;
  });
  return across + down + corners;
}

double decibels(double mean_square) { return -10 * std::log10(mean_square); }

std::vector<Figure> figures(const Class& of, const Case& c, const std::map<std::string, Bytes>& written) {
  const auto port = written.find("deblocked_radiance");
  const Bytes& bytes = port != written.end() ? port->second : written.at("radiance_in_place");
  const Values truth = values(picture_of(of).texels), copied = values(c.input<Texel>("radiance"));
  const Values got = values({reinterpret_cast<const Texel*>(bytes.data()), bytes.size() / sizeof(Texel)});
  const double before = mean_square_of_difference(copied, truth), after = mean_square_of_difference(got, truth);
  std::vector<Figure> all = {{"copied, dB", decibels(before)},
                             {"deblocked, dB", decibels(after)},
                             {"gained, dB", decibels(after) - decibels(before)}};
  if (of.at) all.push_back({"of the largest error", std::sqrt(after / largest_mean_square(truth, of.rate)), 1});
  return all;
}

}  // namespace

ErrorTable error_table() {
  ErrorTable table;
  for (const Class& c : kClasses)
    table.classes.push_back({std::string(c.name), c.why, [c] {
                               Case made = case_of(picture_of(c));
                               made.name = c.name;
                               return made;
                             }});
  table.figures = [](const Variant& v, const Case& c, const std::map<std::string, Bytes>& written) {
    if (v.name == "luma_alone") return std::vector<Figure>();
    return figures(*std::ranges::find(kClasses, c.name, &Class::name), c, written);
  };
  return table;
}

}  // namespace assay::vrcs_deblock
