// How a kernel asks for more workgroups than one dimension of a dispatch may hold.
#pragma once
#include "harness/formats/workloads.h"
#include "harness/kernel.h"

namespace assay {

// n workgroups in equal rows along y; fewer than y of them are left over, and the shader turns those away. Read in the
// shader by spread_group() of harness/glsl/tiles.glsl. n up to 65,535 squared.
constexpr Groups spread_groups(uint64_t n) {
  if (n == 0) return {0, 1, 1};
  const uint64_t rows = (n + kMaxGroups - 1) / kMaxGroups;
  return {static_cast<uint32_t>((n + rows - 1) / rows), static_cast<uint32_t>(rows), 1};
}

}  // namespace assay
