// What each pixel of the G-buffer may hold, from the same bytes that the shaders read.
#pragma once
#include "harness/kernel.h"

namespace assay::deferred_texturing {

Answer textured(const Case&);

}  // namespace assay::deferred_texturing
