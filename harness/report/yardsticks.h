// What this device can do at best, measured in the run that uses it: an empty dispatch, a copy, multiply and add; and
// how exactly it filters. At best means the least of the samples: load from elsewhere only ever adds.
#pragma once
#include <map>

#include "harness/report/timing.h"

namespace assay::report {

struct CopyFigure {
  uint64_t bytes = 0;      // read and written together
  double time_ns = 0;      // median, dispatch included
  double bytes_per_s = 0;  // without the empty dispatch; infinite where the copy is too small to be seen beside it
  std::vector<Sample> samples;
};

// The largest error of bilinear filtering at exact weights, in steps of 1/255: of sRGB textures' alpha, and of linear
// ones.
struct FilterFigure {
  double srgb_alpha = 0, linear = 0;
};

struct Yardsticks {
  double empty_ns = 0;          // one dependent dispatch and its barrier with nothing to do
  double operations_per_s = 0;  // single precision, a multiply and an add counting as two
  std::vector<Sample> empty_samples, arithmetic_samples;
  std::map<uint64_t, CopyFigure> copies;  // by bytes
  FilterFigure filter;
};

FilterFigure measure_filter(device::Device&);
// The empty dispatch, the arithmetic peak and the filter. Throws std::runtime_error where a yardstick computes
// nonsense.
Yardsticks measure_yardsticks(device::Device&, uint32_t count);
// The bandwidth of a copy that touches as many bytes, measured once a size (64 KiB to 128 MiB).
const CopyFigure& copy_at(device::Device&, Yardsticks&, uint64_t bytes, uint32_t count);

// The least time that the work can take here: the larger of bytes over copy bandwidth and operations over the rate,
// plus what its dependent dispatches cost when empty.
double limit_ns(const Yardsticks&, const CopyFigure&, const Cost&, uint32_t dispatches);

}  // namespace assay::report
