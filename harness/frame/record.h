// A graph's commands, with a timestamp behind each pass, and times from stamps.
#pragma once
#include "harness/frame/frame.h"
#include "harness/frame/resources.h"

namespace assay::frame {

std::vector<device::Command> record(device::Device&, const Graph&, const Allocated&);
// A line a pass: the rows of a repeated one and the calls of a draw together.
std::vector<PassTime> pass_times(std::span<const device::Command>, const device::Timing&);

}  // namespace assay::frame
