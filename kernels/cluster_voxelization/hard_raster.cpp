// Hard cases of the variants that rasterise, and the faults of all that the cases must find.
#include <cmath>
#include <limits>

#include "kernels/cluster_voxelization/inputs.h"

namespace assay::cluster_voxelization {

using glm::dmat3;
using glm::dvec3;

namespace {

Case of_lights(std::vector<ClusterItem> lights, Scene s = {}) {
  s.lights = std::move(lights);
  return s.to_case();
}

// Boxes and spots from 1 to 100 m in front of the eye.
Scene crowd(uint columns, uint rows, uint slices) {
  Scene s;
  s.columns = columns, s.rows = rows, s.slices = slices;
  Pcg32 rng(columns + rows + slices);
  for (uint i = 0; i < 40; ++i) {
    s.lights.push_back(random_spot(rng, s, 6, 30));
    s.decals.push_back(random_box(rng, s, 2, 4));
  }
  return s;
}

// Every column with the same reversed depths.
Case with_depths(Scene s, float least, float greatest) {
  s.depth_ranges.assign(size_t{s.columns} * s.rows, vec2(least, greatest));
  return s.to_case();
}

// A box from 10 to 12 m, where near / depth is 10 exactly, or an ulp beside it, for both of a column's ends.
Case beside_a_surface(int ulps) {
  Scene s;
  s.near = 0.3125, s.lights = {box({0, 0, 11}, dmat3(1)), box({0, 0, 9}, dmat3(1))};
  const float at = 0.03125f;
  return with_depths(s, at, ulps < 0 ? std::nextafter(at, 0.0f) : ulps > 0 ? std::nextafter(at, 1.0f) : at);
}

std::vector<HardCase> outlines() {
  return {
      {"one_slice_from_the_eye", "cells as deep as the view: only outlines say anything",
       [] { return crowd(60, 34, 1).to_case(); }},
      {"last_of_a_bin", "items in the last column and row of a bin, and in what is left over beyond it",
       [] {
         Scene s = crowd(17, 9, 5);
         for (const double x : {7.5, 15.5, 16.5})
           for (const double y : {7.5, 8.5})
             s.lights.push_back(box({(x / 8.5 - 1) * 10, 0.5625 * (y / 4.5 - 1) * 10, 10}, dmat3(0.1)));
         return s.to_case();
       }},
      {"faces_seen_from_the_side", "planes of faces through the eye: neither seen nor turned away",
       [] {
         return of_lights({box({1, 1, 8}, dmat3(1)), box({-2, 0, 9}, dmat3(2)),
                           box({0, -1, 4}, dmat3(1, 0, 0, 0, 1, 0, 0, 0, 0)), pyramid({0, 0, 3}, {0, 2, 0}, 0.5)});
       }},
      {"eye_on_the_item", "the eye in a face, an edge and a corner, neither inside nor out",
       [] {
         return of_lights({box({0, 0, 1}, dmat3(1)), box({2, 0, 2}, dmat3(2)), box({3, 3, 3}, dmat3(3)),
                           box({0, 0, -1}, dmat3(1)), pyramid({0, -1, -1}, {0, 2, 2}, 0.7)});
       }},
      {"before_and_beyond_the_grid", "faces nearer than the first slice, or farther than the last, alone are met",
       [] {
         Scene s;
         s.extended = false, s.near = 4, s.far = 40;
         return of_lights({box({0, 0, 5}, dmat3(3)), box({1, 1, 40}, dmat3(8)), box({0, 0, 20}, dmat3(19)),
                           pyramid({0.1, 0.1, 3.9}, {1, 1, 30}, 0.4), pyramid({0, 0, 4.2}, {9, -3, -20}, 0.5)},
                          s);
       }},
      {"long_to_the_eye", "edges that point nearly at the eye: the planes through them are vague",
       [] {
         return of_lights(
             {pyramid({0.001, 0.002, 200}, {0, 0, -199}, 1e-4), pyramid({9, 3, 30}, {-8.7, -2.9, -29}, 1e-3)});
       }},
  };
}

std::vector<HardCase> depths() {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  std::vector<HardCase> cases = {
      {"surfaces_between", "from 5 to 20 m: items before and behind are in no cell",
       [] { return with_depths(crowd(16, 8, 24), 0.3f / 20, 0.3f / 5); }},
      {"surfaces_before_the_background", "from 5 m on, and open behind",
       [] { return with_depths(crowd(16, 8, 24), 0, 0.3f / 5); }},
      {"background_alone", "no surface, no cell", [] { return with_depths(crowd(16, 8, 24), 0, 0); }},
      {"surfaces_in_one_slice", "full depth, and the surfaces in a tenth of it",
       [] { return with_depths(crowd(60, 34, 1), 0.3f / 11, 0.3f / 10); }},
      {"leaps_of_depth", "columns that see 2 m and 200 m, and columns that see a wall: either list is the shorter",
       [] {
         Scene s = crowd(20, 11, 24);
         for (uint i = 0; i < 20 * 11; ++i)
           s.depth_ranges.push_back(i % 3 ? vec2(0.3f / 11, 0.3f / 10) : vec2(0.3f / 200, 0.3f / 2));
         return s.to_case();
       }},
      {"odd_depths", "NaN, infinite, negative, swapped, denormal: what says nothing keeps nothing away",
       [=] {
         Scene s = crowd(16, 8, 24);
         const vec2 odd[] = {{NAN, 0.1f},        {0.01f, NAN},           {-1, 0.1f},     {0.1f, 0.01f},
                             {0.01f, kInfinite}, {kInfinite, kInfinite}, {1e-40f, 0.1f}, {1e-40f, 1e-40f},
                             {2e30f, 3e38f},     {-0.0f, 0.1f}};
         for (uint i = 0; i < 16 * 8; ++i) s.depth_ranges.push_back(odd[i % 10]);
         return s.to_case();
       }},
  };
  for (const float near : {0.0f, -1.0f, NAN, kInfinite, 1e-20f})
    cases.push_back({"near_plane_" + std::to_string(cases.size() - 5), "no near plane: depths say nothing", [near] {
                       Case c = with_depths(crowd(16, 8, 24), 0.3f / 20, 0.3f / 5);
                       ClusterParams p = c.params<ClusterParams>();
                       p.near_plane = near;
                       c.set_params(p);
                       return c;
                     }});
  for (const int ulps : {-1, 0, 1})
    cases.push_back({"beside_a_surface_" + std::to_string(ulps + 1),
                     "an item that ends at the depth of the surfaces, or an ulp beside it",
                     [ulps] { return beside_a_surface(ulps); }});
  return cases;
}

}  // namespace

std::vector<HardCase> raster_cases() {
  std::vector<HardCase> all = outlines();
  for (HardCase& more : depths()) all.push_back(std::move(more));
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"common.glsl", 1, "no room for rounding", "through_corners"},
      {"common.glsl", 2, "the apex of a pyramid is forgotten", "apex_at_the_eye"},
      {"prepare.comp", 3, "infinities and NaN pass", "not_numbers"},
      {"prepare.comp", 4, "a column's left edge in place of its right one", "kinds_31_33_1"},
      {"prepare.comp", 5, "the last slice is left out", "on_a_slice"},
      {"prepare.comp", 6, "a box has three faces", "last_of_a_bin"},
      {"mark.glsl", 7, "the atomic of a cell's word is lost", "one_cell"},
      {"word.glsl", 8, "a last word's other bits are other kinds' items", "kinds_31_33_1"},
      {"mark.glsl", 9, "the barrier before the words are written is dropped", "one_cell"},
      {"mark.glsl", 11, "a cell has its near end alone", "kinds_31_33_1"},
      {"mark.glsl", 10, "one of a cell's four edges to the eye is looked at", "long_between_cells"},
      {"raster.glsl", 12, "a slice has its near end alone", "kinds_31_33_1"},
      {"raster.glsl", 15, "a bin ends a column and a row early", "last_of_a_bin"},
      {"outline.comp", 14, "an edge in the item's midst counts", "camera_inside"},
      {"hexahedra.glsl", 16, "the barrier before the list is read is dropped", "one_cell"},
      {"mark_hexahedra.glsl", 17, "the barrier before the words are written is dropped", "one_cell"},
      {"depths.glsl", 18, "nearest and farthest swapped", "surfaces_between"},
      {"depths.glsl", 19, "the background behind surfaces is forgotten", "surfaces_before_the_background"},
      {"tile_lists.comp", 26, "a list is as long as its last word", "kinds_31_33_1"},
      {"tile_lists.comp", 27, "the barrier before the lists are written is dropped", "one_cell"},
      {"smaller_list.comp", 28, "the list of the slice before", "surfaces_between"},
      {"smaller_list.comp", 29, "the longer list", "surfaces_between"},
      {"lists.glsl", 30, "bins of whole columns alone", "last_of_a_bin"},
      {"mark_two_pass.comp", 20, "the eye is never inside", "camera_inside"},
      {"mark_two_pass.comp", 21, "the last face's slice for the farthest", "kinds_31_33_1"},
      {"mark_two_pass.comp", 22, "the farthest slice is left out", "one_cell"},
      {"mark_two_pass.comp", 23, "the barrier between the passes is dropped", "through_corners"},
      {"mark_two_pass.comp", 25, "faces before the first slice are forgotten", "before_and_beyond_the_grid"},
      {"face.glsl", 24, "what looks away looks at the eye", "kinds_31_33_1"},
  };
}

}  // namespace assay::cluster_voxelization
