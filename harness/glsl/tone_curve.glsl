// Exposed radiance to 8-bit codes by the tables of harness/tone_curve.h: the leading bits of the radiance name a bucket, a
// table says the code at the bucket's start, and the thresholds from there on are compared with, mostly one. The includer
// declares, of kCodes and kBuckets elements:
//   READS(n, float, thresholds); READS(n, uint, first_codes);
//   #define TONE_THRESHOLDS thresholds
//   #define TONE_FIRST_CODES first_codes
#ifndef HARNESS_GLSL_TONE_CURVE
#define HARNESS_GLSL_TONE_CURVE
#include "harness/formats/exposure.h"

// At most 255 turns, for any ascending table.
uint code_of(float exposed) {
  if (!(exposed > 0.0)) return 0u;
  const uint leading = floatBitsToUint(exposed) >> kBucketShift;
  if (leading < kFirstBucket) return 0u;
#ifdef MUTANT_9702  // what is past the last bucket is black
  if (leading >= kFirstBucket + kBuckets) return 0u;
#else
  if (leading >= kFirstBucket + kBuckets) return kCodes - 1u;
#endif
  uint code = TONE_FIRST_CODES[leading - kFirstBucket];
#ifndef MUTANT_9701  // a bucket's first code for all of it
  while (code + 1u < kCodes && exposed >= TONE_THRESHOLDS[code + 1u]) ++code;
#endif
  return code;
}

#endif
