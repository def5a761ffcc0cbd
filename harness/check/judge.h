// Comparators. Acceptance is positive (error <= limit), so NaN never passes.
#pragma once
#include <optional>
#include <string>

#include "harness/kernel.h"

namespace assay::check {

struct Verdict {
  uint64_t judged = 0, undecided = 0, violations = 0;
  uint64_t nans = 0;  // of the violations, elements with a NaN where a number was expected
  // exact, same_set: wrong elements. ulps, within: largest error of a float, infinite for NaN or a wrong integer.
  // bits: most wrong flags of an element. between: largest distance of a component outside the nearest alternative,
  // infinite for NaN.
  double worst = 0;
  std::string first;     // of the first violation: element, expected, got
  uint64_t element = 0;  // the first violation's
};

// `got`: each of the bound's ports' payload. Elements outside the live runs are the affair of misuse(). An answer that
// does not fit the ports (sizes, runs past the end) throws std::logic_error: the oracle is at fault.
Verdict judge(const Bound&, const std::vector<Layout>& layouts, const Expected&, const std::vector<Bytes>& got);

// Live elements left as poison, and others touched: "element 12 was not written", "element 40 was written". Empty:
// fine.
std::string misuse(const Layout&, const Expected&, const Bytes& got, uint32_t poison);

// Elements of which a live word (of a small texel: the whole texel) still holds poison, ascending. A value that happens
// to equal the poison is among them; only what stays so under another poison was not written.
std::vector<uint64_t> untouched(const Layout&, const Expected&, const Bytes& got, uint32_t poison);
// The first element outside the live runs that no longer holds poison.
std::optional<uint64_t> strayed(const Layout&, const Expected&, const Bytes& got, uint32_t poison);
// The live runs, checked against an element count; one run of all where the answer names none.
std::vector<Expected::Run> live_runs(const Expected&, uint64_t elements);

// What comparators see of a port: a buffer's own layout; of an image the texel: 32-bit components by their type, packed
// formats of 4 and 8 bytes as raw words, smaller ones without fields, to be compared as bytes.
Layout layout_of_port(const Port&);
std::string name_of(const Bound&);  // "between(visibility, depth)"

}  // namespace assay::check
