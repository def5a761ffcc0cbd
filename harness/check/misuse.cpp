// Poison: what a run left of it where it had to write, and what it touched where it must not.
#include <fmt/format.h>

#include <stdexcept>

#include "harness/check/elements.h"
#include "harness/check/judge.h"

namespace assay::check {

namespace {

std::byte poison_byte(uint32_t poison, uint64_t offset) {
  return static_cast<std::byte>(poison >> (8 * (offset % 4)) & 0xff);
}

// Small texels have no words of their own: poison runs through them byte by byte.
bool small_texel_is_poison(const Bytes& got, uint64_t offset, uint32_t stride, uint32_t poison) {
  for (uint64_t i = offset; i < offset + stride; ++i)
    if (got[i] != poison_byte(poison, i)) return false;
  return true;
}

bool any_word_is_poison(const std::byte* p, uint32_t stride, uint32_t poison) {
  for (uint32_t i = 0; i < stride; i += 4)
    if (word_at(p + i) == poison) return true;
  return false;
}

bool all_words_are_poison(const std::byte* p, uint64_t bytes, uint32_t poison) {
  for (uint64_t i = 0; i < bytes; i += 4)
    if (word_at(p + i) != poison) return false;
  return true;
}

}  // namespace

std::vector<Expected::Run> live_runs(const Expected& expected, uint64_t elements) {
  if (!expected.live) return {{0, elements}};
  uint64_t end = 0;
  for (const Expected::Run& run : *expected.live) {
    if (run.first < end || run.first > elements || run.count > elements - run.first)
      throw std::logic_error(fmt::format("oracle: live run of {} elements at {} overlaps another or passes the end, {}",
                                         run.count, run.first, elements));
    end = run.first + run.count;
  }
  return *expected.live;
}

std::vector<uint64_t> untouched(const Layout& layout, const Expected& expected, const Bytes& got, uint32_t poison) {
  std::vector<uint64_t> found;
  const uint32_t stride = layout.stride;
  for (const Expected::Run& run : live_runs(expected, got.size() / stride))
    for (uint64_t i = run.first; i < run.first + run.count; ++i)
      if (stride < 4 ? small_texel_is_poison(got, i * stride, stride, poison)
                     : any_word_is_poison(got.data() + i * stride, stride, poison))
        found.push_back(i);
  return found;
}

std::optional<uint64_t> strayed(const Layout& layout, const Expected& expected, const Bytes& got, uint32_t poison) {
  if (!expected.live) return {};
  const uint32_t stride = layout.stride;
  const uint64_t elements = got.size() / stride;
  auto runs = live_runs(expected, elements);
  runs.push_back({elements, 0});
  uint64_t from = 0;
  for (const Expected::Run& run : runs) {
    for (uint64_t i = from; i < run.first; ++i)
      if (stride < 4 ? !small_texel_is_poison(got, i * stride, stride, poison)
                     : !all_words_are_poison(got.data() + i * stride, stride, poison))
        return i;
    from = run.first + run.count;
  }
  return {};
}

std::string misuse(const Layout& layout, const Expected& expected, const Bytes& got, uint32_t poison) {
  if (const auto i = strayed(layout, expected, got, poison)) return fmt::format("element {} was written", *i);
  const auto left = untouched(layout, expected, got, poison);
  return left.empty() ? "" : fmt::format("element {} was not written", left[0]);
}

Layout layout_of_port(const Port& port) {
  if (port.kind == PortKind::buffer) return port.layout;
  const uint32_t bytes = bytes_per_block(port.format);
  Layout layout{name_of(port.format), bytes, {}};
  if (bytes < 4) return layout;
  const bool is_float = port.format == Format::r32_float || port.format == Format::rg32_float ||
                        port.format == Format::rgba32_float || port.format == Format::d32_float;
  layout.fields.push_back({"", 0, bytes / 4, is_float ? Scalar::f32 : Scalar::u32});
  return layout;
}

}  // namespace assay::check
