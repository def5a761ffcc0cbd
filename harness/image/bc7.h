// BC7 blocks of mode 6: one line through RGBA a block, sixteen steps.
#pragma once
#include "harness/block_decoder.h"

namespace assay::image {

// The least squared error in codes that it finds, alpha's counted three times, for it moves all three colours: of a
// line by the principal axis, refined by least squares, for each of the four choices of the ends' lowest bits. A block
// of one colour is exact, but where one channel is 0 and another 255: ends of 7 bits with a shared lowest one do not
// meet both, and some channels are off by a code.
std::array<std::byte, 16> bc7_block(const BlockTexels&);

}  // namespace assay::image
