// Checked Vulkan calls: in every build each VkResult is looked at, and a failure names expression, result, file and
// line.
#pragma once
#include <volk.h>

namespace assay::device {

const char* name_of(VkResult);

// Throws Lost, OutOfMemory or Error unless `result` is VK_SUCCESS.
void require_success(VkResult result, const char* expression, const char* file, int line);

#ifdef ASSAY_TESTS
bool take_injected(const char* expression);  // whether a test wants this call to fail
VkResult injected_result();
#define ASSAY_ATTEMPT(...) \
  (::assay::device::take_injected(#__VA_ARGS__) ? ::assay::device::injected_result() : (__VA_ARGS__))
#else
#define ASSAY_ATTEMPT(...) (__VA_ARGS__)
#endif

// ASSAY_VK(vkCall(...)) runs the call and throws where it fails; ASSAY_ATTEMPT leaves the result to the caller.
#define ASSAY_VK(...) ::assay::device::require_success(ASSAY_ATTEMPT(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)

}  // namespace assay::device
