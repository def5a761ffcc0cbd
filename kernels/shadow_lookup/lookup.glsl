// A thread a receiver. The includer defines SHADOW_FILTER.
#include "harness/glsl/ports.glsl"
#include "kernels/shadow_lookup/layout.h"

layout(local_size_x = 64) in;
READS(0, Receiver, receivers);
READS(1, LightRecord, lights);
READS(2, ShadowView, shadow_views);
layout(binding = 3) uniform texture2D shadow_depth;
WRITES(4, float, shares);
PARAMS(LookupParams);

#define SHADOW_VIEWS params.views
#define SHADOW_EXTENT uvec2(params.atlas_width, params.atlas_height)
#include "harness/glsl/shadows.glsl"
#include "harness/glsl/tiles.glsl"

void main() {
  const uint index = spread_group() * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
  if (index >= params.receivers) return;
  const Receiver r = receivers[index];
  shares[index] =
      r.light < params.lights ? shadow_at(lights[r.light], r.position, r.plane_normal, r.dither) : 1.0;
}
