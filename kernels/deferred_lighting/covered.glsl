// Whether a pixel is covered is asked of what the lists of primaries were made from, not of the depth: so a pixel is a
// primary's, or copied from one, or background, and never two of them.
#include "harness/formats/visibility.h"
#include "kernels/deferred_lighting/common.glsl"

layout(binding = 13) uniform utexture2D visibility;

bool is_covered(uvec2 pixel) {
#ifdef MUTANT_18  // asked of the depth
  return depth_at(pixel) != 0.0;
#else
  return texelFetch(visibility, ivec2(pixel), 0).xy != uvec2(kVisibilityNone);
#endif
}
