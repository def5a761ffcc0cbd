// One correct variant and one for each fault that the checker must find.
#include "harness/kernel.h"

#include <algorithm>

#include "harness/oracle.h"
#include "tests/planted/check_faults/layout.h"

namespace assay::check_faults {

namespace {

constexpr uint32_t kSpare = 4;  // elements of the list behind its live run

Case case_of(Extent extent, const std::vector<uint32_t>& values) {
  Case c{.extent = extent};
  c.set_params(FaultParams{static_cast<uint32_t>(values.size())});
  c.set_input("values", values);
  return c;
}

Answer oracle(const Case& c) {
  std::vector<Pair> pairs;
  const auto values = c.input<uint32_t>("values");
  for (const uint32_t v : values) pairs.push_back({3 * v + 1, static_cast<float>(v * 0.5)});
  const auto bytes = std::as_bytes(std::span(pairs));
  Expected list{.low = c.inputs.at("values")};
  list.live = {{0, values.size()}};
  return {{"pairs", {.low = Bytes(bytes.begin(), bytes.end())}}, {"list", list}};
}

Case random(Random& r) {
  const Extent extent = random_extent(r, 32);
  std::vector<uint32_t> values(pixel_count(extent));
  for (uint32_t& v : values) v = r.rng.below(1000);
  values[r.rng.below(static_cast<uint32_t>(values.size()))] = 7;
  return case_of(extent, values);
}

// The upper and the lower half.
std::vector<Case> smaller(const Case& c) {
  const auto values = c.input<uint32_t>("values");
  if (values.size() < 2) return {};
  std::vector<Case> cases;
  const size_t half = values.size() / 2;
  for (const auto& part : {values.subspan(half), values.first(half)})
    cases.push_back(case_of({static_cast<uint32_t>(part.size()), 1}, {part.begin(), part.end()}));
  return cases;
}

Case numbers(uint32_t first, uint32_t count) {
  std::vector<uint32_t> values(count);
  for (uint32_t i = 0; i < count; ++i) values[i] = first + i;
  return case_of({count, 1}, values);
}

Groups groups(const Case& c) { return {ceil_div(c.params<FaultParams>().count, 64)}; }

Variant variant(const char* name) { return {.name = name, .passes = {Dispatch{std::string(name) + ".comp", groups}}}; }

Cost cost(const Case& c) {
  return {.bytes_read = 4 * pixels(c), .bytes_written = 12 * pixels(c) + uint64_t{4} * kSpare, .operations = pixels(c)};
}

}  // namespace

Kernel describe() {
  return {
      .name = "check_faults",
      .source = "planted",
      .default_variant = "correct",
      .params = layout_of<FaultParams>(),
      .ports = {reads<uint32_t>("values", pixels), writes<Pair>("pairs", pixels),
                writes<uint32_t>("list", [](const Case& c) { return pixels(c) + kSpare; })},
      .variants = {variant("correct"), variant("stray"), variant("unwritten"), variant("half_written"),
                   variant("touched"), variant("input_written"), variant("wrong_value"), variant("reversed"),
                   variant("repeated"), variant("not_a_number")},
      .oracle = oracle,
      .inputs = {.random = random,
                 .branches = kExtentBranches,
                 .hard = {{"marked", "holds a 7", [] { return numbers(0, 100); }},
                          {"unmarked", "holds none", [] { return numbers(100, 65); }}},
                 .smaller = smaller},
      .bounds = {ulps("pairs", 1, "one rounding"), same_set("list", "any order")},
      .mutants = {{"body.glsl", 1, "key one less", "marked"},
                  {"body.glsl", 2, "half one more", "unmarked"},
                  {"body.glsl", 3, "none", "marked"},
                  {"body.glsl", 4, "one element behind the end", "marked"}},
      .cost = cost,
      .typical = [](Extent e) { return numbers(100, static_cast<uint32_t>(pixel_count(e))); },
      .extents = {{64, 64}},
  };
}

}  // namespace assay::check_faults
