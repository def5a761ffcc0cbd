// What the deblocker makes of a picture. Host only.
#pragma once
#include <array>

#include "harness/kernel.h"
#include "kernels/vrcs_deblock/layout.h"

namespace assay::vrcs_deblock {

uint64_t tiles(const Case&);
uint64_t entries(const Case&);

using Texel = std::array<uint16_t, 4>;  // halves of red, green, blue, alpha

// What a pixel copies: nothing, or its neighbour to the side, above or below, or across.
enum class Kind : uint8_t { none, horizontal, vertical, diagonal };
std::vector<Kind> kinds_of(const Case&);

// Whether a pixel's neighbour, by their places in the picture, belongs to it.
using Belongs = std::function<bool(size_t, size_t)>;
Belongs belongs_by_depth(const Case&);
Belongs belongs_by_triangle(const Case&);

// Opposite neighbours of a pixel that count, by their places; as many as there are pairs.
using Pairs = std::vector<std::array<size_t, 2>>;
Pairs pairs_of(const Case&, Kind, size_t pixel, const Belongs&);
std::vector<Texel> deblocked(const Case&, const std::vector<Kind>&, const Belongs&);

// Luma of displayed colours, a function of halves at the case's exposure.
class Luma {
 public:
  explicit Luma(float exposure);
  uint8_t of(const Texel&) const;
  const std::vector<uint8_t>& codes() const { return codes_; }  // of each half

 private:
  std::vector<uint8_t> codes_;  // of each half
};

// radiance, then ranges of in_place (range.cpp): words of its texels and of luma.
struct ColourRange {  // a texel of in_place
  float red, green, blue;
  uint alpha;
};
struct LumaRange {
  float red, green;
};
Bytes unpack_texels(std::span<const std::byte>);
Bytes unpack_luma(std::span<const std::byte>);
void add_in_place(Answer& to, const Case&, const std::vector<Kind>&, const Luma&);

Answer answers(const Case&);

SHARED_LAYOUT(ColourRange, red, green, blue, alpha);
SHARED_LAYOUT(LumaRange, red, green);

}  // namespace assay::vrcs_deblock
