// Which pixels an oracle answers for where a screen is too large to answer for all. Host only.
#pragma once
#include "harness/kernel.h"

namespace assay {

// Borders beside the sample: of all 32x32 tiles, or the last row and column alone, where invocations share nothing and
// no border within is special.
enum class JudgedBorders { tiles, last };
// Ascending: a stratified 65,536 pixels and the borders. Empty, for all of them, up to this many pixels and where the
// case says so (nightly).
std::vector<uint64_t> judged_pixels(const Case&, uint64_t sampled_above, JudgedBorders = JudgedBorders::tiles);

// A list of judged pixels and where in it each of the picture's is.
constexpr uint32_t kNotJudged = 0xffffffffu;
struct JudgedMap {
  std::vector<uint64_t> list = {};      // ascending; empty: all
  std::vector<uint32_t> position = {};  // of a pixel in the list, kNotJudged elsewhere; empty where all are judged
};
JudgedMap judged_map(std::vector<uint64_t> list, Extent);

// Each of them, or all where there are none.
template <class F>
void for_each_judged(const Case& c, const std::vector<uint64_t>& judged, F f) {
  const uint64_t count = judged.empty() ? pixels(c) : judged.size();
  for (uint64_t i = 0; i < count; ++i) f(judged.empty() ? i : judged[i]);
}

}  // namespace assay
