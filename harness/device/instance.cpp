// The loader, the instance with its layer, and the choice of a device.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "harness/device/internal.h"

namespace assay::device {

namespace {

constexpr const char* kLayer = "VK_LAYER_KHRONOS_validation";

void open_loader() {
  static std::mutex mutex;
  static bool opened = false;
  const std::lock_guard lock(mutex);
  if (opened) return;
  if (volkInitialize() != VK_SUCCESS)
    throw Error("no Vulkan loader: libvulkan.so.1 was not found; install libvulkan1 or put it in LD_LIBRARY_PATH");
  if (volkGetInstanceVersion() < VK_API_VERSION_1_3) {
    const uint32_t v = volkGetInstanceVersion();
    throw Error(
        fmt::format("the Vulkan loader is {}.{}, Assay needs 1.3", VK_API_VERSION_MAJOR(v), VK_API_VERSION_MINOR(v)));
  }
  opened = true;
}

// The loader's functions dispatch by handle, so one load serves every instance and device of the process.
void load_functions(VkInstance instance) {
  static std::mutex mutex;
  static bool loaded = false;
  const std::lock_guard lock(mutex);
  if (!loaded) volkLoadInstance(instance);
  loaded = true;
}

bool has_layer() {
  uint32_t n = 0;
  ASSAY_VK(vkEnumerateInstanceLayerProperties(&n, nullptr));
  std::vector<VkLayerProperties> layers(n);
  ASSAY_VK(vkEnumerateInstanceLayerProperties(&n, layers.data()));
  return std::ranges::any_of(layers, [](const auto& l) { return std::string_view(l.layerName) == kLayer; });
}

bool has_extension(const char* name, const char* layer = nullptr) {
  uint32_t n = 0;
  ASSAY_VK(vkEnumerateInstanceExtensionProperties(layer, &n, nullptr));
  std::vector<VkExtensionProperties> found(n);
  ASSAY_VK(vkEnumerateInstanceExtensionProperties(layer, &n, found.data()));
  return std::ranges::any_of(found, [&](const auto& e) { return std::string_view(e.extensionName) == name; });
}

// The only messages that are left out, each with its reason.
struct Ignored {
  VkDebugUtilsMessageTypeFlagsEXT type;
  std::string_view id;
};
constexpr Ignored kIgnored[] = {
    // Every image stays in the general layout, so the advice to copy in another one is for somebody else. Under the
    // type
    // of a validation error the same name means a wrong layout, and is kept.
    {VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT, "UNASSIGNED-CoreValidation-DrawState-InvalidImageLayout"},
};

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                       VkDebugUtilsMessageTypeFlagsEXT type,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  const std::string_view id = data->pMessageIdName ? data->pMessageIdName : "";
  for (const Ignored& i : kIgnored)
    if (type == i.type && id == i.id) return VK_FALSE;
  auto& messages = *static_cast<Messages*>(user);
  std::string line = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT ? "error: " : "warning: ";
  for (const char* c = data->pMessage; *c; ++c) line += *c == '\n' ? ' ' : *c;
  const std::lock_guard lock(messages.mutex);
  messages.lines.push_back(std::move(line));
  return VK_FALSE;
}

std::vector<VkValidationFeatureEnableEXT> layer_features(Validation v) {
  if (v == Validation::sync) return {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  if (v == Validation::gpuav)
    return {VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT,
            VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_RESERVE_BINDING_SLOT_EXT};
  return {};
}

std::string lower_case(std::string s) {
  std::ranges::transform(s, s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

std::string listed(std::span<const Info> infos) {
  if (infos.empty()) return "there is no Vulkan device; lavapipe comes with mesa-vulkan-drivers";
  std::string s = "there are";
  for (const Info& i : infos)
    s += fmt::format("{} {} '{}' ({}, {})", &i == &infos.front() ? "" : ",", i.index, i.name, i.type, i.uuid);
  return s;
}

std::optional<size_t> as_index(const std::string& select) {
  size_t index = 0;
  const auto [end, error] = std::from_chars(select.data(), select.data() + select.size(), index);
  const bool whole = error == std::errc() && end == select.data() + select.size();
  return whole && select.size() < 8 ? std::optional(index) : std::nullopt;  // 8 digits and more begin a UUID
}

bool names_uuid(const std::string& select, const Info& i) {
  std::string digits = lower_case(select);
  std::erase(digits, '-');
  return digits.size() >= 8 && i.uuid.starts_with(digits);
}

}  // namespace

Instance::Instance(Validation validation) {
  open_loader();
  const bool layer = validation != Validation::off;
  if (layer && !has_layer())
    throw Error(
        fmt::format("validation was asked for, but {} is not installed (Debian: vulkan-validationlayers)", kLayer));
  debug_utils = has_extension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  std::vector<const char*> extensions;
  if (debug_utils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  if (layer && has_extension(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME, kLayer))
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);

  const VkApplicationInfo application = {
      .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "assay", .apiVersion = VK_API_VERSION_1_3};
  const auto enabled = layer_features(validation);
  const VkValidationFeaturesEXT features = {.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                            .enabledValidationFeatureCount = static_cast<uint32_t>(enabled.size()),
                                            .pEnabledValidationFeatures = enabled.data()};
  const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                     .pNext = enabled.empty() ? nullptr : &features,
                                     .pApplicationInfo = &application,
                                     .enabledLayerCount = layer ? 1u : 0u,
                                     .ppEnabledLayerNames = &kLayer,
                                     .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
                                     .ppEnabledExtensionNames = extensions.data()};
  const VkResult result = ASSAY_ATTEMPT(vkCreateInstance(&info, nullptr, &handle));
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return;  // no driver is installed: no devices
  require_success(result, "vkCreateInstance(&info, nullptr, &handle)", __FILE__, __LINE__);
  load_functions(handle);
  if (!layer || !debug_utils) return;
  const VkDebugUtilsMessengerCreateInfoEXT messenger = {
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
      .messageSeverity =
          VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
      .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                     VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT,
      .pfnUserCallback = collect,
      .pUserData = &messages};
  try {
    ASSAY_VK(vkCreateDebugUtilsMessengerEXT(handle, &messenger, nullptr, &messenger_));
  } catch (...) {
    vkDestroyInstance(handle, nullptr);
    throw;
  }
}

Instance::~Instance() {
  if (messenger_) vkDestroyDebugUtilsMessengerEXT(handle, messenger_, nullptr);
  if (handle) vkDestroyInstance(handle, nullptr);
}

std::vector<Info> list() {
  std::vector<Info> infos;
  {
    const Instance instance(Validation::off);
    for (Physical& p : physical_devices(instance)) infos.push_back(std::move(p.info));
  }
  for (Info& i : infos) {
    if (!i.missing.empty()) continue;
    try {
      i = info(*open({.select = std::to_string(i.index)}));  // with what is only known by trying
    } catch (const Error&) {                                 // taken: what it says of itself is listed all the same
    }
  }
  return infos;
}

size_t choose(std::span<const Info> infos, const std::string& select) {
  std::vector<size_t> found;
  if (select.empty()) {
    for (const Info& i : infos)
      if (i.type == "cpu") return i.index;
    throw NoSuchDevice(
        fmt::format("no CPU device (lavapipe) to take by default; choose one with --device: {}", listed(infos)));
  }
  if (const auto index = as_index(select)) {
    if (*index < infos.size()) return *index;
    throw NoSuchDevice(fmt::format("no device {}; {}", *index, listed(infos)));
  }
  for (const Info& i : infos)
    if (names_uuid(select, i)) found.push_back(i.index);
  if (found.empty())
    for (const Info& i : infos)
      if (lower_case(i.name).find(lower_case(select)) != std::string::npos) found.push_back(i.index);
  if (found.size() == 1) return found[0];
  throw NoSuchDevice(
      fmt::format("{} device matches '{}'; {}", found.empty() ? "no" : "more than one", select, listed(infos)));
}

}  // namespace assay::device
