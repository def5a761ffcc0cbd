// Parts of a case's pixels: what a shrinker tries next.
#pragma once
#include <span>
#include <vector>

#include "harness/kernel.h"

namespace assay {

struct Crop {
  Extent at, size;  // pixels
};

// The halves of each axis, then all but its last row or column; an axis of one pixel is left alone.
inline std::vector<Crop> smaller_crops(Extent e) {
  std::vector<Crop> crops;
  if (const uint32_t half = e.width / 2; half > 0) {
    crops.push_back({{0, 0}, {half, e.height}});
    crops.push_back({{half, 0}, {e.width - half, e.height}});
    crops.push_back({{0, 0}, {e.width - 1, e.height}});
  }
  if (const uint32_t half = e.height / 2; half > 0) {
    crops.push_back({{0, 0}, {e.width, half}});
    crops.push_back({{0, half}, {e.width, e.height - half}});
    crops.push_back({{0, 0}, {e.width, e.height - 1}});
  }
  return crops;
}

// The crop of an input that holds `per_pixel` elements a pixel in scan order; of an empty one, nothing.
template <class T>
std::vector<T> cropped(std::span<const T> from, Extent whole, const Crop& crop, size_t per_pixel = 1) {
  std::vector<T> part;
  for (uint32_t y = crop.at.height; !from.empty() && y < crop.at.height + crop.size.height; ++y) {
    const auto row = from.subspan((size_t{y} * whole.width + crop.at.width) * per_pixel, crop.size.width * per_pixel);
    part.insert(part.end(), row.begin(), row.end());
  }
  return part;
}

}  // namespace assay
