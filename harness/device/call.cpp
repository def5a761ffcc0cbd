#include "harness/device/call.h"

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <string>
#include <string_view>

#include "harness/device/device.h"

namespace assay::device {

const char* name_of(VkResult result) {
  switch (result) {
#define ASSAY_NAME(r) \
  case r:             \
    return #r
    ASSAY_NAME(VK_SUCCESS);
    ASSAY_NAME(VK_NOT_READY);
    ASSAY_NAME(VK_TIMEOUT);
    ASSAY_NAME(VK_INCOMPLETE);
    ASSAY_NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
    ASSAY_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
    ASSAY_NAME(VK_ERROR_INITIALIZATION_FAILED);
    ASSAY_NAME(VK_ERROR_DEVICE_LOST);
    ASSAY_NAME(VK_ERROR_MEMORY_MAP_FAILED);
    ASSAY_NAME(VK_ERROR_LAYER_NOT_PRESENT);
    ASSAY_NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
    ASSAY_NAME(VK_ERROR_FEATURE_NOT_PRESENT);
    ASSAY_NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
    ASSAY_NAME(VK_ERROR_TOO_MANY_OBJECTS);
    ASSAY_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
    ASSAY_NAME(VK_ERROR_FRAGMENTED_POOL);
    ASSAY_NAME(VK_ERROR_OUT_OF_POOL_MEMORY);
    ASSAY_NAME(VK_ERROR_FRAGMENTATION);
    ASSAY_NAME(VK_ERROR_UNKNOWN);
#undef ASSAY_NAME
    default:
      return "an unnamed VkResult";
  }
}

namespace {

std::string_view from_repository_root(std::string_view file) {
  const size_t at = file.rfind("harness/");
  return at == std::string_view::npos ? file : file.substr(at);
}

}  // namespace

void require_success(VkResult result, const char* expression, const char* file, int line) {
  if (result == VK_SUCCESS) return;
  const auto text = fmt::format("{} returned {} ({}) at {}:{}", expression, name_of(result), static_cast<int>(result),
                                from_repository_root(file), line);
  if (result == VK_ERROR_DEVICE_LOST) throw Lost(text);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) throw OutOfMemory(text);
  throw Error(text);
}

#ifdef ASSAY_TESTS
namespace {

struct Injection {
  std::mutex mutex;
  std::string call;
  VkResult result = VK_SUCCESS;
  uint32_t after = 0;
};
std::atomic<bool> armed = false;  // so that the usual call pays one load
Injection& injection() {
  static Injection i;
  return i;
}

}  // namespace

void inject_failure(const std::string& call, int32_t result, uint32_t after) {
  const std::lock_guard lock(injection().mutex);
  injection().call = call;
  injection().result = static_cast<VkResult>(result);
  injection().after = after;
  armed = !call.empty();
}

bool take_injected(const char* expression) {
  if (!armed.load(std::memory_order_relaxed)) return false;
  const std::lock_guard lock(injection().mutex);
  if (!armed || std::string_view(expression).find(injection().call) == std::string_view::npos) return false;
  if (injection().after-- > 0) return false;
  armed = false;
  return true;
}

VkResult injected_result() {
  const std::lock_guard lock(injection().mutex);
  return injection().result;
}
#endif

}  // namespace assay::device
