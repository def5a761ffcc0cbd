#include "harness/check/elements.h"

#include <fmt/format.h>

#include <stdexcept>

namespace assay::check {

double number_at(const std::byte* p, Scalar s) {
  if (s == Scalar::f32) return float_at(p);
  const uint32_t w = word_at(p);
  return s == Scalar::i32 ? static_cast<double>(static_cast<int32_t>(w)) : w;
}

void join(const Elements& e, uint64_t element, std::byte* to) {
  for (size_t p = 0; p < e.layouts->size(); ++p) {
    const uint32_t stride = (*e.layouts)[p].stride;
    std::memcpy(to, (*e.got)[p].data() + element * stride, stride);
    to += stride;
  }
}

namespace {

std::string value_text(const std::byte* p, Scalar s) {
  const uint32_t w = word_at(p);
  if (s == Scalar::f32) return fmt::format("{:.9g} (0x{:08x})", float_at(p), w);
  if (s == Scalar::i32) return fmt::format("{}", static_cast<int32_t>(w));
  return w < 10 ? fmt::format("{}", w) : fmt::format("{} (0x{:x})", w, w);
}

std::string describe_bytes(const std::byte* a, uint32_t stride) {
  std::string text = "0x";
  for (uint32_t i = 0; i < stride; ++i) text += fmt::format("{:02x}", static_cast<unsigned>(a[stride - 1 - i]));
  return text;
}

}  // namespace

std::string describe(const Elements& e, const std::byte* a, const std::byte* b) {
  if (e.components.empty()) return describe_bytes(a, e.stride);
  const bool equal = std::memcmp(a, b, e.stride) == 0;
  std::string text;
  uint32_t base = 0;
  for (const Layout& layout : *e.layouts) {
    for (const Field& f : layout.fields)
      for (uint32_t i = 0; i < f.count; ++i) {
        const uint32_t at = base + f.offset + 4 * i;
        if (!equal && word_at(a + at) == word_at(b + at)) continue;
        if (!text.empty()) text += ", ";
        if (!f.name.empty()) text += "." + f.name;
        if (f.count > 1) text += fmt::format("[{}]", i);
        if (!f.name.empty() || f.count > 1) text += " ";
        text += value_text(a + at, f.scalar);
      }
    base += layout.stride;
  }
  return text;
}

}  // namespace assay::check
