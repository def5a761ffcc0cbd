// What a dispatch and the barrier behind it cost when there is nothing to do.
#include "harness/kernel.h"

namespace assay::empty_yardstick {

Kernel describe() {
  return {
      .name = "empty_yardstick",
      .source = "one workgroup that returns",
      .default_variant = "empty",
      .ports = {writes<uint32_t>("unused", fixed(1))},
      .variants = {{.name = "empty",
                    .passes = {Dispatch{.shader = "empty.comp", .groups = [](const Case&) { return Groups{}; }}}}},
      .oracle =
          [](const Case&) {
            return Answer{{"unused", Expected{.live = std::vector<Expected::Run>{}}}};
          },
      .inputs = {},
      .bounds = {exact("unused", "never written")},
      .cost = [](const Case&) { return Cost{}; },
      .typical = [](Extent e) { return Case{.name = "nothing", .extent = e}; },
      .extents = {{1, 1}},
  };
}

}  // namespace assay::empty_yardstick
