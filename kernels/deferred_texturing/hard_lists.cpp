// Hard cases of sizes, lists and indices.
#include "harness/formats/features.h"
#include "harness/formats/visibility.h"
#include "kernels/deferred_texturing/inputs.h"

namespace assay::deferred_texturing {

namespace {

// Two materials a class, no two alike.
Builder with_materials(Extent e) {
  Builder b(e);
  b.textures = shared_textures(32, 2, 40);
  for (uint32_t k = 0; k < 2 * kShaderClasses; ++k) {
    MaterialRecord m = plain_material(k % kShaderClasses);
    m.base_texture = texture_name(0, k % 2), m.metallic_roughness_texture = texture_name(1, k % 2);
    m.normal_texture = texture_name(2, k % 2), m.mask_texture = texture_name(3, k % 2);
    m.detail_texture = texture_name(4, k % 2), m.detail_scale = 3;
    m.base_colour = vec4(vec3(1 - 0.05f * static_cast<float>(k)), 1);
    m.layer = (k + 1) % kShaderClasses, m.features = 1u << k;
    b.add_material(m);
  }
  return b;
}

// Squares of `side` pixels, their materials in the order that `material` gives.
Builder squares(Extent e, uint32_t side, const std::function<uint32_t(uint32_t)>& material) {
  Builder b = with_materials(e);
  uint32_t i = 0;
  for (uint32_t y = 0; y < e.height; y += side)
    for (uint32_t x = 0; x < e.width; x += side, ++i) {
      const Rectangle r = {x, y, side, side};
      b.add_sheet(r, material(i), uv_by_pixel(r, vec2(0.02f), vec2(0.1f * static_cast<float>(i % 10))));
    }
  return b;
}
Builder mixed(Extent e, uint32_t side = 13) {
  return squares(e, side, [](uint32_t i) { return i * 5 % (2 * kShaderClasses); });
}

// Two materials of one class: for what the classes have in common, where the others would only be compiled.
Builder of_one_class(Extent e) {
  return squares(e, 13, [](uint32_t i) { return i % 2 * kShaderClasses; });
}

constexpr Extent kExtent = {72, 56};

// A pixel's surface is another's, whose class is another.
Case checkered(uint32_t materials) {
  Builder b = squares(kExtent, 40, [=](uint32_t i) { return i % materials; });
  for (uint32_t y = 0; y < kExtent.height; ++y)
    for (uint32_t x = 0; x < kExtent.width; ++x)
      b.visibility[size_t{y} * kExtent.width + x].y = (x + y) % static_cast<uint32_t>(b.surfaces.size());
  return b.finish();
}

template <class F>
Case changed(F change, Builder b = mixed(kExtent)) {
  change(b);
  return b.finish();
}
template <class F>
Case one_class_changed(F change) {
  return changed(change, of_one_class(kExtent));
}

uint entry(uint32_t x, uint32_t y, uint32_t copies = 0) {
  return x | y << kEntryCoordinateBits | copies << kEntryCopyShift;
}

// One class whose rows hold, beside its own pixels: the sky, another class's pixel, a pixel off the screen on each
// side.
Case stale_entries() {
  Builder b = squares({40, 40}, 21, [](uint32_t i) { return i; });  // four squares of four classes
  for (uint32_t x = 0; x < 40; ++x) b.visibility[x] = uvec2(kVisibilityNone);
  for (uint32_t x = 0; x < 40; ++x) b.visibility[size_t{39} * 40 + x] = {0, 77};
  // Beside one tile's pixels the same material shows another surface, so that its waves are divergent.
  b.surfaces.push_back(b.surfaces[0]), b.surfaces.push_back(b.surfaces[1]);
  b.surfaces.push_back(b.surfaces[2]), b.surfaces.push_back(b.surfaces[3]);
  for (uint32_t y = 1; y < 39; ++y)
    for (uint32_t x = y % 3; x < 40; x += 3) b.visibility[size_t{y} * 40 + x].y += 4;
  b.stale = {entry(3, 0),   entry(5, 39), entry(2, 3),  entry(30, 3),        entry(3, 30),
             entry(30, 30), entry(40, 3), entry(3, 40), entry(16383, 16383), entry(31, 0, kCopyBits)};
  return b.finish();
}

// The whole quad from one pixel, from each of its corners in turn; at the right and lower edge half of it is off.
Case copies() {
  const Extent e = {35, 21};
  Builder b = squares(e, 40, [](uint32_t) { return 3u; });
  b.copy_bits.assign(pixel_count(e), 0);
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) {
      const uint32_t quad = x / 2 + y / 2 * 3, primary = quad % 4, way = quad % 3;
      const uint32_t from_x = std::min(x / 2 * 2 + (way != 1 ? primary % 2 : x % 2), e.width - 1),
                     from_y = std::min(y / 2 * 2 + (way != 0 ? primary / 2 : y % 2), e.height - 1);
      uint8_t& bits = b.copy_bits[size_t{y} * e.width + x];
      if (x != from_x || y != from_y)
        bits = kCopyDuplicate;
      else
        bits = static_cast<uint8_t>(way == 0 ? kCopyHorizontal : way == 1 ? kCopyVertical : kCopyBits);
    }
  return b.finish();
}

std::vector<HardCase> index_cases() {
  return {
      {"flags", "instanced and flipped bits above the surface, in all four combinations",
       [] {
         return one_class_changed([](Builder& b) {
           for (uint32_t i = 0; i < b.surfaces.size(); ++i) b.flag_surface(i, i << 30);
         });
       }},
      {"surface_out_of_range", "count, count + 1, 2^30 - 2 and 2^30 - 1: nothing is shown",
       [] {
         return one_class_changed([](Builder& b) {
           const auto n = static_cast<uint32_t>(b.surfaces.size());
           const uint32_t index[] = {n - 1, n, n + 1, 0x3ffffffe, 0x3fffffff};
           for (size_t i = 0; i < b.visibility.size(); i += 3)
             b.visibility[i].y = index[i / 3 % 5] | static_cast<uint32_t>(i & 3) << 30;
         });
       }},
      {"material_out_of_range", "count, count + 1, 2^31 and 2^32 - 1: nothing is shown",
       [] {
         return one_class_changed([](Builder& b) {
           const uint32_t index[] = {2 * kShaderClasses - 1, 2 * kShaderClasses, 2 * kShaderClasses + 1, 1u << 31, ~0u};
           for (uint32_t i = 0; i < b.surfaces.size(); ++i) b.surfaces[i].material = index[i % 5];
         });
       }},
      {"class_out_of_range", "a class that there is not: nothing is shown",
       [] { return changed([](Builder& b) { b.materials[3].shader = kShaderClasses, b.materials[5].shader = ~0u; }); }},
      {"class_hidden", "a class that the frame has registered nowhere, and no pipeline for",
       [] { return changed([](Builder& b) {
              b.hidden_classes = {kShaderTwoLayer, kShaderFoliage};
            }); }},
      {"triangle_out_of_range", "indices past the end are the last",
       [] {
         return one_class_changed([](Builder& b) {
           for (size_t i = 0; i < b.visibility.size(); i += 2) b.visibility[i].x = i % 4 == 0 ? 1000 : 0xffffffffu;
         });
       }},
      {"vertex_out_of_range", "vertices past the end are the last",
       [] {
         return one_class_changed([](Builder& b) {
           for (uint32_t i = 0; i < b.surfaces.size(); ++i) b.surfaces[i].vertex_offset += i % 2 ? 5000 : ~0u - 2;
         });
       }},
      {"attributes_zero", "covered pixels without attributes: the normal is its own tangent",
       [] {
         return one_class_changed([](Builder& b) {
           for (size_t i = 0; i < b.visibility.size(); i += 2)
             b.barycentrics[i] = 0, b.derivatives[i] = uvec2(0), b.tangent_frame[i] = uvec2(0);
         });
       }},
      {"attributes_any", "bits that no interpolation leaves: weights beyond their sum, directions beyond the disc",
       [] {
         return one_class_changed([](Builder& b) {
           Pcg32 rng(5);
           for (size_t i = 0; i < b.visibility.size(); ++i) {
             b.barycentrics[i] = rng.next(), b.tangent_frame[i] = {rng.next(), rng.next()};
             b.derivatives[i].y = (b.derivatives[i].y & 0x0fffffffu) | rng.next() << 28;
           }
         });
       }},
  };
}

}  // namespace

