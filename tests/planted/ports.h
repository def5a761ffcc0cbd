// Ports that several planted kernels have.
#pragma once
#include "harness/kernel.h"

namespace assay {

inline Port only_in(Port p, std::vector<std::string> variants) {
  p.only_in = std::move(variants);
  return p;
}
// An image that is sampled in another format than shaders store.
inline Port stored_as_words(std::string name) {
  Port p = writes_image(std::move(name), Format::rgb9e5_float);
  p.view = Format::r32_uint;
  return p;
}

}  // namespace assay
