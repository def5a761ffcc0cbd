#include "harness/raster/smaller.h"

#include <algorithm>

#include "harness/formats/scene.h"

namespace assay::raster {

std::vector<Case> smaller_draws(const Case& c) {
  std::vector<Case> out;
  const auto draws = c.input<DrawCommand>("draws");
  const auto with = [&](auto change) {
    std::vector<DrawCommand> changed(draws.begin(), draws.end());
    for (size_t i = 0; i < changed.size(); ++i) change(changed[i], i);
    Case s = c;
    s.set_input("draws", changed);
    out.push_back(std::move(s));
  };
  const size_t half = (draws.size() + 1) / 2;
  if (draws.size() > 1) {
    with([=](DrawCommand& d, size_t i) {
      if (i >= half) d.index_count = 0;
    });
    with([=](DrawCommand& d, size_t i) {
      if (i < half) d.index_count = 0;
    });
    for (size_t k = 0; k < std::min<size_t>(draws.size(), 8); ++k)
      with([=](DrawCommand& d, size_t i) {
        if (i == k) d.index_count = 0;
      });
  }
  with([](DrawCommand& d, size_t) { d.index_count = d.index_count / 6 * 3; });
  with([](DrawCommand& d, size_t) {
    const uint32_t skipped = d.index_count / 6 * 3;
    d.first_index += skipped, d.index_count -= skipped;
  });
  with([](DrawCommand& d, size_t) { d.instance_count = (d.instance_count + 1) / 2; });
  return out;
}

}  // namespace assay::raster
