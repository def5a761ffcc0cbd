#include <algorithm>
#include <stdexcept>

#include "harness/kernel.h"
#include "harness/nearest.h"
#include "harness/oracle.h"

namespace assay {

namespace {

struct FormatRow {
  Format format;
  const char* name;
  uint32_t bytes;
};
constexpr FormatRow kFormats[] = {
    {Format::r8_unorm, "r8_unorm", 1},          {Format::r8_uint, "r8_uint", 1},
    {Format::rg8_unorm, "rg8_unorm", 2},        {Format::rgba8_unorm, "rgba8_unorm", 4},
    {Format::rgba8_srgb, "rgba8_srgb", 4},      {Format::rgba8_uint, "rgba8_uint", 4},
    {Format::r16_unorm, "r16_unorm", 2},        {Format::r16_float, "r16_float", 2},
    {Format::rg16_snorm, "rg16_snorm", 4},      {Format::rg16_unorm, "rg16_unorm", 4},
    {Format::rg16_float, "rg16_float", 4},      {Format::rgba16_float, "rgba16_float", 8},
    {Format::rgba16_uint, "rgba16_uint", 8},    {Format::r32_uint, "r32_uint", 4},
    {Format::r32_float, "r32_float", 4},        {Format::rg32_uint, "rg32_uint", 8},
    {Format::rg32_float, "rg32_float", 8},      {Format::rgba32_uint, "rgba32_uint", 16},
    {Format::rgba32_float, "rgba32_float", 16}, {Format::r11g11b10_float, "r11g11b10_float", 4},
    {Format::rgb9e5_float, "rgb9e5_float", 4},  {Format::d32_float, "d32_float", 4},
};

const FormatRow& row_of(Format f) {
  const auto* row = std::ranges::find(kFormats, f, &FormatRow::format);
  if (row == std::end(kFormats)) throw std::logic_error("a format without a row");
  return *row;
}

size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

uint32_t bytes_per_texel(Format f) { return row_of(f).bytes; }
const char* name_of(Format f) { return row_of(f).name; }

const char* name_of(Feature f) {
  switch (f) {
    case Feature::subgroup_ballot:
      return "subgroup_ballot";
    case Feature::subgroup_arithmetic:
      return "subgroup_arithmetic";
    case Feature::subgroup_shuffle:
      return "subgroup_shuffle";
    case Feature::subgroup_clustered:
      return "subgroup_clustered";
    case Feature::primitive_id:
      return "primitive_id";
    case Feature::draw_indirect_count:
      return "draw_indirect_count";
    case Feature::int64:
      return "int64";
    case Feature::image_int64_atomics:
      return "image_int64_atomics";
    case Feature::float16:
      return "float16";
    case Feature::descriptor_indexing:
      return "descriptor_indexing";
    case Feature::forward_progress:
      return "forward_progress";
  }
  throw std::logic_error("a feature without a name");
}

const Kernel& kernel_named(const std::string& name) {
  const auto& all = all_kernels();
  const auto it = std::ranges::find(all, name, &Kernel::name);
  if (it != all.end()) return *it;
  std::vector<std::string> there(all.size());
  std::ranges::transform(all, there.begin(), &Kernel::name);
  throw std::invalid_argument("no kernel '" + name + "'" + did_you_mean(name, there));
}

std::string did_you_mean(const std::string& name, std::span<const std::string> there) {
  const auto nearest = std::ranges::min_element(there, {}, [&](const auto& t) { return edit_distance(t, name); });
  return nearest == there.end() ? "" : "; did you mean '" + *nearest + "'?";
}

const Port& port_of(const Kernel& kernel, const std::string& name) {
  const auto it = std::ranges::find(kernel.ports, name, &Port::name);
  if (it == kernel.ports.end()) throw std::logic_error(kernel.name + " has no port " + name);
  return *it;
}

const std::vector<Bound>& bounds_of(const Kernel& k, const Variant& v) { return v.bounds ? *v.bounds : k.bounds; }

Extent random_extent(Random& r, uint32_t tile) {
  const auto between = [&](uint32_t low, uint32_t high) { return low + r.rng.below(high - low + 1); };
  switch (r.branch({{"extent_tiny", 0.34}, {"extent_middle", 0.2}, {"extent_tiles", 0.4}, {"extent_large", 0.06}})) {
    case 0:
      return {between(1, 40), between(1, 40)};
    case 1:
      return {between(1, 4 * tile), between(1, 4 * tile)};
    case 2:
      return {between(4 * tile + 1, 6 * tile), between(4 * tile + 1, 6 * tile)};
    default:
      return {between(330, 420), between(310, 400)};
  }
}

uint64_t ulp_distance(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) return UINT64_MAX;
  const auto ordered = [](float f) {
    const auto bits = std::bit_cast<int32_t>(f);
    return static_cast<int64_t>(bits < 0 ? INT32_MIN - int64_t{bits} : bits);
  };
  const int64_t d = ordered(a) - ordered(b);
  return static_cast<uint64_t>(d < 0 ? -d : d);
}

}  // namespace assay
