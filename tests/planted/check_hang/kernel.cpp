// A kernel whose hard case `endless` outlasts the wait for it, and whose others do not.
#include "harness/kernel.h"

#include <algorithm>
#include <thread>

#include "harness/oracle.h"
#include "tests/planted/check_hang/layout.h"

namespace assay::check_hang {

namespace {

Case turning(uint32_t count, uint32_t turns) {
  Case c{.extent = {count, 1}};
  c.set_params(HangParams{count, turns});
  return c;
}

// Seconds on a CPU, however many processors it has: 65,536 invocations each, 65,535 turns an invocation. On a GPU, too.
Case endless() { return turning(std::max(std::thread::hardware_concurrency(), 1u) << 16, 4096); }

uint64_t ends(const Case& c) { return c.params<HangParams>().count; }

Answer oracle(const Case& c) {
  const auto [count, turns] = c.params<HangParams>();
  std::vector<uint32_t> words(count);
  const uint32_t all = turns > 1000 ? 0 : turns * turns;  // nobody lives to compare the others
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t word = i;
    for (uint32_t turn = 0; turn < all; ++turn) word = (word * 1664525u + 1013904223u) ^ word >> 9;
    words[i] = word;
  }
  return {{"ends", expect_all(words)}};
}

Groups groups(const Case& c) { return {ceil_div(c.params<HangParams>().count, 256)}; }

}  // namespace

Kernel describe();
Kernel describe() {
  return {
      .name = "check_hang",
      .source = "planted",
      .default_variant = "turns",
      .params = layout_of<HangParams>(),
      .ports = {writes<uint32_t>("ends", ends)},
      .variants = {{.name = "turns", .passes = {Dispatch{"turns.comp", groups}}}},
      .oracle = oracle,
      .inputs = {.hard = {{"endless", "outlasts any wait that a test can afford", endless},
                          {"short", "runs after it, on a fresh device", [] { return turning(100, 3); }}}},
      .bounds = {exact("ends", "integers only")},
  };
}

}  // namespace assay::check_hang
