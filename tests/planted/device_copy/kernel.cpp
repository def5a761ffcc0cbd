// Copies pairs: through a direct dispatch, through indirect ones a row, and past the end of its buffer.
#include "harness/kernel.h"
#include "tests/planted/device_copy/layout.h"

namespace assay::device_copy {

namespace {
uint64_t count(const Case& c) { return c.params<CopyParams>().count; }
Groups groups(const Case& c) { return {ceil_div(c.params<CopyParams>().count, 64)}; }
Port stored() {
  Port p = writes_image("stored", Format::rgb9e5_float);
  p.view = Format::r32_uint;
  return p;
}
}  // namespace

Kernel describe();
Kernel describe() {
  return {
      .name = "device_copy",
      .source = "a test of harness/device",
      .default_variant = "direct",
      .params = layout_of<CopyParams>(),
      .ports = {reads<Pair>("pairs", count), writes<Pair>("copies", count),
                updates<DispatchArgs>("arguments", fixed(3)), writes<uint32_t>("rows", fixed(16)), stored()},
      .variants = {{.name = "direct",
                    .passes = {Dispatch{.shader = "copy.comp", .groups = groups}},
                    .constants = {{"GROUP", {64, 32}}, {"SCALE", {1, 3}}}},
                   {.name = "rows",
                    .passes = {Clear{"rows", 7},
                               Dispatch{.shader = "row.comp", .indirect = "arguments", .repeat = fixed(3)}}},
                   {.name = "stray", .passes = {Dispatch{.shader = "stray.comp", .groups = groups}}},
                   {.name = "empty",
                    .passes = {Dispatch{.shader = "copy.comp", .groups = [](const Case&) { return Groups{0}; }}}},
                   {.name = "huge",
                    .passes = {Dispatch{.shader = "copy.comp",
                                        .groups =
                                            [](const Case&) {
                                              return Groups{1u << 31, 1u << 31, 1u << 31};
                                            }}}},
                   {.name = "image",
                    .passes = {Dispatch{.shader = "store.comp", .groups = [](const Case&) { return Groups{1}; }}}}},
  };
}

}  // namespace assay::device_copy
