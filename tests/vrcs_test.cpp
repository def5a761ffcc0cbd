// What the estimators of shading rates promise: copied, or averaged again, no tile is off by more than they say,
// whatever the picture and whichever pixels are shaded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/formats/visibility.h"
#include "harness/half.h"
#include "harness/oracle.h"
#include "harness/study/pictures.h"
#include "harness/tone_curve.h"
#include "kernels/deferred_lighting/inputs.h"
#include "kernels/deferred_lighting/sources.h"
#include "kernels/vrcs_shading_rate/oracle.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

using namespace vrcs_shading_rate;

struct Picture {
  Extent size;
  std::vector<int> codes;
  bool has(int64_t x, int64_t y) const { return x >= 0 && y >= 0 && x < size.width && y < size.height; }
  int at(int64_t x, int64_t y) const { return codes[static_cast<size_t>(y * size.width + x)]; }
};

Picture random_picture(Pcg32& rng) {
  Picture p{{1 + rng.below(40), 1 + rng.below(40)}, {}};
  const uint32_t kind = rng.below(4), reach = 1 + rng.below(255);
  const double slope_x = rng.range(-6, 6), slope_y = rng.range(-6, 6);
  for (uint32_t y = 0; y < p.size.height; ++y)
    for (uint32_t x = 0; x < p.size.width; ++x) {
      const double ramp = 128 + slope_x * (x - 20.0) + slope_y * (y - 20.0);
      const int noise = static_cast<int>(rng.below(reach)),
                stripes = (kind == 2 ? x : y) % 2 ? 0 : static_cast<int>(reach) - 1;
      p.codes.push_back(kind == 0 ? noise : kind == 1 ? std::clamp(static_cast<int>(ramp), 0, 255) : stripes);
    }
  return p;
}

// A uniform rate: the pixel of each whole cell that is shaded is the first, or the last.
struct Rate {
  bool across, down, last;
};
// Where the shaded pixel of a pixel's group lies from it, along each axis; none for those that are shaded.
glm::ivec2 to_primary(const Picture& p, const Rate& r, uint32_t x, uint32_t y) {
  if ((r.across && !p.has(x | 1, y)) || (r.down && !p.has(x, y | 1))) return {0, 0};  // half a cell
  const auto along = [&](bool shared, uint32_t i) {
    if (!shared || (i & 1) == (r.last ? 1u : 0u)) return 0;
    return i & 1 ? -1 : 1;
  };
  return {along(r.across, x), along(r.down, y)};
}

double copied(const Picture& p, int64_t x, int64_t y, glm::ivec2 off) { return p.at(x + off.x, y + off.y); }

// The mean of the neighbours on the pixel's own axes, those that the picture has.
double averaged(const Picture& p, int64_t x, int64_t y, glm::ivec2 off) {
  double sum = 0, count = 0;
  for (const int dx : {-1, 1})
    for (const int dy : {-1, 1}) {
      const int64_t at_x = off.x ? x + dx : x, at_y = off.y ? y + dy : y;
      if (p.has(at_x, at_y)) sum += p.at(at_x, at_y), count += 1;
    }
  return sum / count;
}

template <class Rebuild>
double squared_error(const Picture& p, const Rate& r, uint32_t side, uint32_t column, uint32_t row, Rebuild rebuild) {
  double sum = 0, pixels = 0;
  for (uint32_t y = row * side; y < std::min((row + 1) * side, p.size.height); ++y)
    for (uint32_t x = column * side; x < std::min((column + 1) * side, p.size.width); ++x) {
      const glm::ivec2 off = to_primary(p, r, x, y);
      pixels += 1;
      if (off.x || off.y) sum += std::pow(rebuild(p, x, y, off) - p.at(x, y), 2);
    }
  return sum / pixels;
}

// Tiles of 2 and 8 pixels, both pixels of a cell shaded in turn. Returns how many were asked.
template <class Rebuild>
uint64_t expect_bounded(const Picture& p, Estimator estimator, Rebuild rebuild) {
  const Codes codes = [&p](int64_t x, int64_t y) { return p.at(x, y); };
  uint64_t tiles = 0, over = 0;
  for (const uint32_t side : {2u, 8u})
    for (uint32_t row = 0; row * side < p.size.height; ++row)
      for (uint32_t column = 0; column * side < p.size.width; ++column) {
        const Errors e = errors_of(estimator, p.size, side, column, row, codes);
        for (const bool last : {false, true}) {
          tiles += 1;
          for (const auto& [rate, most] : {std::pair(Rate{true, false, last}, e.across),
                                           {Rate{false, true, last}, e.down},
                                           {Rate{true, true, last}, e.both}})
            over += !(squared_error(p, rate, side, column, row, rebuild) <= most * (1 + 1e-12));
        }
      }
  EXPECT_EQ(over, 0u) << "of " << tiles << " tiles by " << name_of(estimator);
  return tiles;
}
uint64_t expect_both_bounded(const Picture& p) {
  return expect_bounded(p, Estimator::first_difference, copied) +
         expect_bounded(p, Estimator::second_difference, averaged);
}

