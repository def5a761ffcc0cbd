// Four depths a thread, one byte of its word each.
#include "harness/glsl/ports.glsl"
#include "kernels/cluster_slices/layout.h"

layout(local_size_x = 64) in;
READS(0, float, slice_edges);
WRITES(1, uint, slices);
PARAMS(SliceParams);

uint slice_at(float d);

void main() {
  const uint word = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x);
  if (word >= params.words) return;
  uint four = 0u;
  for (uint i = 0u; i < 4u; ++i) {
#ifdef MUTANT_1  // the second depth twice
    const uint bits = params.first + word * 4u + max(i, 1u);
#else
    const uint bits = params.first + word * 4u + i;
#endif
#ifdef MUTANT_6  // seven bits apart
    four |= slice_at(uintBitsToFloat(bits)) << (7u * i);
#else
    four |= slice_at(uintBitsToFloat(bits)) << (8u * i);
#endif
  }
#ifdef MUTANT_2  // the last word is left as it was
  if (word + 1u < params.words) slices[word] = four;
#else
  slices[word] = four;
#endif
}
