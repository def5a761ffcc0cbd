// Which pixels an oracle answers for where a screen is too large to answer for all. Host only.
#pragma once
#include "harness/kernel.h"

namespace assay {

// Ascending: the borders of all 32x32 tiles and a stratified 65,536 pixels. Empty, for all of them, up to this many
// pixels and where the case says so (nightly).
std::vector<uint64_t> judged_pixels(const Case&, uint64_t sampled_above);

}  // namespace assay
