// The triangles of a case in the order that they are drawn, and the pixels that are judged.
#pragma once
#include <functional>

#include "kernels/visibility/coverage.h"

namespace assay::visibility {

struct DrawnTriangle {
  uint32_t order = 0;      // position in drawing order
  uint32_t primitive = 0;  // within its command
  uint32_t surface = 0;
  bool masked = false;
  Facing facing = Facing::both;
  std::array<uint32_t, 3> vertices = {};
};
void for_each_triangle(const Case&, const std::function<void(const DrawnTriangle&)>&);

// Of large targets the borders of every tile and a stratified sample; of others, or where the case says so, all pixels.
struct JudgedPixels {
  std::vector<uint64_t> list = {};      // ascending; empty: all
  std::vector<uint32_t> position = {};  // of a pixel in the list, kNotJudged elsewhere
};
constexpr uint32_t kNotJudged = 0xffffffffu;
JudgedPixels judged_pixels(const Case&);

}  // namespace assay::visibility
