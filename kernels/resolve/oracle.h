#pragma once
#include "harness/kernel.h"

namespace assay::resolve {

// A pixel's codes.
Layout codes_layout();
Bytes unpack_codes(std::span<const std::byte>);

// exposure: the sums within (m + d) u of their terms' magnitudes (README), and what follows from them. image: the codes
// that the curve gives at the lowest and highest admissible exposure; with manual exposure they are one.
Answer expected(const Case&);

}  // namespace assay::resolve
