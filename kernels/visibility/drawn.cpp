#include "kernels/visibility/drawn.h"

#include <algorithm>
#include <cmath>

#include "harness/formats/features.h"

namespace assay::visibility {

namespace {

constexpr uint64_t kSampledAbove = 1u << 18;  // pixels
constexpr uint32_t kStrata = 256;             // a side: 65,536 samples

}  // namespace

void for_each_triangle(const Case& c, const std::function<void(const DrawnTriangle&)>& visit) {
  const SceneCounts counts = c.params<VisibilityParams>().scene;
  const auto draws = c.input<DrawCommand>("draws");
  const auto indices = c.input<uint>("indices");
  const uint32_t last_surface = std::max(counts.surfaces, 1u) - 1, last_vertex = std::max(counts.vertices, 1u) - 1;
  DrawnTriangle t;
  for (uint32_t bucket = 0; bucket < kDrawBuckets; ++bucket) {
    t.masked = bucket >= 3;
    t.facing = bucket % 3 == kFacingBoth       ? Facing::both
               : bucket % 3 == kFacingCullBack ? Facing::cull_back
                                               : Facing::cull_front;
    for (uint32_t d = counts.bucket_first[bucket]; d < counts.bucket_first[bucket + 1]; ++d)
      for (uint32_t instance = 0; instance < draws[d].instance_count; ++instance) {
        t.surface = std::min(draws[d].first_instance + instance, last_surface);
        for (t.primitive = 0; t.primitive < draws[d].index_count / 3; ++t.primitive, ++t.order) {
          for (uint32_t k = 0; k < 3; ++k)
            t.vertices[k] =
                std::min(indices[draws[d].first_index + 3 * t.primitive + k] + draws[d].vertex_offset, last_vertex);
          visit(t);
        }
      }
  }
}

JudgedPixels judged_pixels(const Case& c) {
  const uint64_t count = pixel_count(c.extent);
  JudgedPixels judged;
  if (c.judge_all || count <= kSampledAbove) return judged;
  const auto [width, height] = c.extent;
  judged.position.assign(count, kNotJudged);
  const auto is_border = [](uint32_t i, uint32_t size) {
    return i % kTileSide == 0 || i % kTileSide == kTileSide - 1 || i + 1 == size;
  };
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      if (is_border(x, width) || is_border(y, height)) judged.position[uint64_t{y} * width + x] = 0;
  Pcg32 rng(c.seed ^ count);
  for (uint32_t j = 0; j < kStrata; ++j)
    for (uint32_t i = 0; i < kStrata; ++i) {
      const auto in_stratum = [&rng](uint32_t k, uint32_t size) {
        return std::min(static_cast<uint32_t>((k + rng.unit()) * size / kStrata), size - 1);
      };
      const uint32_t x = in_stratum(i, width), y = in_stratum(j, height);
      judged.position[uint64_t{y} * width + x] = 0;
    }
  for (uint64_t i = 0; i < count; ++i)
    if (judged.position[i] == 0) {
      judged.position[i] = static_cast<uint32_t>(judged.list.size());
      judged.list.push_back(i);
    }
  return judged;
}

}  // namespace assay::visibility