TEST(Vrcs, DifferencesBoundWhatCopiesAndAveragesAreOff) {
  Pcg32 rng(1);
  uint64_t tiles = 0;
  for (int trial = 0; trial < 5000; ++trial) tiles += expect_both_bounded(random_picture(rng));
  EXPECT_GT(tiles, 2000000u);
}

// Luma as the deblocker makes it: Rec. 709's weights in 2^16ths, of displayed codes.
Picture luma_of(const study::Picture& p) {
  std::vector<uint32_t> code(65536);
  for (uint32_t h = 0; h < code.size(); ++h) code[h] = code_of(half_value(static_cast<uint16_t>(h)), p.exposure);
  Picture luma = {p.size, {}};
  for (const study::Texel& t : p.radiance)
    luma.codes.push_back(
        static_cast<int>((13933 * code[t[0]] + 46871 * code[t[1]] + 4732 * code[t[2]] + 32768) / 65536));
  return luma;
}

constexpr uint32_t kCut = 320;  // pixels a side of the study's pictures: for time

TEST(Vrcs, TheBoundsHoldOnTheSyntheticScene) {
  EXPECT_EQ(expect_both_bounded(luma_of(study::synthetic(kCut))), 4u * (160 * 160 + 40 * 40));
}
TEST(Vrcs, TheBoundsHoldOnAFrame) {
  const Picture luma = luma_of(study::frame(*device(), "small", "", {kCut, 180}));
  EXPECT_GT(expect_both_bounded(luma), 50000u);
}
TEST(Vrcs, TheBoundsHoldOnPhotographs) {
  const auto files = study::photographs();
  if (files.empty())
    GTEST_SKIP() << "no images in " << study::data_folder() / "hdr"
                 << "; set ASSAY_DATA to the folder that holds hdr/";
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename());
    EXPECT_GT(expect_both_bounded(luma_of(cut(study::photograph(file), kCut))), 50000u);
  }
}

// The bounds are no slacker than they must be: here all of the difference falls on copied pixels.
TEST(Vrcs, TheBoundsAreReached) {
  Picture p{{16, 16}, {}};
  for (int i = 0; i < 256; ++i) p.codes.push_back((i + 1) % 4 < 2 ? 10 : 30);  // pairs of columns, across the cells
  const Codes codes = [&p](int64_t x, int64_t y) { return p.at(x, y); };
  EXPECT_EQ(squared_error(p, {true, false, false}, 8, 0, 1, copied),
            errors_of(Estimator::first_difference, p.size, 8, 0, 1, codes).across);
}

// Whatever the rates, a lit pixel comes out once: shaded or copied where something covers it, background elsewhere.
using deferred_lighting::Sources;

void expect_once(const Case& c, const Sources& s, const std::string& name) {
  const auto visibility = c.input<uvec2>("visibility");
  EXPECT_TRUE(s.others.empty()) << name;
  uint64_t wrong = 0;
  for (size_t i = 0; i < s.first.size(); ++i) {
    const bool is_covered = visibility[i] != uvec2(kVisibilityNone);
    wrong += is_covered ? s.first[i] >= s.first.size() : s.first[i] != deferred_lighting::kFromNowhere;
  }
  EXPECT_EQ(wrong, 0u) << name;
}
void expect_once(const Case& c, const std::string& name) {
  expect_once(c, deferred_lighting::sources_by_tiles(c), name + " by tiles");
  expect_once(c, deferred_lighting::sources_by_list(c), name + " by list");
}

TEST(Vrcs, EveryLitPixelComesOutOnce) {
  for (const HardCase& hard : deferred_lighting::sound_primaries())
    if (!hard.nightly) expect_once(hard.make(), hard.name);
  uint32_t sound = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    Random r(seed);
    const Case c = deferred_lighting::random_case(r);
    if (r.taken.contains("lists_spoilt")) continue;
    expect_once(c, "seed " + std::to_string(seed));
    ++sound;
  }
  EXPECT_GE(sound, 15u);
}

}  // namespace
}  // namespace assay::tests
