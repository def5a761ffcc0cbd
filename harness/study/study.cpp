#include "harness/study/study.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "harness/half.h"
#include "harness/image/flip.h"
#include "harness/tone_curve.h"

namespace assay::study {

namespace {

constexpr float kTolerances[] = {0.005f, 0.01f, 0.02f, 0.04f, 0.08f};
constexpr float kExtraHalf = 0.5f;

// Of each half, what it is displayed as.
using Shown = std::vector<double>;
Shown shown_at(float exposure) {
  Shown shown(65536);
  for (uint32_t h = 0; h < shown.size(); ++h) shown[h] = displayed(half_value(static_cast<uint16_t>(h)), exposure);
  return shown;
}

image::Pixels pixels_of(const Shown& shown, Extent size, const std::vector<Texel>& radiance) {
  image::Rgba8 codes = {size.width, size.height, {}};
  for (const Texel& t : radiance) {
    for (size_t i = 0; i < 3; ++i) codes.texels.push_back(static_cast<uint8_t>(std::lround(255 * shown[t[i]])));
    codes.texels.push_back(255);
  }
  return linear_of(codes);
}

template <class Counts>
double mean_square(const Shown& shown, const std::vector<Texel>& a, const std::vector<Texel>& b, const Counts& counts) {
  double sum = 0, counted = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (!counts(i)) continue;
    counted += 3;
    for (size_t channel = 0; channel < 3; ++channel) sum += std::pow(shown[a[i][channel]] - shown[b[i][channel]], 2);
  }
  return sum / counted;
}
double mean_square(const Shown& shown, const std::vector<Texel>& a, const std::vector<Texel>& b) {
  return mean_square(shown, a, b, [](size_t) { return true; });
}

// The deblocker's means, of displayed values: a duplicate is the mean of the neighbours on the axes along which it was
// copied. At the picture's sides it stays a copy.
double mean_square_of_shown(const Shown& shown, const Picture& p, const Shaded& s) {
  const auto width = static_cast<size_t>(p.size.width), height = static_cast<size_t>(p.size.height);
  double sum = 0;
  for (size_t i = 0; i < s.from.size(); ++i) {
    const size_t x = i % width, y = i / width;
    const bool across = s.from[i] % width != x, down = s.from[i] / width != y;
    const bool at_side = (across && (x == 0 || x + 1 == width)) || (down && (y == 0 || y + 1 == height));
    const size_t side = (across ? 1 : 0) + (down ? width : 0), other = (across ? 1 : 0) - (down ? width : 0);
    for (size_t channel = 0; channel < 3; ++channel) {
      const auto value = [&](size_t at) { return shown[s.copied[at][channel]]; };
      double mean = value(i);
      if (!at_side && across && down)
        mean = (value(i - side) + value(i + side) + value(i - other) + value(i + other)) / 4;
      else if (!at_side && (across || down))
        mean = (value(i - side) + value(i + side)) / 2;
      sum += std::pow(mean - shown[p.radiance[i][channel]], 2);
    }
  }
  return sum / (3.0 * static_cast<double>(s.from.size()));
}

// Against the picture that the chain was made of.
struct Judge {
  Shown shown;
  image::Pixels reference;
};
Judge judge_of(const Picture& p) {
  Judge j = {.shown = shown_at(p.exposure), .reference = {}};
  j.reference = pixels_of(j.shown, p.size, p.radiance);
  return j;
}
Errors judged(const Judge& j, const Picture& p, const Shaded& s) {
  const auto flip_of = [&](const std::vector<Texel>& radiance) {
    return image::flip(j.reference, pixels_of(j.shown, p.size, radiance)).mean;
  };
  return {.saved = s.saved,
          .flip_copied = flip_of(s.copied),
          .flip_deblocked = flip_of(s.deblocked),
          .square_copied = mean_square(j.shown, p.radiance, s.copied),
          .square_deblocked = mean_square(j.shown, p.radiance, s.deblocked)};
}

constexpr double Errors::*kFields[] = {&Errors::saved, &Errors::flip_copied, &Errors::flip_deblocked,
                                       &Errors::square_copied, &Errors::square_deblocked};
template <class Range>
Errors mean_of(const Range& all) {
  Errors mean;
  for (const Errors& e : all)
    for (const auto field : kFields) mean.*field += e.*field / static_cast<double>(std::size(all));
  return mean;
}

std::vector<std::string> named_or_all(const std::vector<std::string>& estimators) {
  if (!estimators.empty()) return estimators;
  std::vector<std::string> all;
  for (const Variant& v : kernel_named("vrcs_shading_rate").variants) all.push_back(v.name);
  return all;
}

// The constant tolerance that saves half, as near as 14 bisections get: saving grows with it.
Choice halving(Chain& chain, const std::string& estimator) {
  double low = 1e-4, high = 1;
  for (int i = 0; i < 14; ++i) {
    const double middle = std::sqrt(low * high);
    (saved(chain, {estimator, static_cast<float>(middle)}) < 0.5 ? low : high) = middle;
  }
  return {estimator, static_cast<float>(high)};
}

auto key_of(const Choice& c) { return std::tie(c.estimator, c.tolerance, c.weber, c.extra_half); }

void mark_front(std::vector<Row>& rows) {
  const auto beats = [](const Row& a, const Row& b) {
    const Errors x = mean_of(a.errors), y = mean_of(b.errors);
    return x.saved >= y.saved && x.flip_deblocked <= y.flip_deblocked &&
           (x.saved > y.saved || x.flip_deblocked < y.flip_deblocked);
  };
  for (Row& row : rows)
    row.in_front = std::ranges::none_of(
        rows, [&](const Row& other) { return other.input_class == row.input_class && beats(other, row); });
}

}  // namespace

