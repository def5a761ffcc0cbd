// The picture under its particles, in double, with what floats and blending in halves may make of it.
#pragma once
#include "harness/oracle.h"

namespace assay::particles {

Answer drawn(const Case&);
Layout texel_layout();
// Halves as floats; what is no finite number is kNotFinite, so that it can be compared.
Bytes unpack_texels(std::span<const std::byte> texels);
constexpr float kNotFinite = 1e30f;

}  // namespace assay::particles
