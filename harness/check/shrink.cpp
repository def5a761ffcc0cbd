#include "harness/check/shrink.h"

#include <algorithm>

namespace assay::check {

namespace {

constexpr size_t kFinestParts = 64;  // of an input, when zeroing

struct Search {
  const std::function<bool(const Case&)>& fails;
  ShrinkLimits limits;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  Shrunk best;

  bool is_over() const {
    return best.attempts >= limits.attempts || std::chrono::steady_clock::now() - start > limits.time;
  }
  bool keeps_failing(const Case& c) {
    ++best.attempts;
    try {
      return fails(c);
    } catch (const std::exception&) {
      return false;  // the generator's or oracle's limits, not the fault that is looked for
    }
  }
  bool take(Case&& c) {
    if (is_over() || !keeps_failing(c)) return false;
    best.input = std::move(c);
    ++best.steps;
    return true;
  }
};

void shrink_by_kernel(Search& search, const Kernel& kernel) {
  if (!kernel.inputs.smaller) return;
  for (bool moved = true; moved && !search.is_over();) {
    moved = false;
    for (Case& candidate : kernel.inputs.smaller(search.best.input)) {
      candidate.seed = search.best.input.seed;
      candidate.name = search.best.input.name;
      if ((moved = search.take(std::move(candidate)))) break;
    }
  }
}

bool is_zero(const Bytes& bytes, size_t from, size_t count) {
  return std::all_of(bytes.begin() + static_cast<ptrdiff_t>(from), bytes.begin() + static_cast<ptrdiff_t>(from + count),
                     [](std::byte b) { return b == std::byte{0}; });
}

void zero_parts(Search& search, const std::string& port) {
  for (size_t parts = 1; parts <= kFinestParts && !search.is_over(); parts *= 2) {
    const size_t size = search.best.input.inputs.at(port).size();
    const size_t part = (size / parts + 3) / 4 * 4;
    if (part == 0 || (parts > 1 && size / parts < 4)) return;
    for (size_t from = 0; from < size && !search.is_over(); from += part) {
      const size_t count = std::min(part, size - from);
      if (is_zero(search.best.input.inputs.at(port), from, count)) continue;
      Case candidate = search.best.input;
      std::fill_n(candidate.inputs.at(port).begin() + static_cast<ptrdiff_t>(from), count, std::byte{0});
      search.take(std::move(candidate));
    }
  }
}

}  // namespace

Shrunk shrink(const Kernel& kernel, Case input, const std::function<bool(const Case&)>& fails, ShrinkLimits limits) {
  Search search{.fails = fails, .limits = limits};
  search.best.input = std::move(input);
  shrink_by_kernel(search, kernel);
  std::vector<std::string> ports;
  for (const auto& [port, bytes] : search.best.input.inputs) ports.push_back(port);
  for (const std::string& port : ports) zero_parts(search, port);
  return std::move(search.best);
}

}  // namespace assay::check
