// The device's own copy bandwidth: what any kernel's bytes are measured against.
#include "harness/kernel.h"

#include "harness/report/yardsticks/copy_yardstick/layout.h"

namespace assay::copy_yardstick {

namespace {

uint64_t vectors(const Case& c) { return c.params<CopyParams>().vectors; }

// The constants change how much a group copies; the groups are those of the least, and the spare ones do nothing.
Groups groups_for(const Case& c) {
  const uint32_t n = ceil_div(c.params<CopyParams>().vectors, 256);
  const uint32_t rows = ceil_div(n, 65535);
  return {ceil_div(n, rows), rows, 1};
}

Case pattern(Extent extent) {
  Case c{.name = "pattern", .extent = extent};
  const auto n = static_cast<uint32_t>(pixel_count(extent));
  c.set_params(CopyParams{n});
  std::vector<glm::uvec4> source(n);
  for (uint32_t i = 0; i < n; ++i) source[i] = glm::uvec4(i, ~i, i * 2654435761u, 1u);
  c.set_input("source", source);
  return c;
}

}  // namespace

Kernel describe() {
  return {
      .name = "copy_yardstick",
      .source = "a plain copy, read once and written once",
      .default_variant = "copy",
      .params = layout_of<CopyParams>(),
      .ports = {reads<glm::uvec4>("source", vectors), writes<glm::uvec4>("target", vectors)},
      .variants = {{.name = "copy",
                    .passes = {Dispatch{.shader = "copy.comp", .groups = groups_for}},
                    .constants = {{"VECTORS", {1, 4}}}}},
      .oracle =
          [](const Case& c) {
            return Answer{{"target", Expected{.low = c.inputs.at("source")}}};
          },
      .inputs = {},
      .bounds = {exact("target", "a copy")},
      .cost = [](const Case& c) { return Cost{.bytes_read = 16 * vectors(c), .bytes_written = 16 * vectors(c)}; },
      .typical = pattern,
      .extents = {{1024, 1024}},
  };
}

}  // namespace assay::copy_yardstick
