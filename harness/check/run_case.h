// One case, one variant, one run on the device: poison, run, read back, judge.
#pragma once
#include <string>
#include <vector>

#include "harness/check/check.h"
#include "harness/check/judge.h"

namespace assay::check {

struct Prepared {  // a case with the device's traits and the oracle's answer to it, good for every variant
  Case input;
  Answer answer;
};
Prepared prepare(const Kernel&, Case, const DeviceTraits&);

// A word that no result holds by design: a quiet NaN of either sign, over 2^30 as an integer. Choices 0 and 1 of a seed
// differ in each byte, so that what equals both was never written.
uint32_t poison_word(uint64_t seed, uint32_t choice);

// What the port's words hold before a run. Depth images may hold only 0 to 1: theirs is in [0.75, 1), and as unlikely.
uint32_t poison_of(const Port&, uint64_t seed, uint32_t choice);

// The bounds that hold for the variant: those of ports that it has.
std::vector<Bound> bounds_for(const Kernel&, const Variant&);

struct Fault {
  std::string kind;  // what is wrong and where, without numbers: the shrinker keeps to one kind
  std::string text;  // empty: nothing is wrong
};
struct Outcome {
  // Counts for baselines too: a write behind a port or to an input, an element that was not written though it must be
  // whatever the values are. Where the oracle names live runs, which elements are live is itself a value.
  Fault memory;
  Fault wrong;                    // unwritten or touched elements of live runs, a broken bound
  std::vector<Verdict> verdicts;  // one a bound, in the bounds' order
  bool flaky = false;             // the device was lost once and the repeat went through
};
// The fault that counts for the variant, if any.
const Fault& fault_of(const Outcome&, const Variant&);

// `inputs`: compare every input afterwards. Reflection has refused shaders that could write one, so what is left is a
// driver's fault: hard cases look for it, random trials save the time.
Outcome run_case(device::Device&, const device::Plan&, const Prepared&, const device::Ports&, bool inputs);

// A device that is replaced when it is lost.
struct Session {
  device::Handle& device;
  const device::Options& options;
};
// run_case with one retry on a fresh device after a loss; whatever the device throws becomes a fault. `ports` is given
// what the variant still lacks, and everything again on a fresh device. A description, shader or oracle at odds with
// the others throws std::logic_error.
Outcome attempt(Session&, const device::Plan&, const Prepared&, device::Ports& ports, bool inputs);

}  // namespace assay::check
