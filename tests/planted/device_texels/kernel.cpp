#include "harness/kernel.h"

#include "tests/planted/device_texels/layout.h"

namespace assay::device_texels {

Kernel describe();
Kernel describe() {
  const auto groups = [](const Case& c) {
    return Groups{ceil_div(c.extent.width, 8), ceil_div(c.extent.height, 8), 1};
  };
  return {.name = "device_texels",
          .source = "a test of textures in blocks",
          .default_variant = "read",
          .params = layout_of<TexelParams>(),
          .ports = {reads_textures("textures", 1), writes<glm::vec4>("fetched", pixels),
                    writes<glm::vec4>("sampled", pixels)},
          .variants = {
              {.name = "read", .passes = {Dispatch{"read.comp", groups}}, .needs = {Feature::texture_compression_bc}}}};
}

}  // namespace assay::device_texels
