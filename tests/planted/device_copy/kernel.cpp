// Copies pairs: through a direct dispatch, through indirect ones a row, and past the end of its buffer.
#include "harness/kernel.h"
#include "tests/planted/device_copy/layout.h"
#include "tests/planted/ports.h"

namespace assay::device_copy {

namespace {
uint64_t count(const Case& c) { return c.params<CopyParams>().count; }
Groups groups(const Case& c) { return {ceil_div(c.params<CopyParams>().count, 64)}; }
}  // namespace

Kernel describe();
Kernel describe() {
  const auto one = [](const Case&) { return Groups{1}; };
  const auto none = [](const Case&) { return Groups{0}; };
  const auto too_many = [](const Case&) { return Groups{1u << 31, 1, 1}; };
  return {
      .name = "device_copy",
      .source = "a test of harness/device",
      .default_variant = "direct",
      .params = layout_of<CopyParams>(),
      .ports = {only_in(reads<Pair>("pairs", count), {"direct", "empty", "huge"}),
                only_in(writes<Pair>("copies", count), {"direct", "empty", "huge", "stray"}),
                only_in(reads<DispatchArgs>("arguments", fixed(3)), {"rows"}),
                only_in(writes<uint32_t>("rows", fixed(16)), {"rows"}), only_in(stored_as_words("stored"), {"image"})},
      .variants = {{.name = "direct",
                    .passes = {Dispatch{.shader = "copy.comp", .groups = groups}},
                    .constants = {{"GROUP", {64, 32}}, {"SCALE", {1, 3}}}},
                   {.name = "rows",
                    .passes = {Clear{"rows", 7},
                               Dispatch{.shader = "row.comp", .indirect = "arguments", .repeat = fixed(3)}}},
                   {.name = "stray", .passes = {Dispatch{.shader = "stray.comp", .groups = groups}}},
                   {.name = "empty", .passes = {Dispatch{.shader = "copy.comp", .groups = none}}},
                   {.name = "huge", .passes = {Dispatch{.shader = "copy.comp", .groups = too_many}}},
                   {.name = "image", .passes = {Dispatch{.shader = "store.comp", .groups = one}}}},
  };
}

}  // namespace assay::device_copy
