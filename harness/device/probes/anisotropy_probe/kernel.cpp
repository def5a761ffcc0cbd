// What an anisotropic sampler reads where a footprint is eight times as long as wide: every level has a red of its own.
#include "harness/kernel.h"

namespace assay::anisotropy_probe {

namespace {

constexpr uint32_t kSide = 256, kLevels = 9;

Case typical(Extent e) {
  Texture t = {.format = Format::rgba8_unorm, .width = kSide, .height = kSide, .levels = kLevels};
  for (uint32_t level = 0; level < kLevels; ++level)
    for (uint64_t i = 0; i < bytes_of(t.format, width_of(t, level), height_of(t, level)) / 4; ++i)
      for (const uint32_t code : {16 * level, 0u, 0u, 255u}) t.bytes.push_back(static_cast<std::byte>(code));
  Case c = {.name = "levels", .extent = e};
  c.textures["textures"] = {std::move(t)};
  return c;
}

}  // namespace

Kernel describe() {
  return {.name = "anisotropy_probe",
          .source = "Vulkan 1.3, Scale Factor Operation",
          .default_variant = "anisotropic",
          .ports = {reads_textures("textures", 1), writes<float>("reds", fixed(2))},
          .variants = {{.name = "anisotropic",
                        .passes = {Dispatch{"probe.comp", [](const Case&) { return Groups{}; }}},
                        .anisotropic = true}},
          .typical = typical};
}

}  // namespace assay::anisotropy_probe
