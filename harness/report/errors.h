// What a kernel's error table says of each variant: figures over classes of inputs, measured on the device.
#pragma once
#include "harness/device/device.h"
#include "harness/report/table.h"

namespace assay::report {

// A variant with its constants over one class.
struct ErrorRow {
  const Kernel* kernel = nullptr;
  const Variant* variant = nullptr;
  std::string label;  // the variant with its constants
  std::string input_class;
  std::vector<Figure> figures;
};
// Of one class; none where the table has none of the variant.
std::vector<Figure> measure_errors(device::Device&, const device::Plan&, const HardCase& input_class);
// Every class of the kernel's table but the nightly ones; nothing where it has none, or the variant cannot run here.
std::vector<ErrorRow> measure_errors(device::Device&, const Kernel&, const Variant&,
                                     const std::map<std::string, uint32_t>& constants);
// "recentred, class huge: weight max is 2e-06, the goal 1e-06", a line each that is past its goal, NaN too.
std::vector<std::string> missed_goals(const std::vector<ErrorRow>&);

// What stands beside a variant's errors, by its label.
struct SpeedAndSize {
  double time_ns = 0, bytes = 0;
};
// A kernel after the other; of each the variant that errs least first (by the first figure's median over the classes).
Table error_table(const std::vector<ErrorRow>&, const std::map<std::string, SpeedAndSize>& beside);

}  // namespace assay::report
