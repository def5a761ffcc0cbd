#include "kernels/visibility/drawn.h"

#include <algorithm>

namespace assay::visibility {

using namespace raster;

namespace {

constexpr uint64_t kSampledAbove = 1u << 18;  // pixels

}  // namespace

void for_each_triangle(const Case& c, const std::function<void(const DrawnTriangle&)>& visit) {
  const SceneCounts counts = c.params<VisibilityParams>().scene;
  const auto draws = c.input<DrawCommand>("draws");
  const auto indices = c.input<uint>("indices");
  DrawnTriangle t;
  for (uint32_t bucket = 0; bucket < kDrawBuckets; ++bucket) {
    t.masked = bucket >= 3;
    t.facing = bucket % 3 == kFacingBoth       ? Facing::both
               : bucket % 3 == kFacingCullBack ? Facing::cull_back
                                               : Facing::cull_front;
    for (uint32_t d = counts.bucket_first[bucket]; d < counts.bucket_first[bucket + 1]; ++d)
      raster::for_each_triangle(draws[d], indices, counts.vertices, counts.surfaces, t, visit);
  }
}

JudgedMap judged_map(const Case& c) { return assay::judged_map(judged_pixels(c, kSampledAbove), c.extent); }

}  // namespace assay::visibility
