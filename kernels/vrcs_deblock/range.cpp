// What the race of in_place may make of a picture. Each duplicate is written once, from neighbours that may be old or
// new by then. So it lies in the mean of its neighbours' ranges, and a duplicate's range, as a neighbour, is from its
// copy to what it may become: the least ranges of which that holds, found by growing them from nothing.
#include <algorithm>
#include <cmath>

#include "harness/bounded.h"
#include "harness/half.h"
#include "harness/oracle.h"
#include "kernels/vrcs_deblock/oracle.h"

namespace assay::vrcs_deblock {

namespace {

using Colour = std::array<Interval, 3>;

struct Changing {  // a duplicate with neighbours that count
  size_t pixel;
  Pairs pairs;
};

// Rounding is monotone: the ends of the range come of the ends of its terms.
double rounded_mean(const std::vector<Colour>& seen, const Pairs& pairs, size_t channel, double Interval::*end) {
  float sum = 0;
  for (const auto& [a, b] : pairs) {
    const auto pair = static_cast<float>(seen[a][channel].*end + seen[b][channel].*end);
    sum = static_cast<float>(double{sum} + double{pair});
  }
  return half_value(nearest_half(double{sum} / static_cast<double>(2 * pairs.size())));
}

Interval extremes(const std::vector<Colour>& colours, size_t channel) {
  Interval all = exactly(0);
  for (const Colour& c : colours)
    if (std::isfinite(c[channel].low)) all = hull(all, c[channel]);
  return all;
}

// Whether a neighbour's range grew. `widest` holds every mean, where there is no patience left.
bool grow(std::vector<Colour>& seen, const Changing& d, size_t channel, const Interval* widest) {
  const Interval mean = {rounded_mean(seen, d.pairs, channel, &Interval::low),
                         rounded_mean(seen, d.pairs, channel, &Interval::high)};
  Interval& range = seen[d.pixel][channel];
  const Interval grown = hull(range, mean);
  if (grown.low == range.low && grown.high == range.high) return false;
  range = widest ? hull(grown, *widest) : grown;
  return true;
}

// Ends: ranges are of halves and only grow; past 16 rounds each grows once.
void grow_all(std::vector<Colour>& seen, const std::vector<Changing>& changing) {
  for (size_t channel = 0; channel < 3; ++channel) {
    const Interval widest = extremes(seen, channel);
    bool grew = true;
    for (uint32_t round = 0; grew; ++round) {
      grew = false;
      for (const Changing& d : changing) grew |= grow(seen, d, channel, round < 16 ? nullptr : &widest);
    }
  }
}

Colour colour_of(const Texel& t) {
  return {exactly(half_value(t[0])), exactly(half_value(t[1])), exactly(half_value(t[2]))};
}

ColourRange end_of(const Colour& c, double Interval::*end, uint16_t alpha) {
  return {static_cast<float>(c[0].*end), static_cast<float>(c[1].*end), static_cast<float>(c[2].*end), alpha};
}
float luma_of(const Luma& luma, const ColourRange& c) {
  return luma.of({nearest_half(double{c.red}), nearest_half(double{c.green}), nearest_half(double{c.blue}), 0});
}

// What changes, in runs.
std::vector<Expected::Run> runs_of(const std::vector<Changing>& changing) {
  std::vector<Expected::Run> runs;
  for (const Changing& d : changing) {
    if (runs.empty() || runs.back().first + runs.back().count != d.pixel) runs.push_back({d.pixel, 0});
    ++runs.back().count;
  }
  return runs;
}

template <class T>
Expected expect_ranges(const std::vector<T>& low, const std::vector<T>& high) {
  Expected e = expect_all(low);
  e.high = expect_all(high).low;
  for (uint32_t i = 0; i <= low.size(); ++i) e.first.push_back(i);
  return e;
}

template <class To, class From, class Of>
Bytes unpacked(std::span<const std::byte> from, const Of& of) {
  std::vector<To> to(from.size() / sizeof(From));
  for (size_t i = 0; i < to.size(); ++i) {
    From f;
    std::memcpy(&f, from.data() + i * sizeof(From), sizeof(From));
    to[i] = of(f);
  }
  return expect_all(to).low;
}

}  // namespace

Bytes unpack_texels(std::span<const std::byte> from) {
  return unpacked<ColourRange, Texel>(from, [](const Texel& t) { return end_of(colour_of(t), &Interval::low, t[3]); });
}
Bytes unpack_luma(std::span<const std::byte> from) {
  using Rg8 = std::array<uint8_t, 2>;
  return unpacked<LumaRange, Rg8>(from, [](const Rg8& l) { return LumaRange{1.0f * l[0], 1.0f * l[1]}; });
}

void add_in_place(Answer& to, const Case& c, const std::vector<Kind>& kinds, const Luma& luma) {
  const auto texels = c.input<Texel>("radiance");
  std::vector<Colour> seen;
  std::vector<Changing> changing;
  std::vector<LumaRange> luma_low, luma_high;
  for (size_t i = 0; i < texels.size(); ++i) {
    seen.push_back(colour_of(texels[i]));
    const float own = luma.of(texels[i]);
    luma_low.push_back({own, own});
    if (kinds[i] == Kind::none) continue;
    if (Pairs pairs = pairs_of(c, kinds[i], i, {}); !pairs.empty()) changing.push_back({i, std::move(pairs)});
  }
  luma_high = luma_low;
  grow_all(seen, changing);
  std::vector<ColourRange> low, high;
  for (const Changing& d : changing) {
    Colour becomes;
    for (size_t channel = 0; channel < 3; ++channel)
      becomes[channel] = {rounded_mean(seen, d.pairs, channel, &Interval::low),
                          rounded_mean(seen, d.pairs, channel, &Interval::high)};
    const uint16_t alpha = texels[d.pixel][3];
    low.push_back(end_of(becomes, &Interval::low, alpha)), high.push_back(end_of(becomes, &Interval::high, alpha));
    const auto [least, most] = std::minmax({luma_of(luma, low.back()), luma_of(luma, high.back())});
    luma_low[d.pixel] = {least, least}, luma_high[d.pixel] = {most, most};
  }
  to["radiance_in_place"] = expect_ranges(low, high);
  to["radiance_in_place"].live = runs_of(changing);
  to["luma of in_place"] = expect_ranges(luma_low, luma_high);
}

}  // namespace assay::vrcs_deblock
