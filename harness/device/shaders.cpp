// Finding a compiled shader, and naming variants with their constants.
#include <fmt/format.h>

#include <string_view>

#include "harness/device/device.h"

namespace assay::device {

const Shader& shader(const std::string& kernel, const std::string& file, uint32_t mutant) {
  const Shader* as_written = nullptr;
  for (const Shader& s : all_shaders()) {
    if (kernel != s.kernel || file != s.file) continue;
    if (s.mutant == mutant) return s;
    if (s.mutant == 0) as_written = &s;
  }
  if (!as_written) throw std::invalid_argument(fmt::format("kernel {} has no shader file '{}'", kernel, file));
  return *as_written;
}

std::vector<std::map<std::string, uint32_t>> combinations(const Variant& v) {
  std::vector<std::map<std::string, uint32_t>> all = {{}};
  for (const Constant& c : v.constants) {
    if (c.values.empty()) throw std::logic_error(fmt::format("{}: constant {} has no values", v.name, c.name));
    std::vector<std::map<std::string, uint32_t>> longer;
    for (const auto& begun : all)
      for (const uint32_t value : c.values) {
        longer.push_back(begun);
        longer.back()[c.name] = value;
      }
    all = std::move(longer);
  }
  return all;
}

std::string label_of(const Variant& v, const std::map<std::string, uint32_t>& constants) {
  if (constants.empty()) return v.name;
  std::string list;
  for (const auto& [name, value] : constants) list += fmt::format("{}{}={}", list.empty() ? "" : ",", name, value);
  return v.name + "[" + list + "]";
}

}  // namespace assay::device
