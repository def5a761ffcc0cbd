// A ray caster over a scene, in double, by brute force: what a pixel should show, and whether that is beyond doubt.
#pragma once
#include <cstdint>
#include <optional>

#include "harness/kernel.h"
#include "harness/scene/scene.h"

namespace assay::tests {

struct Hit {
  uint32_t instance = scene::kNone;  // kNone: the background, but something passes within a pixel
  uint32_t part = 0;
  uint32_t triangle = 0;     // within the part, from 0: gl_PrimitiveID of the part's draw
  double distance = 0;       // along the camera's axis, metres: near / depth
  double edge_px = 1;        // to the nearest edge of whatever is as near or nearer; 1 where farther
  bool alpha_close = false;  // a masked triangle as near or nearer has texels on both sides of its cutoff around
  double second = 0;         // distance of the next surface behind; infinite where none
};

// Through the point (x, y) in pixels; pixel centres lie at +0.5. Nothing: nothing even within a pixel. Back faces of
// single-sided materials and blended materials are passed, as in the visibility buffer.
std::optional<Hit> cast(const scene::Scene&, const scene::Camera&, Extent, double x, double y);

// Why a pixel cannot be judged by its ray: the rasteriser may see another surface, and be right.
enum class Doubt { none, edge, alpha, tie };
Doubt doubt_of(const std::optional<Hit>&);

}  // namespace assay::tests
