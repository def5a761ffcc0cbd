// One variant a mistake that the comparison of shaders with ports must catch; "right" has none.
#include "harness/kernel.h"

#include "tests/planted/device_layouts/layout.h"
#include "tests/planted/ports.h"

namespace assay::device_layouts {

namespace {
Variant variant(const std::string& name) {
  return {.name = name, .passes = {Dispatch{.shader = name + ".comp", .groups = [](const Case&) { return Groups{}; }}}};
}
}  // namespace

Kernel describe();
Kernel describe() {
  Kernel k = {
      .name = "device_layouts",
      .source = "a test of harness/device",
      .default_variant = "right",
      .params = layout_of<LayoutParams>(),
      .ports = {reads<Item>("items", fixed(4)), reads<uint32_t>("words", fixed(64)),
                writes<uint32_t>("results", fixed(4)), reads_image("picture", Format::rg32_uint),
                stored_as_words("stored")},
  };
  for (const char* name : {"right", "stride", "swapped", "renamed", "params", "read_only", "written", "float_texels",
                           "image_format", "array_length", "missing_member", "std430", "constant", "unused"})
    k.variants.push_back(variant(name));
  k.variants.back().passes = {Dispatch{.shader = "right.comp", .groups = [](const Case&) { return Groups{}; }}};
  k.ports.push_back(writes<uint32_t>("forgotten", fixed(1)));
  k.ports.back().only_in = {"unused"};
  for (Variant& v : k.variants)
    if (v.name == "constant") {
      v.passes = k.variants[0].passes;
      v.constants = {{"SPEEED", {1}}};
    }
  return k;
}

}  // namespace assay::device_layouts
