// A screen that is drawn over but for one pixel, where the targets' clears must show, or else what was there before.
#include "harness/kernel.h"

#include "harness/oracle.h"
#include "tests/planted/check_targets/layout.h"

namespace assay::check_targets {

namespace {

enum Clears { neither, colour_alone, depth_alone, both };

Variant variant(const char* name, Clears clears, uint64_t vertices = 3) {
  Draw draw{.colours = {{.port = "colour"}},
            .depth = DepthTarget{.port = "depth", .compare = Compare::always},
            .calls = {{.vertex = "screen.vert", .fragment = "hole.frag", .count = fixed(vertices)}}};
  if (clears & colour_alone) draw.colours[0].clear = glm::uvec4(kClearColour);
  if (clears & depth_alone) draw.depth->clear = 0.0f;
  return {.name = name, .passes = {draw}};
}

Case hole_in_the_middle() {
  Case c{.extent = {15, 9}};
  c.set_params(TargetParams{15, 67});
  return c;
}

Answer oracle(const Case& c) {
  std::vector<uint32_t> colour(pixels(c));
  std::vector<float> depth(pixels(c), kDepth);
  for (uint32_t i = 0; i < colour.size(); ++i) colour[i] = i + 100;
  const uint32_t hole = c.params<TargetParams>().hole;
  colour[hole] = kClearColour;
  depth[hole] = 0;
  return {{"colour", expect_all(colour)}, {"depth", expect_all(depth)}};
}

}  // namespace

Kernel describe();
Kernel describe() {
  return {
      .name = "check_targets",
      .source = "planted",
      .default_variant = "cleared",
      .params = layout_of<TargetParams>(),
      .ports = {writes_image("colour", Format::r32_uint), writes_image("depth", Format::d32_float)},
      .variants = {variant("cleared", both), variant("colour_not_cleared", depth_alone),
                   variant("depth_not_cleared", colour_alone), variant("not_drawn", neither, 0)},
      .oracle = oracle,
      .inputs = {.hard = {{"hole", "one pixel is not covered", hole_in_the_middle}}},
      .bounds = {exact("colour", "integers only"), exact("depth", "a constant")},
  };
}

}  // namespace assay::check_targets
