// Hard cases of sizes, lists and indices, and the mutants.
#include "harness/formats/features.h"
#include "harness/formats/visibility.h"
#include "kernels/deferred_texturing/inputs.h"

namespace assay::deferred_texturing {

namespace {

// Sheets of every class over the screen, side pixels each, their materials in turn.
Case tiled(Extent e, uint32_t side = 13) {
  Builder b(e);
  b.textures = shared_textures(32, 2, 40);
  for (uint32_t k = 0; k < 2 * kShaderClasses; ++k) {
    MaterialRecord m = plain_material(k % kShaderClasses);
    m.base_texture = texture_name(0, k % 2), m.metallic_roughness_texture = texture_name(1, k % 2);
    m.normal_texture = texture_name(2, k % 2), m.mask_texture = texture_name(3, k % 2);
    m.detail_texture = texture_name(4, k % 2), m.detail_scale = 3;
    m.layer = (k + 1) % kShaderClasses, m.features = 1u << k;
    b.add_material(m);
  }
  uint32_t i = 0;
  for (uint32_t y = 0; y < e.height; y += side)
    for (uint32_t x = 0; x < e.width; x += side, ++i) {
      const Rectangle r = {x, y, side, side};
      b.add_sheet(r, i * 5 % (2 * kShaderClasses), uv_by_pixel(r, vec2(0.02f)));
    }
  return b.finish();
}

}  // namespace

std::vector<HardCase> list_cases() {
  const auto sizes = [](Extent e) { return [e] { return tiled(e); }; };
  return {
      {"one_pixel", "one lane of one wave is alive", sizes({1, 1})},
      {"odd_extent", "partial tiles, and a last wave of padding for most materials", sizes({31, 33})},
      {"full_hd_and_one", "an odd extent of real size", [] { return tiled({1921, 1081}, 61); }},
      {"ultra_hd", "3840x2160, the largest frame", [] { return tiled({3840, 2160}, 61); }, true},
  };
}

std::vector<Mutant> mutants() { return {}; }

}  // namespace assay::deferred_texturing
