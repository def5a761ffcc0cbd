// A scene drawn by the frame, and what it leaves behind.
#pragma once
#include <cstring>
#include <vector>

#include "harness/frame/frame.h"
#include "tests/run.h"

namespace assay::tests {

template <class T>
std::vector<T> words(const Bytes& bytes) {
  std::vector<T> v(bytes.size() / sizeof(T));
  if (!v.empty()) std::memcpy(v.data(), bytes.data(), v.size() * sizeof(T));
  return v;
}

// From the scene's own camera.
inline frame::Result draw(const scene::Scene& s, const frame::Options& o) {
  return frame::render(*device(), s, scene::default_camera(s), o);
}

}  // namespace assay::tests
