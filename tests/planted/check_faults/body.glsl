// What every variant computes; the defines plant one fault each. Most fire only where a value is 7.
#include "harness/glsl/ports.glsl"
#include "tests/planted/check_faults/layout.h"

layout(local_size_x = 64) in;
#ifdef INPUT_WRITTEN
layout(scalar, binding = 0) coherent buffer values_block { uint values[]; };
#else
READS(0, uint, values);
#endif
WRITES(1, Pair, pairs);
WRITES(2, uint, list);
PARAMS(FaultParams);

const uint kMarked = 7u;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= params.count) return;
  uint value = values[i];
  bool marked = value == kMarked;
  Pair pair = Pair(3u * value + 1u, 0.5 * float(value));
#ifdef MUTANT_1
  if (marked) pair.key = 3u * value;
#endif
#ifdef MUTANT_2
  if (marked) pair.half_value += 1.0;
#endif
#ifdef MUTANT_3
  pair.key = 1u + 3u * value;  // no fault at all: must be reported as a survivor
#endif
#ifdef WRONG_VALUE
  if (marked) pair.key += 1u;
#endif
#ifdef NOT_A_NUMBER
  if (marked) pair.half_value = uintBitsToFloat(0x7fc00001u);
#endif
#ifdef UNWRITTEN
  if (!marked) pairs[i] = pair;
#elif defined(HALF_WRITTEN)
  pairs[i].key = pair.key;
  if (!marked) pairs[i].half_value = pair.half_value;
#else
  pairs[i] = pair;
#endif
#if defined(STRAY) || defined(MUTANT_4)
  if (marked) pairs[params.count] = pair;  // the first element behind the payload
#endif
#ifdef TOUCHED
  if (marked) list[params.count + 2u] = 0u;  // allocated, but no part of the list
#endif
#ifdef INPUT_WRITTEN
  if (marked) values[i] = 8u;
#endif
#ifdef REVERSED
  list[params.count - 1u - i] = value;  // another order, the same set
#elif defined(REPEATED)
  list[i] = values[marked ? 0u : i];
#else
  list[i] = value;
#endif
}
