// What Vulkan and SPIR-V call the formats of kernel.h.
#pragma once
#include <volk.h>

#include <string>

#include "harness/kernel.h"

namespace assay::device {

struct FormatInfo {
  Format format;
  VkFormat vulkan;
  const char* storage;  // GLSL's layout qualifier for a storage image of it; nullptr: never one
  Scalar sampled;       // what a texel reads as: f32, u32
};
const FormatInfo& info_of(Format);
VkImageAspectFlags aspect_of(Format);

}  // namespace assay::device
