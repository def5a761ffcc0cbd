// Holes of masked materials: what alpha a device may sample at a pixel, and what follows.
#pragma once
#include <span>

#include "harness/formats/material.h"
#include "harness/raster/coverage.h"

namespace assay::raster {

// An attribute at a pixel's centre, perspective-correct, and how far a device may be from it. Infinite error: unknown.
struct Attribute {
  double value = 0, error = 0;
};
// `values`: one a vertex. The planes of value / w and 1 / w are evaluated in fp32 and divided. The point may lie
// `outside` pixels beside the triangle.
Attribute attribute_at(const Shape&, const std::array<double, 3>& values, double x, double y, double outside = 0);

// Alpha of a bilinear sample at level 0, repeat, over all admissible coordinates.
Interval sampled_alpha(const MaterialRecord&, std::span<const Texture>, const Attribute& texcoord_u,
                       const Attribute& texcoord_v, uint32_t sub_texel_bits);
// Whether the pixel is kept: `in` if alpha is surely not below the cutoff.
Cover kept(const MaterialRecord&, Interval sampled);
// Both, at a pixel's centre.
Cover kept_at(const Shape&, const std::array<vec2, 3>& uv, const MaterialRecord&, std::span<const Texture>,
              uint32_t sub_texel_bits, double x, double y);

}  // namespace assay::raster
