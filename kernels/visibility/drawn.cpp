#include "kernels/visibility/drawn.h"

#include <algorithm>

#include "harness/judged.h"

namespace assay::visibility {

namespace {

constexpr uint64_t kSampledAbove = 1u << 18;  // pixels

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
  JudgedPixels judged;
  judged.list = assay::judged_pixels(c, kSampledAbove);
  if (judged.list.empty()) return judged;
  judged.position.assign(pixel_count(c.extent), kNotJudged);
  for (size_t i = 0; i < judged.list.size(); ++i) judged.position[judged.list[i]] = static_cast<uint32_t>(i);
  return judged;
}

}  // namespace assay::visibility
