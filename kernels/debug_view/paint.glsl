// The view of one pixel that no list or tile has a say in; under the workloads and waves, the scene dimmed.
#include "kernels/debug_view/common.glsl"

uint colour_of(uvec2 visible) {
  switch (params.view) {
    case kViewTriangle: return triangle_colour(visible);
    case kViewWorkload:
    case kViewWave: return blended(greyed(material_colour(visible)), kBackgroundColour, 1u);
    default: return material_colour(visible);
  }
}
