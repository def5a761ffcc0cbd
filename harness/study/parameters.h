// A kernel's variants and parameters by name: studies know kernels by the registry alone.
#pragma once
#include <algorithm>

#include "harness/kernel.h"

namespace assay::study {

inline const Variant& variant_of(const Kernel& k, const std::string& name) {
  const auto it = std::ranges::find(k.variants, name, &Variant::name);
  if (it == k.variants.end()) throw std::logic_error(k.name + " has no variant " + name);
  return *it;
}

// A word of the parameters, by its name in the shared struct.
template <class T>
void set_parameter(const Kernel& k, Case& c, const std::string& name, T value) {
  static_assert(sizeof(T) == 4);
  const auto field = std::ranges::find(k.params.fields, name, &Field::name);
  if (field == k.params.fields.end()) throw std::logic_error(k.name + " has no parameter " + name);
  std::memcpy(c.parameters.data() + field->offset, &value, sizeof(T));
}

}  // namespace assay::study
