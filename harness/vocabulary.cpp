#include <algorithm>
#include <stdexcept>

#include "harness/kernel.h"
#include "harness/nearest.h"
#include "harness/oracle.h"

namespace assay {

namespace {

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
    case Feature::clip_distance:
      return "clip_distance";
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
    case Feature::texture_compression_bc:
      return "texture_compression_bc";
    case Feature::sampler_anisotropy:
      return "sampler_anisotropy";
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
Cost cost_of(const Kernel& k, const Variant& v, const Case& c) { return v.cost ? v.cost(c) : k.cost(c); }

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
