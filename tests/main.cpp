#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "tests/run.h"

namespace assay::tests {

namespace {

device::Validation validation_named(const std::string& name) {
  if (name.empty() || name == "off") return device::Validation::off;
  if (name == "core") return device::Validation::core;
  if (name == "sync") return device::Validation::sync;
  if (name == "gpuav") return device::Validation::gpuav;
  throw std::invalid_argument("ASSAY_VALIDATION=" + name + ": off, core, sync or gpuav");
}

device::Handle& opened() {
  static device::Handle handle;
  return handle;
}

// Messages that no test took and judged.
int report_messages() {
  if (!opened()) return 0;
  const auto messages = device::validation_messages(*opened());
  for (const std::string& message : messages) fmt::print(stderr, "validation: {}\n", message);
  return messages.empty() ? 0 : 1;
}

}  // namespace

std::string text_from(const char* variable) {
  const char* value = std::getenv(variable);
  return value ? value : "";
}

const device::Options& device_options() {
  static const device::Options options{text_from("ASSAY_DEVICE"), validation_named(text_from("ASSAY_VALIDATION"))};
  return options;
}

device::Handle& device() {
  if (!opened()) opened() = device::open(device_options());
  return opened();
}

const Kernel& planted(const std::string& name) {
  const auto& all = planted_kernels();
  const auto it = std::ranges::find(all, name, &Kernel::name);
  if (it == all.end()) throw std::invalid_argument("no planted kernel " + name);
  return *it;
}

std::vector<std::string> kernel_names() {
  std::vector<std::string> names;
  for (const Kernel& kernel : all_kernels()) names.push_back(kernel.name);
  return names;
}

uint32_t number_from(const char* variable, uint32_t otherwise) {
  const std::string text = text_from(variable);
  return text.empty() ? otherwise : static_cast<uint32_t>(std::stoul(text));
}

int run(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  const int messages = report_messages();
  opened().reset();  // before the loader's own static objects go
  return failed != 0 || messages != 0 ? 1 : 0;
}

}  // namespace assay::tests

int main(int argc, char** argv) {
  try {
    return assay::tests::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
