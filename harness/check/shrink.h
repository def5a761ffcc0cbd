// Smaller cases that fail in the same way.
#pragma once
#include <chrono>
#include <functional>

#include "harness/kernel.h"

namespace assay::check {

struct ShrinkLimits {
  uint32_t attempts = 200;
  std::chrono::milliseconds time = std::chrono::seconds(20);
};
struct Shrunk {
  Case input;
  uint32_t attempts = 0, steps = 0;  // tried, and kept
};
// First the kernel's own smaller cases, largest step first, then the input buffers zeroed in ever smaller parts, as
// long as `fails` holds of the result. A predicate that throws counts as not failing.
Shrunk shrink(const Kernel&, Case, const std::function<bool(const Case&)>& fails, ShrinkLimits = {});

}  // namespace assay::check
