#include <cmath>
#include <limits>

#include "harness/clusters.h"
#include "kernels/decal_atlas_sampling/inputs.h"

namespace assay::decal_atlas_sampling {

using glm::dvec3;

namespace {

constexpr Extent kExtent = {40, 36};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
using Look = AtlasPlan::Look;

View wall(Extent e = kExtent, double distance = 8) {
  View v(e);
  v.set_plane(0, 0, e.width, e.height, {0, 0, -distance}, {0, 0, 1});
  return v;
}
View floor(double below = 1.5) {
  View v(kExtent);
  v.set_plane(0, 19, kExtent.width, kExtent.height, {0, -below, 0}, {0, 1, 0});
  return v;
}
// About the wall's middle, over nearly all of the screen.
DecalRecord on_wall(const View& v, uint32_t cell = 5, double size = 7, double angle = 0.3) {
  return decal({0, 0, -8}, {0, 0, 1}, angle, {size, size, 1}, v.atlas, cell);
}
DecalRecord on_floor(const View& v, uint32_t cell = 5, double angle = 0) {
  return decal({0, -1.5, -10}, {0, 1, 0}, angle, {10, 9.5, 1}, v.atlas, cell);
}

std::function<Case()> made(
    std::function<void(View&)> change, std::function<View()> from = [] { return wall(); }) {
  return [=] {
    View v = from();
    change(v);
    return v.to_case();
  };
}
// One decal on the wall, changed.
std::function<Case()> with(std::function<void(DecalRecord&)> change, Look look = Look::painted) {
  return made([=](View& v) {
    v.atlas.look = look;
    DecalRecord d = on_wall(v);
    change(d);
    v.decals = {d};
  });
}
std::function<Case()> sized(Extent e) {
  return made([](View& v) { v.decals = {on_wall(v)}; }, [e] { return wall(e); });
}
// The wall seen with these gradients over the depth, a colour a level.
std::function<Case()> gradients(uint16_t x, uint16_t y) {
  return made([=](View& v) {
    v.atlas.look = Look::levels;
    v.gradients.assign(v.gradients.size(), {x, y});
    v.decals = {on_wall(v)};
  });
}
// What lies in the input as T, changed.
template <class T, class F>
std::function<void(Case&)> after(const std::string& port, F change) {
  return [=](Case& c) {
    const auto was = c.input<T>(port);
    std::vector<T> now(was.begin(), was.end());
    change(now);
    c.set_input(port, now);
  };
}

std::vector<HardCase> size_cases() {
  return {{"one_pixel", "one lane of one group is alive", sized({1, 1})},
          {"group_and_one", "three more groups for one row and one column", sized({17, 17})},
          {"odd_extent", "rows that start in the middle of a subgroup of any width", sized({31, 33})},
          {"wide", "width and height cannot be swapped", sized({200, 3})},
          {"full_hd_and_one", "an odd extent of real size", sized({1921, 1081})},
          {"ultra_hd", "3840x2160, the largest frame",
           [] {
             return typical({3840, 2160});
           },
           true}};
}

std::vector<HardCase> box_cases() {
  return {
      {"one_decal", "a list of one entry, whose last is its first", made([](View& v) { v.decals = {on_wall(v)}; })},
      {"box_face", "the surface is on the box's face, an ulp inside and an ulp outside", made([](View& v) {
         for (const float offset : {2.0f, std::nextafter(2.0f, 3.0f), std::nextafter(2.0f, 1.0f)}) {
           DecalRecord d = on_wall(v, static_cast<uint32_t>(v.decals.size()));
           d.row_z = {0, 0, 0.125f, offset};
           v.decals.push_back(d);
         }
       })},
      {"behind_the_box", "the surface is behind the box, within its sides", made([](View& v) {
         v.params.grid.slices = 1;  // so that it is listed
         v.decals = {decal({0, 0, -5}, {0, 0, 1}, 0, {9, 9, 1}, v.atlas, 3)};
       })},
      {"grazing", "seen at 3 degrees and less",
       made([](View& v) { v.decals = {on_floor(v)}; }, [] { return floor(); })},
      {"grazing_levels", "the same with a colour a level",
       made(
           [](View& v) {
             v.atlas.look = Look::levels;
             v.decals = {on_floor(v)};
           },
           [] { return floor(); })},
      {"edge_on", "the box is square to the surface: v does not change along it", made([](View& v) {
         v.decals = {decal({0, 0, -8}, {1, 0, 0}, 0, {3, 3, 3}, v.atlas, 2)};
       })},
      {"scale_tiny", "a box of a millionth of a metre", made([](View& v) {
         v.decals = {decal({0.2, 0.2, -8}, {0, 0, 1}, 0, {1e-6, 1e-6, 1e-6}, v.atlas, 2)};
       })},
      {"scale_huge", "a box of a million metres: one texel over all of the screen", made([](View& v) {
         v.decals = {decal({3e5, 1e5, -8}, {0, 0, 1}, 0, {1e6, 1e6, 1e6}, v.atlas, 2)};
       })},
      {"sheared", "u grows with both of the surface's directions, v with one",
       with([](DecalRecord& d) { d.row_x += 0.7f * d.row_y; })},
      {"mirrored", "u falls to the right",
       with([](DecalRecord& d) { d.scale_bias.z += d.scale_bias.x, d.scale_bias.x = -d.scale_bias.x; })},
      {"flat_box", "no extent in u", with([](DecalRecord& d) {
         d.row_x = {0, 0, 0, 0.5f};
       })},
      {"far_away", "a million metres from the eye",
       made(
           [](View& v) {
             v.far = 2e6f;
             v.decals = {decal({1e4, 1e4, -1e6}, {0, 0, 1}, 0.2, {6e5, 6e5, 1e3}, v.atlas, 4)};
           },
           [] { return wall(kExtent, 1e6); })},
      {"no_surface", "pixels of depth 0, NaN, below 0 and infinite stay as they are", made([](View& v) {
         const float depths[] = {0, kNaN, -1, kInf, -kInf, 1e-30f};
         for (size_t i = 0; i < v.depth.size(); i += 3) v.depth[i] = depths[i % 6];
         v.decals = {on_wall(v)};
       })},
      {"no_decal", "nothing in any list", made([](View&) {})},
      {"moving_receiver", "the box is in the space of what it lies on, which has moved", made([](View& v) {
         v.receivers = {{{0, 1, 0, 3}, {-1, 0, 0, 2}, {0, 0, 1, -4}}};
         DecalRecord d = decal({3, 2, -12}, {0, 0, 1}, 0.3, {6, 5, 1}, v.atlas, 3);
         d.receiver = 0;
         v.decals = {d};
       })},
  };
}

std::vector<HardCase> filter_cases() {
  return {
      {"gradient_zero", "no gradient: level 0, wherever the decal goes", made([](View& v) {
         v.atlas.look = Look::levels;
         v.params.rays.across = vec3(0), v.params.rays.down = vec3(0), v.params.rays.corner = {0.1f, 0.1f, -1};
         v.decals = {on_wall(v)};
       })},
      {"gradient_nan", "no number: the last level", gradients(0x7e00, 0x7e00)},
      {"gradient_infinite", "of y alone", gradients(0, 0x7c00)},
      {"gradient_huge", "65504 times the depth a pixel", gradients(0x7bff, 0xfbff)},
      {"gradient_of_y", "only the way down is minified", gradients(0, 0x4400)},
      {"gradient_of_x", "only the way across is minified", gradients(0x4400, 0)},
      {"magnified", "a texel over many pixels: the weights' steps are seen", made([](View& v) {
         v.atlas.look = Look::stripes;
         v.decals = {on_wall(v, 5, 30)};
       })},
      {"loud_neighbours", "red beside green at every level, footprints across the rectangle's sides",
       made(
           [](View& v) {
             v.atlas.look = Look::loud;
             for (uint32_t i = 0; i < 5; ++i) {
               const double half = std::exp2(double(i)) * 0.09;
               v.decals.push_back(decal({1.3 * i - 3, 0.2, -8}, {0, 0, 1}, 0, {half, half, 1}, v.atlas, i));
             }
           },
           [] {
             return wall({160, 90});
           })},
      {"loud_neighbours_of_borders", "the same with a border as wide as the first level needs",
       made(
           [](View& v) {
             v.atlas.look = Look::loud, v.atlas.border = 5;
             for (uint32_t i = 0; i < 5; ++i) {
               const double half = std::exp2(double(i)) * 0.09;
               v.decals.push_back(decal({1.3 * i - 3, 0.2, -8}, {0, 0, 1}, 0, {half, half, 1}, v.atlas, i));
             }
             v.last = [](Case& c) {
               auto p = c.params<DecalParams>();
               p.atlas_border = 1;
               c.set_params(p);
             };
           },
           [] {
             return wall({160, 90});
           })},
      {"loud_grazing", "the same with footprints much longer than wide",
       made(
           [](View& v) {
             v.atlas.look = Look::loud;
             v.decals = {on_floor(v)};
           },
           [] { return floor(); })},
      {"stripes_along", "samples along a stripe see one colour, across it two",
       made(
           [](View& v) {
             v.atlas.look = Look::stripes;
             v.decals = {on_floor(v)};
           },
           [] { return floor(); })},
      {"one_texel", "a rectangle of a texel, without mips", made([](View& v) {
         v.atlas.side = 1, v.atlas.levels = 1;
         v.decals = {on_wall(v, 77)};
       })},
      {"one_texel_of_the_last_level", "at the last level the rectangle is a texel", made([](View& v) {
         v.atlas.side = 8, v.atlas.levels = 4, v.atlas.look = Look::loud;
         v.decals = {on_wall(v, 18, 0.5)};
       })},
      {"levels_smaller_than_a_block", "a page of 16 texels down to one of one", made([](View& v) {
         v.atlas.width = v.atlas.height = v.atlas.side = 16, v.atlas.levels = 5, v.atlas.look = Look::levels;
         for (uint32_t i = 0; i < 5; ++i) {
           const double half = std::exp2(double(i)) * 0.15;
           v.decals.push_back(decal({1.6 * i - 3.5, 0.2, -8}, {0, 0, 1}, 0.3, {half, half, 1}, v.atlas, i));
         }
       })},
      {"page_of_odd_size", "the last column and row of blocks reach over the page's sides", made([](View& v) {
         v.atlas.width = 30, v.atlas.height = 26, v.atlas.side = 13, v.atlas.levels = 2;
         v.decals = {on_wall(v, 3), on_wall(v, 0, 2)};
       })},
      {"page_past_the_end", "a page past the end is the last", with([](DecalRecord& d) { d.page = 900; })},
  };
}

std::vector<HardCase> blend_cases() {
  const auto mode = [](uint32_t m) { return with([m](DecalRecord& d) { d.normal_mode = m; }, Look::loud); };
  const auto weights = [](const vec3& w) { return with([w](DecalRecord& d) { d.weights = w; }, Look::loud); };
  const auto many = [](uint32_t n) {
    return made(
        [n](View& v) {
          v.params.grid = grid_over(v.extent, v.extent, 1);
          for (uint32_t i = 0; i < n; ++i) {
            v.decals.push_back(on_wall(v, i, 7, 0.01 * i));
            v.decals.back().weights = vec3(0.02f + 0.3f * static_cast<float>(i % 37 == 0));
          }
        },
        [] {
          return wall({9, 7});
        });
  };
  return {
      {"half_covered", "linear light: half of red on green is no average of codes", weights(vec3(0.5f))},
      {"base_alone", "normal and roughness keep their bits", weights({0.7f, 0, 0})},
      {"normal_alone", "base colour and roughness keep their bits", weights({0, 0.7f, 0})},
      {"roughness_alone", "base colour and normal keep their bits", weights({0, 0, 0.7f})},
      {"weights_out_of_range", "NaN and less than 0 touch nothing, more than 1 is 1", weights({kNaN, -1, 7})},
      {"linear", "the decal's normal takes the place of the surface's", mode(kNormalLinear)},
      {"whiteout", "slopes add up", mode(kNormalWhiteout)},
      {"reoriented", "the decal's normal turned as the surface's", made([](View& v) {
         v.atlas.look = Look::loud;
         v.normal.assign(v.normal.size(), packed_normal(glm::normalize(dvec3(0.6, 0.5, 0.6))));
         v.decals = {on_wall(v)};
         v.decals[0].normal_mode = kNormalReoriented;
       })},
      {"normal_turned_away", "the surface's normal against the decal's", made([](View& v) {
         v.normal.assign(v.normal.size(), packed_normal(glm::normalize(dvec3(0.1, 0.3, -1))));
         for (uint32_t m = 0; m < 3; ++m) {
           v.decals.push_back(on_wall(v, m, 3, m));
           v.decals.back().normal_mode = m;
         }
       })},
      {"mode_unknown", "whiteout", mode(77)},
      {"fading", "near, in its last quarter, gone, never", made([](View& v) {
         for (const float distance : {40.0f, 9.0f, 7.9f, 0.0f, -3.0f, kNaN, kInf}) {
           const double x = 2.0 * static_cast<double>(v.decals.size()) - 6;
           v.decals.push_back(decal({x, 0, -8}, {0, 0, 1}, 0, {0.9, 4, 1}, v.atlas, 3));
           v.decals.back().fade_distance = distance;
         }
       })},
      {"order", "the later decal lies on top, whatever is in between", made([](View& v) {
         v.atlas.look = Look::loud;
         for (uint32_t i = 0; i < 5; ++i) v.decals.push_back(on_wall(v, i, 7));
       })},
      {"list_full", "256 decals on every pixel", many(256)},
      {"list_overflows", "300: the lowest 256 by list, all by bits", many(300)},
      {"bits_full", "4096 by bits on every pixel", many(4096)},
  };
}

std::vector<HardCase> cell_cases() {
  return {
      {"cells_apart", "each cell has a decal of its own over the whole screen", made([](View& v) {
         v.atlas.look = Look::painted;
         v.set_plane(20, 0, kExtent.width, kExtent.height, {0, 0, -90}, {0, 0, 1});
         for (uint32_t i = 0; i < 60; ++i)
           v.decals.push_back(decal({0, 0, -50}, {0, 0, 1}, 0, {99, 99, 60}, v.atlas, i));
         v.last = [](Case& c) {
           const auto p = c.params<DecalParams>();
           const uint32_t all = p.grid.columns * p.grid.rows * p.grid.slices;
           std::vector<uint> entries, bits(size_t{2} * all);
           std::vector<uvec2> cells;
           for (uint32_t i = 0; i < all; ++i) {
             cells.emplace_back(i, 1u << kClusterDecalShift | 5u);  // five lights, too
             entries.push_back(i % 60 << kClusterDecalShift | 77u | 3u << kClusterProbeShift);
             bits[size_t{i % 60 / 32} * all + i] = 1u << i % 60 % 32;
           }
           auto changed = p;
           changed.entries = all;
           c.set_params(changed);
           c.set_input("cells", cells), c.set_input("entries", entries), c.set_input("decal_bits", bits);
         };
       })},
      {"on_a_slice", "depths on the boundaries of slices, one float nearer and one farther; a decal a slice",
       made([](View& v) {
         v.params.grid = grid_over(v.extent, v.extent, 24);
         const auto edges = reversed_slice_edges(slice_edges(v.params.near_plane, v.far, 24), v.params.near_plane);
         for (uint32_t y = 0; y < v.extent.height; ++y)
           for (uint32_t x = 0; x < v.extent.width; ++x) {
             const float d = edges[1 + (x + y) % 22];
             const float near_it[] = {d, std::nextafter(d, 0.0f), std::nextafter(d, 1.0f)};
             v.depth[size_t{y} * v.extent.width + x] = near_it[x / 4 % 3];
           }
         for (uint32_t i = 0; i < 24; ++i)
           v.decals.push_back(decal({0, 0, -50}, {0, 0, 1}, 0, {199, 199, 60}, v.atlas, i));
         v.last = [](Case& c) {
           auto p = c.params<DecalParams>();
           std::vector<uint> entries, bits;
           std::vector<uvec2> cells;
           for (uint32_t i = 0; i < 24; ++i) {
             cells.emplace_back(i, 1u << kClusterDecalShift);
             entries.push_back(i << kClusterDecalShift), bits.push_back(1u << i);
           }
           p.entries = 24;
           c.set_params(p);
           c.set_input("cells", cells), c.set_input("entries", entries), c.set_input("decal_bits", bits);
         };
       })},
      {"offset_past_the_end", "lists that begin or end past the entries", made([](View& v) {
         v.decals = {on_wall(v), on_wall(v, 8, 3)};
         v.last = after<uvec2>("cells", [](std::vector<uvec2>& cells) {
           for (size_t i = 0; i < cells.size(); ++i)
             if (i % 3 != 0) cells[i] = {i % 3 == 1 ? 0xffffffffu : 5u, 0xffffffffu};
         });
       })},
      {"index_past_the_end", "entries and bits of decals that there are not", made([](View& v) {
         v.decals = {on_wall(v), on_wall(v, 8, 3)};
         v.last = [](Case& c) {
           after<uint>("entries", [](std::vector<uint>& e) {
             for (size_t i = 0; i < e.size(); i += 2) e[i] = 0xfffff000u;
           })(c);
           after<uint>("decal_bits", [](std::vector<uint>& b) { b.assign(b.size(), 0xffffffffu); })(c);
         };
       })},
      {"receiver_past_the_end", "a decal on a receiver that there is not is none",
       with([](DecalRecord& d) { d.receiver = 3; })},
      {"matrix_no_number", "NaN and infinite rows hold no pixel", made([](View& v) {
         for (const float bad : {kNaN, kInf, -kInf}) {
           DecalRecord d = on_wall(v);
           d.row_y.x = bad;
           v.decals.push_back(d);
           d = on_wall(v);
           d.row_z.w = bad;
           v.decals.push_back(d);
         }
       })},
      {"frame_zero", "a decal without directions keeps the surface's normal",
       with([](DecalRecord& d) { d.tangent = d.bitangent = d.outward = vec3(0); })},
  };
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto& more : {size_cases(), box_cases(), filter_cases(), blend_cases(), cell_cases(), hard_cases_of_lists()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace assay::decal_atlas_sampling
