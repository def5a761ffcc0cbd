#include "harness/check/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "harness/check/elements.h"
#include "harness/oracle.h"

namespace assay::check {

namespace {

std::vector<uint64_t> judged_elements(const Expected& expected, uint64_t count) {
  if (!expected.judged.empty()) {
    if (!std::ranges::is_sorted(expected.judged) || expected.judged.back() >= count)
      throw std::logic_error("oracle: judged elements not ascending or past the port's end");
    return expected.judged;
  }
  std::vector<uint64_t> all;
  for (const Expected::Run& run : live_runs(expected, count))
    for (uint64_t i = 0; i < run.count; ++i) all.push_back(run.first + i);
  return all;
}

Elements elements_of(const std::vector<Layout>& layouts, const Expected& expected, const std::vector<Bytes>& got) {
  if (layouts.empty() || layouts.size() != got.size())
    throw std::logic_error("a bound judges a port or more, each read back");
  Elements e{.layouts = &layouts, .got = &got};
  e.count = got[0].size() / layouts[0].stride;
  for (uint32_t p = 0; p < layouts.size(); ++p) {
    if (got[p].size() / layouts[p].stride != e.count) throw std::logic_error("a bound joins ports of unequal count");
    for (const Field& f : layouts[p].fields)
      for (uint32_t i = 0; i < f.count; ++i)
        e.components.push_back({p, f.offset + 4 * i, e.stride + f.offset + 4 * i, f.scalar});
    e.stride += layouts[p].stride;
  }
  e.judged = judged_elements(expected, e.count);
  return e;
}

bool is_nan_for_a_number(const Elements& e, uint64_t element, const std::byte* expected) {
  return std::ranges::any_of(e.components, [&](const Component& c) {
    return c.scalar == Scalar::f32 && std::isnan(float_at(got_at(e, element, c))) &&
           !std::isnan(float_at(expected + c.joined));
  });
}

void record(Verdict& v, const Elements& e, uint64_t element, const std::byte* expected, const std::string& note = {}) {
  v.nans += is_nan_for_a_number(e, element, expected);
  if (v.violations++ != 0) return;
  std::vector<std::byte> joined(e.stride);
  join(e, element, joined.data());
  v.element = element;
  v.first = fmt::format("element {}: expected {}, got {}{}", element, describe(e, expected, joined.data()),
                        describe(e, joined.data(), expected), note);
}

// Where the expected element of each judged one lies: the answer holds one a judged element, or one a live element.
std::vector<uint64_t> positions(const Elements& e, const Expected& expected) {
  std::vector<uint64_t> at(e.judged.size());
  if (expected.low.size() == e.judged.size() * e.stride) {
    for (size_t i = 0; i < at.size(); ++i) at[i] = i;
    return at;
  }
  uint64_t rank = 0;
  size_t i = 0;
  for (const Expected::Run& run : live_runs(expected, e.count)) {
    for (; i < at.size() && e.judged[i] < run.first + run.count; ++i) {
      if (e.judged[i] < run.first) throw std::logic_error("oracle: judges an element that is not live");
      at[i] = rank + e.judged[i] - run.first;
    }
    rank += run.count;
  }
  if (i != at.size() || expected.low.size() != rank * e.stride)
    throw std::logic_error(
        fmt::format("oracle: {} bytes expected for {} elements of {}", expected.low.size(), rank, e.stride));
  return at;
}

// Error of a component: 0 where it is right, infinite where no limit could pass it.
double error_of(const std::byte* got, const std::byte* want, Scalar s, Judge judge) {
  if (s != Scalar::f32) return word_at(got) == word_at(want) ? 0 : kInfinite;
  const float g = float_at(got), w = float_at(want);
  if (std::isinf(g) || std::isinf(w)) return g == w ? 0 : kInfinite;
  if (judge == Judge::within) {
    const double distance = std::fabs(double{g} - double{w});
    return distance >= 0 ? distance : kInfinite;  // NaN
  }
  const uint64_t ulps = ulp_distance(g, w);
  return ulps == UINT64_MAX ? kInfinite : static_cast<double>(ulps);
}

Verdict judge_near(const Bound& bound, const Elements& e, const Expected& expected) {
  if (e.components.empty()) throw std::logic_error(name_of(bound) + ": texels this small are judged by exact only");
  const auto at = positions(e, expected);
  Verdict v{.judged = e.judged.size()};
  for (size_t i = 0; i < at.size(); ++i) {
    const std::byte* want = expected.low.data() + at[i] * e.stride;
    double error = 0;
    for (const Component& c : e.components)
      error = std::max(error, error_of(got_at(e, e.judged[i], c), want + c.joined, c.scalar, bound.judge));
    v.worst = std::max(v.worst, error);
    if (!(error <= bound.limit)) record(v, e, e.judged[i], want, fmt::format(", error {:.6g}", error));
  }
  return v;
}

Verdict judge_exact(const Elements& e, const Expected& expected) {
  Verdict v{.judged = e.judged.size()};
  const Bytes& whole = (*e.got)[0];
  if (e.layouts->size() == 1 && e.judged.size() == e.count && whole == expected.low) return v;
  const auto at = positions(e, expected);
  std::vector<std::byte> joined(e.stride);
  for (size_t i = 0; i < at.size(); ++i) {
    const std::byte* want = expected.low.data() + at[i] * e.stride;
    join(e, e.judged[i], joined.data());
    if (std::memcmp(joined.data(), want, e.stride) != 0) record(v, e, e.judged[i], want);
  }
  v.worst = static_cast<double>(v.violations);
  return v;
}

using Pointers = std::vector<const std::byte*>;

Pointers sorted_elements(const std::byte* first, uint64_t count, uint32_t stride) {
  Pointers p(count);
  for (uint64_t i = 0; i < count; ++i) p[i] = first + i * stride;
  std::ranges::sort(p, [stride](const std::byte* a, const std::byte* b) { return std::memcmp(a, b, stride) < 0; });
  return p;
}

// Elements of `got` that are not in `want`, as multisets; the first of them and the first that is missing.
void compare_sets(Verdict& v, const Elements& e, const Expected::Run& run, const Pointers& want, const Pointers& got) {
  const auto less = [&e](const std::byte* a, const std::byte* b) { return std::memcmp(a, b, e.stride) < 0; };
  Pointers extra, missing;
  std::ranges::set_difference(got, want, std::back_inserter(extra), less);
  std::ranges::set_difference(want, got, std::back_inserter(missing), less);
  if (extra.empty()) return;
  if (v.violations == 0) {
    v.element = run.first;
    v.first = fmt::format("elements {} to {} as a set: expected {}, got {}; {} of {} differ", run.first,
                          run.first + run.count - 1, describe(e, missing[0], extra[0]),
                          describe(e, extra[0], missing[0]), extra.size(), run.count);
  }
  v.violations += extra.size();
}

Verdict judge_set(const Elements& e, const Expected& expected) {
  if (e.layouts->size() != 1 || !expected.judged.empty())
    throw std::logic_error("same_set judges one port, all live elements");
  if (expected.low.size() != e.judged.size() * e.stride)
    throw std::logic_error("oracle: a set of another size than its runs");
  Verdict v{.judged = e.judged.size()};
  const std::byte* want = expected.low.data();
  for (const Expected::Run& run : live_runs(expected, e.count)) {
    const std::byte* got = (*e.got)[0].data() + run.first * e.stride;
    if (std::memcmp(got, want, run.count * e.stride) != 0)
      compare_sets(v, e, run, sorted_elements(want, run.count, e.stride), sorted_elements(got, run.count, e.stride));
    want += run.count * e.stride;
  }
  v.worst = static_cast<double>(v.violations);
  return v;
}

// How far outside low..high, infinite for NaN.
double outside(const std::byte* got, const std::byte* low, const std::byte* high, Scalar s) {
  const double g = number_at(got, s), l = number_at(low, s), h = number_at(high, s);
  if (l <= g && g <= h) return 0;
  const double distance = g < l ? l - g : g - h;
  return distance > 0 ? distance : kInfinite;
}

bool is_undecided(const Elements& e, const std::byte* low, const std::byte* high, uint32_t alternatives) {
  if (alternatives > 1) return true;
  for (const Component& c : e.components)
    if (c.scalar != Scalar::f32 && word_at(low + c.joined) != word_at(high + c.joined)) return true;
  return false;
}

Verdict judge_between(const Bound& bound, const Elements& e, const Expected& x) {
  if (e.components.empty()) throw std::logic_error(name_of(bound) + ": texels this small are judged by exact only");
  if (x.first.size() != e.judged.size() + 1 || x.low.size() != x.high.size() ||
      x.low.size() != uint64_t{x.first.back()} * e.stride || !std::ranges::is_sorted(x.first))
    throw std::logic_error("oracle: alternatives of " + name_of(bound) + " do not fit the judged elements");
  Verdict v{.judged = e.judged.size()};
  for (size_t i = 0; i < e.judged.size(); ++i) {
    double nearest = kInfinite;
    uint32_t best = x.first[i];
    for (uint32_t a = x.first[i]; a < x.first[i + 1] && nearest != 0; ++a) {
      double distance = 0;
      for (const Component& c : e.components) {
        const uint64_t at = uint64_t{a} * e.stride + c.joined;
        distance =
            std::max(distance, outside(got_at(e, e.judged[i], c), x.low.data() + at, x.high.data() + at, c.scalar));
      }
      if (distance < nearest) best = a;
      nearest = std::min(nearest, distance);
    }
    const uint32_t alternatives = x.first[i + 1] - x.first[i];
    if (alternatives == 0)
      throw std::logic_error("oracle: an element of " + name_of(bound) + " without an alternative");
    const uint64_t at = uint64_t{best} * e.stride;
    v.undecided += is_undecided(e, x.low.data() + uint64_t{x.first[i]} * e.stride,
                                x.high.data() + uint64_t{x.first[i]} * e.stride, alternatives);
    v.worst = std::max(v.worst, nearest);
    if (nearest <= 0) continue;
    const bool interval = std::memcmp(x.low.data() + at, x.high.data() + at, e.stride) != 0;
    record(v, e, e.judged[i], x.low.data() + at,
           (interval ? ", highest admissible " + describe(e, x.high.data() + at, x.low.data() + at) : "") +
               (alternatives > 1 ? fmt::format(" ({} alternatives)", alternatives) : ""));
  }
  return v;
}

// Bits are judged one by one: so many are undecided as may be set or not.
Verdict judge_bits(const Bound& bound, const Elements& e, const Expected& x) {
  if (x.low.size() != x.high.size()) throw std::logic_error("oracle: flags of " + name_of(bound) + " without a limit");
  const auto at = positions(e, x);
  Verdict v;
  for (size_t i = 0; i < at.size(); ++i) {
    uint64_t wrong = 0;
    for (const Component& c : e.components) {
      const uint64_t place = at[i] * e.stride + c.joined;
      const uint32_t low = word_at(x.low.data() + place), high = word_at(x.high.data() + place);
      const uint32_t got = word_at(got_at(e, e.judged[i], c));
      v.judged += 32;
      v.undecided += static_cast<uint64_t>(std::popcount(low ^ high));
      wrong += static_cast<uint64_t>(std::popcount((low & ~got) | (got & ~high)));
    }
    if (wrong == 0) continue;
    v.worst = std::max(v.worst, static_cast<double>(wrong));
    record(v, e, e.judged[i], x.low.data() + at[i] * e.stride, fmt::format(", {} flags wrong", wrong));
  }
  return v;
}

Verdict judge_elements(const Bound& bound, const std::vector<Layout>& layouts, const Expected& expected,
                       const std::vector<Bytes>& got) {
  const Elements e = elements_of(layouts, expected, got);
  switch (bound.judge) {
    case Judge::exact:
      return judge_exact(e, expected);
    case Judge::ulps:
    case Judge::within:
      return judge_near(bound, e, expected);
    case Judge::same_set:
      return judge_set(e, expected);
    case Judge::between:
      return judge_between(bound, e, expected);
    case Judge::bits:
      return judge_bits(bound, e, expected);
  }
  throw std::logic_error("a judge without a comparator");
}

}  // namespace

Verdict judge(const Bound& bound, const std::vector<Layout>& layouts, const Expected& expected,
              const std::vector<Bytes>& got) {
  if (!bound.unpack) return judge_elements(bound, layouts, expected, got);
  if (got.size() != 1) throw std::logic_error(name_of(bound) + ": only a single port is unpacked");
  return judge_elements(bound, {bound.unpack->layout}, expected, {bound.unpack->apply(got[0])});
}

std::string name_of(const Bound& b) {
  constexpr const char* kNames[] = {"exact", "ulps", "within", "same_set", "between", "bits"};
  return fmt::format("{}({})", kNames[static_cast<int>(b.judge)], fmt::join(b.ports, ", "));
}

}  // namespace assay::check
