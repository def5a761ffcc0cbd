// What each pixel of the G-buffer may hold, from the same bytes that the shaders read.
#pragma once
#include "harness/kernel.h"

namespace assay::deferred_texturing {

Answer textured(const Case&);
// Before the names of ports: their answers where attributes are interpolated in the shader, and not read.
inline const std::string kInline = "inline/";

}  // namespace assay::deferred_texturing
