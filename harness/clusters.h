// The grid of cells that a view is cut into (formats/clusters.h), made once for the culler and for whoever looks cells
// up: both have the same floats.
#pragma once
#include <cstdint>
#include <vector>

#include "harness/formats/clusters.h"
#include "harness/kernel.h"

namespace assay {

// Depths at which slices begin, and the last one's end: near (far / near)^(k / slices), rounded up. 0 < near < far.
std::vector<float> slice_edges(double near, double far, uint32_t slices);
// The same boundaries in reversed depth d = near_plane / z, descending: the largest float of which near_plane / d is
// not nearer than the edge, so that d <= the k-th exactly where the depth is at the k-th edge or beyond it. An edge at
// 0 becomes the largest float.
std::vector<float> reversed_slice_edges(const std::vector<float>& edges, float near_plane);

// Cells of `cell_width` x `cell_height` pixels over a picture, those at its right and bottom cut off.
ClusterGrid grid_over(Extent picture, Extent cell, uint32_t slices);
// 16 x 8 cells, or cells of 32 pixels; both no more than formats/clusters.h allows, so of larger pictures larger.
Extent coarse_cell(Extent picture);
Extent fine_cell(Extent picture);

// Where a level of a picture's depth pyramid begins (kernels/hi_z): after those from 1 on, sides rounded up. Of a
// picture that has fewer levels, the last, of one texel.
uint32_t first_of_level(Extent picture, uint32_t level);
// Entries that the frame gives the cells' lists: all that the cells may hold, 2^22 (16 MiB) at most.
uint32_t list_capacity(const ClusterGrid&);

}  // namespace assay
