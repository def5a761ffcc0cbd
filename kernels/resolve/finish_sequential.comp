#version 460
// One thread adds the groups' sums in a chain, as atomics would in an order of their own: the error grows with their
// number. At most 32,768 of them, far enough from lavapipe's 65,535 turns.
#include "harness/glsl/ports.glsl"
#include "kernels/resolve/layout.h"

layout(local_size_x = 64) in;
READS(0, PartialSum, small_partials);
WRITES(1, ExposureRecord, exposure);
PARAMS(ResolveParams);
#include "kernels/resolve/exposure.glsl"

void main() {
  if (gl_LocalInvocationIndex != 0u) return;
  if (params.metering == kMeterManual) {
    exposure[0] = manual_exposure();
    return;
  }
  const uint blocks =
      (params.width + kSmallBlock - 1u) / kSmallBlock * ((params.height + kSmallBlock - 1u) / kSmallBlock);
  PartialSum all = PartialSum(0.0, 0u);
  for (uint i = 0u; i < min(blocks, 32768u); ++i) {
    all.sum += small_partials[i].sum;
    all.counted += small_partials[i].counted;
  }
  exposure[0] = exposure_of(all);
}
