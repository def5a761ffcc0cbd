#version 460
// One group adds the groups' sums: every 256th a thread, then the tree.
#include "harness/glsl/ports.glsl"
#include "kernels/resolve/layout.h"

layout(local_size_x = 256) in;
READS(0, PartialSum, partials);
WRITES(1, ExposureRecord, exposure);
PARAMS(ResolveParams);

PartialSum joined(PartialSum a, PartialSum b) { return PartialSum(a.sum + b.sum, a.counted + b.counted); }
#include "kernels/resolve/exposure.glsl"
#include "kernels/resolve/tree.glsl"

void main() {
  const uint thread = gl_LocalInvocationIndex;
  if (params.metering == kMeterManual) {  // nothing was summed
    if (thread == 0u) exposure[0] = manual_exposure();
    return;
  }
  const uint blocks =
      (params.width + kBlockPixels - 1u) / kBlockPixels * ((params.height + kBlockPixels - 1u) / kBlockPixels);
  PartialSum mine = PartialSum(0.0, 0u);
#ifdef MUTANT_10  // sums past the 256th are left out
  if (thread < blocks) mine = partials[thread];
#else
  for (uint i = thread; i < blocks; i += 256u) mine = joined(mine, partials[i]);
#endif
  const PartialSum all = tree_sum(mine, thread);
  if (thread == 0u) exposure[0] = exposure_of(all);
}
