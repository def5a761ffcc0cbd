// Which pixels of a case are judged.
#pragma once
#include <vector>

#include "harness/kernel.h"

namespace assay::deferred_texturing {

// Of large targets the borders of every tile and a stratified sample, ascending; of others, or where the case says so,
// all: an empty list.
std::vector<uint64_t> judged_pixels(const Case&);

}  // namespace assay::deferred_texturing