double decibels(double mean_square) { return -10 * std::log10(mean_square); }

std::vector<Choice> choices(const std::vector<std::string>& estimators) {
  std::vector<Choice> all;
  for (const std::string& name : named_or_all(estimators))
    for (const auto& [weber, extra_half] : {std::pair(false, 0.0f), {true, 0.0f}, {false, kExtraHalf}})
      for (const float tolerance : kTolerances) all.push_back({name, tolerance, weber, extra_half});
  return all;
}

std::vector<Outcome> try_all(device::Device& d, const Picture& p, const std::vector<Choice>& all,
                             const std::function<void(uint64_t, uint64_t)>& tell) {
  Chain chain = make_chain(d, p);
  const Judge judge = judge_of(p);
  std::vector<Outcome> outcomes;
  for (size_t motion = 0; motion < std::size(kMotions); ++motion) {
    set_luma(chain, kMotions[motion].right, kMotions[motion].down);
    for (const Choice& choice : all) {
      tell(outcomes.size(), all.size() * std::size(kMotions));
      outcomes.push_back({p.input_class, p.name, motion, choice, judged(judge, p, shade(chain, choice))});
    }
  }
  return outcomes;
}

std::vector<Row> rows_of(const std::vector<Outcome>& outcomes) {
  struct Gathered {
    std::array<std::vector<Errors>, std::size(kMotions)> errors;
  };
  std::vector<Row> rows;
  std::vector<Gathered> gathered;
  std::map<std::tuple<std::string, std::string, float, bool, float>, size_t> places;
  for (const Outcome& o : outcomes) {
    const Choice& c = o.choice;
    const auto [place, is_new] =
        places.insert({{o.input_class, c.estimator, c.tolerance, c.weber, c.extra_half}, rows.size()});
    if (is_new) rows.push_back({.input_class = o.input_class, .choice = c, .errors = {}}), gathered.emplace_back();
    gathered[place->second].errors[o.motion].push_back(o.errors);
  }
  for (size_t i = 0; i < rows.size(); ++i)
    for (size_t motion = 0; motion < std::size(kMotions); ++motion)
      rows[i].errors[motion] = mean_of(gathered[i].errors[motion]);
  mark_front(rows);
  return rows;
}

std::optional<Choice> best_of(const std::vector<Row>& rows) {
  std::optional<Choice> best;
  double most = -1;
  for (const Row& first : rows) {
    double saved = 0;
    bool passes = true;
    for (const Row& row : rows) {
      if (key_of(row.choice) != key_of(first.choice)) continue;
      for (const Errors& e : row.errors) saved += e.saved, passes &= e.flip_deblocked <= kMostFlip;
    }
    if (passes && saved > most) best = first.choice, most = saved;
  }
  return best;
}

std::vector<Halved> at_half(device::Device& d, const Picture& p, const std::vector<std::string>& estimators) {
  Chain chain = make_chain(d, p);
  const Shown shown = shown_at(p.exposure);
  std::vector<Halved> all;
  for (size_t motion = 0; motion < std::size(kMotions); ++motion)
    for (const std::string& name : named_or_all(estimators)) {
      set_luma(chain, kMotions[motion].right, kMotions[motion].down);
      const Choice choice = halving(chain, name);
      const Shaded s = shade(chain, choice);
      set_luma(chain, 0, 0);
      const std::vector<uint32_t> own = shade(chain, choice).from;
      const auto alike = [&](size_t i) { return own[i] == s.from[i]; };
      all.push_back({.choice = choice,
                     .motion = motion,
                     .saved = s.saved,
                     .square_copied = mean_square(shown, p.radiance, s.copied),
                     .square_deblocked = mean_square(shown, p.radiance, s.deblocked),
                     .square_of_shown = mean_square_of_shown(shown, p, s),
                     .own_copied = mean_square(shown, p.radiance, s.copied, alike),
                     .own_deblocked = mean_square(shown, p.radiance, s.deblocked, alike)});
    }
  return all;
}

}  // namespace assay::study
