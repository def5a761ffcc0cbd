#include "harness/kernel.h"

#include "harness/formats/gbuffer.h"
#include "harness/formats/light.h"
#include "harness/formats/particle.h"
#include "kernels/deferred_lighting/layout.h"

namespace assay::shaded_twice {

Kernel describe();
Kernel describe() {
  const auto groups = [](const Case& c) {
    return Groups{ceil_div(c.extent.width, 8), ceil_div(c.extent.height, 8), 1};
  };
  return {.name = "shaded_twice",
          .source = "a test of surfaces and particles at the same place",
          .default_variant = "all_lights",
          .params = layout_of<deferred_lighting::LightingParams>(),
          .ports = {reads_image("depth", Format::d32_float), reads_image("base_roughness", Format::rgba8_unorm),
                    reads_image("normal", Format::rg16_snorm), reads_image("metallic_occlusion", Format::rg8_unorm),
                    reads_image("emissive", Format::r32_uint), reads<uint>("features", pixels),
                    reads<LightRecord>(
                        "lights",
                        [](const Case& c) { return uint64_t{c.params<deferred_lighting::LightingParams>().lights}; }),
                    writes_image("radiance", Format::rgba16_float),
                    reads<ParticleRecord>("particles", [](const Case&) { return uint64_t{1}; }),
                    writes<vec3>("as_surface", pixels), writes<vec3>("as_particle", pixels)},
          .variants = {{.name = "all_lights", .passes = {Dispatch{"shaded_twice.comp", groups}}}}};
}

}  // namespace assay::shaded_twice
