#include "kernels/blended_luma/oracle.h"

#include <array>

#include "kernels/blended_luma/layout.h"

namespace assay::blended_luma {

// Rec. 709's weights in 2^16ths of the three codes that the table has for the picture's halves, to the nearest.
Answer lumas(const Case& c) {
  const auto texels = c.input<std::array<uint16_t, 4>>("radiance");
  const auto codes = c.input<uint8_t>("half_codes");
  const auto before = c.input<std::array<uint8_t, 2>>("luma");
  std::vector<std::array<uint8_t, 2>> after(before.begin(), before.end());
  for (size_t i = 0; i < after.size(); ++i) {
    const uint sum =
        kLumaRed * codes[texels[i][0]] + kLumaGreen * codes[texels[i][1]] + kLumaBlue * codes[texels[i][2]];
    after[i][1] = static_cast<uint8_t>((sum + 32768) / 65536);
  }
  return {{"luma", expect_all(after)}};
}

}  // namespace assay::blended_luma
