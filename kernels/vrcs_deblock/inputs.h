// Cases for the deblocker.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "harness/vrcs_oracle.h"
#include "kernels/vrcs_deblock/oracle.h"

namespace assay::vrcs_deblock {

// What a case is made of; pixels and cells in rows. Covered by one triangle of one surface at first, rates 1x1.
struct Picture {
  Extent extent = {};
  uint frame = 0;
  float exposure = 1;
  std::vector<Texel> texels = {};  // as a pass at full rate would shade them
  std::vector<uvec2> visibility = {};
  std::vector<float> depth = {};
  std::vector<uint8_t> rates = {};

  size_t place(uint x, uint y) const { return size_t{y} * extent.width + x; }
};
Texel grey(double value);
Picture blank(Extent);
template <class F>
Picture painted(Extent e, F colour_at) {
  Picture p = blank(e);
  for (uint y = 0; y < e.height; ++y)
    for (uint x = 0; x < e.width; ++x) p.texels[p.place(x, y)] = colour_at(x, y);
  return p;
}
inline Picture at_rate(Picture p, uint rate, uint frame = 0) {
  p.rates.assign(p.rates.size(), static_cast<uint8_t>(rate));
  p.frame = frame;
  return p;
}

using vrcs::Lists;
Lists lists_of(const Picture&);  // the picture's own

// Duplicates hold their primaries' texels, by the picture's own lists or by any.
Case case_of(const Picture&);
Case case_of(const Picture&, const Lists&);

Case in_frame(const FrameInputs&);
Case typical(Extent);  // a fifth of sky, triangles of 24 pixels, a rate a tile
Inputs inputs();
std::vector<HardCase> hard_cases();  // hard.cpp
std::vector<Mutant> mutants();
ErrorTable error_table();  // errors.cpp

}  // namespace assay::vrcs_deblock
