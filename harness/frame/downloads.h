// What was read back of a frame, by resource name.
#pragma once
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "harness/texture.h"

namespace assay::frame {

// None of it: empty.
template <class T>
std::vector<T> values_of(const std::map<std::string, Bytes>& downloads, const std::string& name) {
  const auto it = downloads.find(name);
  if (it == downloads.end()) return {};
  std::vector<T> values(it->second.size() / sizeof(T));
  std::memcpy(values.data(), it->second.data(), values.size() * sizeof(T));
  return values;
}

}  // namespace assay::frame
