#include "harness/judged.h"

#include <algorithm>

#include "harness/formats/features.h"
#include "harness/oracle.h"

namespace assay {

std::vector<uint64_t> judged_pixels(const Case& c, uint64_t sampled_above, JudgedBorders borders) {
  constexpr uint32_t kStrata = 256;  // a side: 65,536 samples
  const auto [width, height] = c.extent;
  if (c.judge_all || pixel_count(c.extent) <= sampled_above) return {};
  std::vector<uint64_t> judged;
  const auto is_border = [borders](uint32_t i, uint32_t size) {
    const bool is_tiles = i % kTileSide == 0 || i % kTileSide == kTileSide - 1;
    return (borders == JudgedBorders::tiles && is_tiles) || i + 1 == size;
  };
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      if (is_border(x, width) || is_border(y, height)) judged.push_back(uint64_t{y} * width + x);
  Pcg32 rng(c.seed ^ pixel_count(c.extent));
  const auto in_stratum = [&rng](uint32_t k, uint32_t size) {
    return std::min(static_cast<uint32_t>((k + rng.unit()) * size / kStrata), size - 1);
  };
  for (uint32_t j = 0; j < kStrata; ++j)
    for (uint32_t i = 0; i < kStrata; ++i) {
      const uint32_t x = in_stratum(i, width), y = in_stratum(j, height);
      judged.push_back(uint64_t{y} * width + x);
    }
  std::ranges::sort(judged);
  judged.erase(std::unique(judged.begin(), judged.end()), judged.end());
  return judged;
}

JudgedMap judged_map(std::vector<uint64_t> list, Extent e) {
  JudgedMap judged{.list = std::move(list)};
  if (judged.list.empty()) return judged;
  judged.position.assign(pixel_count(e), kNotJudged);
  for (size_t i = 0; i < judged.list.size(); ++i) judged.position[judged.list[i]] = static_cast<uint32_t>(i);
  return judged;
}

}  // namespace assay
