// The device's own arithmetic peak in single precision: what any kernel's operations are measured against. It is the
// highest rate a shader can hope for, so a limit derived from it is never too strict for integer work either.
#include "harness/kernel.h"

#include "harness/report/yardsticks/multiply_add_yardstick/layout.h"

namespace assay::multiply_add_yardstick {

namespace {

uint64_t threads(const Case& c) { return uint64_t{c.extent.width} * kGroupSize; }

Case steady(Extent extent) {
  Case c{.name = "steady", .extent = extent};
  c.set_params(MultiplyAddParams{0.5f, 1.0f});  // tends to 2: no overflow, no denormals
  return c;
}

// Every chain has reached its fixed point 2 long before the last round: 16 lanes sum to 32.
Answer fixed_point(const Case& c) {
  Expected e;
  const std::vector<float> sums(threads(c), 32.0f);
  const auto bytes = std::as_bytes(std::span(sums));
  e.low.assign(bytes.begin(), bytes.end());
  return {{"sums", e}};
}

}  // namespace

Kernel describe() {
  return {
      .name = "multiply_add_yardstick",
      .source = "chains of multiply and add",
      .default_variant = "chains",
      .params = layout_of<MultiplyAddParams>(),
      .ports = {writes<float>("sums", threads)},
      .variants = {{.name = "chains",
                    .passes = {Dispatch{.shader = "multiply_add.comp",
                                        .groups =
                                            [](const Case& c) {
                                              return Groups{c.extent.width, 1, 1};
                                            }}}}},
      .oracle = fixed_point,
      .inputs = {},
      .bounds = {exact("sums", "the fixed point is a power of two")},
      .cost =
          [](const Case& c) {
            return Cost{.bytes_written = 4 * threads(c), .operations = threads(c) * kRounds * kOperationsARound};
          },
      .typical = steady,  // width: workgroups
      .extents = {{64, 1}},
  };
}

}  // namespace assay::multiply_add_yardstick
