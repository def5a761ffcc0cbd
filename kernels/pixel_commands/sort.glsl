// A radix sort of (key, entry) pairs by four bits a pass, from the lowest, each pass stable: a count, a scan and a
// scatter, as AMD's FidelityFX ParallelSort (2021) has them. 4096 pairs a block, 16 a thread.
#include "kernels/pixel_commands/common.glsl"

const uint kThreads = 256u;
const uint kPairsPerThread = 16u;
const uint kDigits = 16u;

uint pairs() { return params.width * params.height; }
uint blocks() { return ceil_div(pairs(), kThreads * kPairsPerThread); }
uint digit_of(uint key, uint shift) { return key >> shift & kDigits - 1u; }
// The i-th pair of this thread: neighbours are a thread's own, so that threads in order are pairs in order.
uint pair_of(uint block, uint i) { return (block * kThreads + gl_LocalInvocationID.x) * kPairsPerThread + i; }