std::vector<HardCase> list_cases() {
  const auto sizes = [](Extent e) { return [e] { return mixed(e).finish(); }; };
  std::vector<HardCase> cases = {
      {"one_pixel", "one lane of one wave is alive", sizes({1, 1})},
      {"one_tile", "exactly one", sizes({32, 32})},
      {"one_tile_and_one", "three more tiles for one row and one column", sizes({33, 33})},
      {"odd_extent", "partial tiles, and a last wave of padding for most materials", sizes({31, 33})},
      {"wide", "width and height cannot be swapped", sizes({200, 3})},
      {"screen_empty", "no surface, material, index or list", [] { return Builder(kExtent).finish(); }},
      {"screen_unseen", "surfaces that no pixel shows",
       [] {
         return changed([](Builder& b) {
           b.registers_unseen = true, b.visibility.assign(b.visibility.size(), uvec2(kVisibilityNone));
         });
       }},
      {"holes", "pixels without a surface between those with one",
       [] {
         return changed([](Builder& b) {
           for (size_t i = 0; i < b.visibility.size(); i += 3) b.visibility[i] = uvec2(kVisibilityNone);
         });
       }},
      {"one_surface", "full tiles of one surface: commands of 32 waves, all uniform",
       [] {
         return squares({96, 64}, 96, [](uint32_t) { return 4u; }).finish();
       }},
      {"one_material", "every pixel beside another surface's, one material: all divergent",
       [] { return checkered(1); }},
      {"two_materials", "surfaces and materials change from pixel to pixel", [] { return checkered(2); }},
      {"every_class", "sixteen materials of eight classes to a tile",
       [] { return squares(kExtent, 8, [](uint32_t i) { return i % 16; }).finish(); }},
      {"classes_pixel_by_pixel", "no two neighbours of a class: a wave of the full screen takes all branches",
       [] { return squares(kExtent, 1, [](uint32_t i) { return i % 16; }).finish(); }},
      {"overflow_all", "no room for padding: waves of several materials and tiles",
       [] { return changed([](Builder& b) { b.tiles_with_room = 0; }); }},
      {"overflow_some", "the last tiles only", [] { return changed([](Builder& b) { b.tiles_with_room = 3; }); }},
      {"stale_entries", "sky, another class's pixels and pixels off the screen: dropped", stale_entries},
      {"copies", "one result for several pixels, at odd edges too", copies},
      {"full_hd_and_one", "an odd extent of real size",
       [] {
         return mixed({1921, 1081}, 61).finish();
       }},
      {"ultra_hd", "3840x2160, the largest frame",
       [] {
         return mixed({3840, 2160}, 61).finish();
       },
       true},
  };
  for (HardCase& c : index_cases()) cases.push_back(std::move(c));
  return cases;
}

}  // namespace assay::deferred_texturing
