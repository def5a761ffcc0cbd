// An embedded SPIR-V module. A header of its own, since every generated table includes it.
#pragma once
#include <cstdint>
#include <span>

namespace assay::device {

struct Shader {  // one SPIR-V module, compiled at build time
  const char* kernel;
  const char* file;
  uint32_t mutant;  // 0: the shader as written
  std::span<const uint32_t> words;
};

}  // namespace assay::device
