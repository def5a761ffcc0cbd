// What the particles' light must be.
#pragma once
#include "harness/kernel.h"
#include "kernels/particle_light_atlas/layout.h"

namespace assay::particle_light_atlas {

// A texel of each encoding, unpacked: radiance, and an alpha of 1.
Layout texel_layout();
std::function<Bytes(std::span<const std::byte>)> unpack_texels(uint32_t encoding);
// Of `direction`: the vector that a code stands for.
Layout direction_layout();
Bytes unpack_directions(std::span<const std::byte>);

// A walk's name and "atlas r11g11b10f", "atlas rgb9e5", "atlas rgba16f" or "direction". Walks: "listed", "all", and
// both with "_shadowed".
Answer expected_light(const Case&);

}  // namespace assay::particle_light_atlas
