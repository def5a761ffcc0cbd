// Results as JSON. Infinite and undefined figures become null: JSON has no word for them.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/check/check.h"
#include "harness/report/bench.h"

namespace assay::report {

using Json = nlohmann::ordered_json;

const char* commit();   // of the sources built, "unknown" outside a checkout
std::string utc_now();  // "2025-01-31T12:00:00Z"

Json to_json(const device::Info&);
Json to_json(const check::BoundResult&);
// {"kernels":[{"name","variants":[{"name","baseline","trials","cases","violations","undecided","bounds":[…]}]}]}
Json to_json(const std::vector<check::KernelResult>&);
Json to_json(const std::vector<check::MutantResult>&);
Json to_json(const Run&, const device::Info&);
// The registry in the shape of check's results, nothing run yet: counts 0, worst null; ports and hard cases beside.
Json list_json(const std::vector<const Kernel*>&);

}  // namespace assay::report
