#include "harness/frame/views.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "harness/formats/debug_view.h"
#include "harness/frame/frame.h"
#include "harness/frame/legend.h"

namespace assay::frame {

namespace {

constexpr const char* kDebugImage = "debug_view.image";
constexpr View kViews[] = {
    {"lit", "resolve.image", kViewCount, "resolve.image"},
    {"material", kDebugImage, kViewMaterial, kDebugImage},
    {"triangle", kDebugImage, kViewTriangle, kDebugImage},
    {"shader", kDebugImage, kViewShader, kDebugImage},
    {"wave", kDebugImage, kViewWave, "pixel_commands.entries"},
    {"tile", kDebugImage, kViewTile, "tile_classification.masks"},
    {"clusters", kDebugImage, kViewClusters, kClusterCells},
    {"workload", kDebugImage, kViewWorkload, "tile_classification.workload_tiles"},
    {"rate", kDebugImage, kViewRate, kRates, true},
    {"primary", kDebugImage, kViewPrimary, kCopyBits, true},
    {"shadows", kDebugImage, kViewShadows, kShadowDepth},
};

}  // namespace

bool in_registry(const std::string& resource) {
  const std::string kernel = resource.substr(0, resource.find('.'));
  return std::ranges::find(all_kernels(), kernel, &Kernel::name) != all_kernels().end();
}

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const View& v : kViews)
      if (in_registry(v.needs)) all.emplace_back(v.name);
    return all;
  }();
  return names;
}

std::string default_view() { return view_names().empty() ? "" : view_names().front(); }

const View& view_named(const std::string& name) {
  if (view_names().empty()) throw std::invalid_argument("no view: the kernels of this build draw none");
  const auto* it = std::ranges::find(kViews, name, &View::name);
  if (it == std::end(kViews) || !in_registry(it->needs))
    throw std::invalid_argument(fmt::format("no view '{}'; there are {}", name, fmt::join(view_names(), ", ")));
  return *it;
}

}  // namespace assay::frame
