// Elements of one or several ports seen as components of 4 bytes: shared by the comparators, not for others.
#pragma once
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "harness/check/judge.h"

namespace assay::check {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A component of the joined element: where it lies in its port's element and in the expected one.
struct Component {
  uint32_t port, offset, joined;
  Scalar scalar;
};

struct Elements {
  const std::vector<Layout>* layouts;
  const std::vector<Bytes>* got;
  std::vector<Component> components;
  std::vector<uint64_t> judged;  // ascending
  uint64_t count = 0;            // in each port
  uint32_t stride = 0;           // of the joined element
};

inline uint32_t word_at(const std::byte* p) {
  uint32_t w;
  std::memcpy(&w, p, 4);
  return w;
}
inline float float_at(const std::byte* p) {
  float f;
  std::memcpy(&f, p, 4);
  return f;
}
inline const std::byte* got_at(const Elements& e, uint64_t element, const Component& c) {
  return (*e.got)[c.port].data() + element * (*e.layouts)[c.port].stride + c.offset;
}
// A component as a number, exact in double.
double number_at(const std::byte*, Scalar);

// The element's ports side by side, as an expected element is laid out.
void join(const Elements&, uint64_t element, std::byte* to);
// Members of `a` that differ from `b`, or all if none does: ".mask 3 (0x00000003), .depth 0.5".
std::string describe(const Elements&, const std::byte* a, const std::byte* b);

}  // namespace assay::check
