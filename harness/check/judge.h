// Comparators. Acceptance is positive (error <= limit), so NaN never passes.
#pragma once
#include <optional>
#include <string>

#include "harness/kernel.h"

namespace assay::check {

struct Verdict {
  uint64_t judged = 0, undecided = 0, violations = 0;
  double worst = 0;       // exact, same_set: wrong elements; ulps, within: largest error; between: largest distance outside
  std::string first;      // of the first violation: element, expected, got
};

// `got`: each of the bound's ports' payload. `poison`: the word that untouched elements hold.
Verdict judge(const Bound&, const std::vector<Layout>& layouts, const Expected&, const std::vector<Bytes>& got, uint32_t poison);

// Live elements left as poison, and others touched: "element 12 was not written", "element 40 was written". Empty: fine.
std::string misuse(const Layout&, const Expected&, const Bytes& got, uint32_t poison);

}  // namespace assay::check
