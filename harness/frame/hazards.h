// Missing barriers, found in recorded commands before they are submitted. It reads the commands alone (what each binds,
// where it touches it, which barriers lie between) and knows nothing of the graph that placed the barriers.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "harness/device/device.h"

namespace assay::frame {

enum class HazardKind { read_after_write, write_after_read, write_after_write };
const char* name_of(HazardKind);

struct Hazard {
  HazardKind kind;
  std::string first, second;            // labels of the commands
  std::string first_port, second_port;  // by which each touches the resource
  std::string resource;
  uint32_t from = 0, to = 0;  // scopes that a barrier between them would have to join
};
std::string to_text(const Hazard&);  // one line

// Every pair of commands that touch a common range, one of them writing, with no chain of barriers from the scopes of
// the first to all scopes of the second. The rows of one repeated pass are one command: that they keep out of each
// other's way is the kernel's promise, which its oracle checks.
std::vector<Hazard> find_hazards(std::span<const device::Command>);
// Throws std::logic_error with the first hazard and how many there are.
void require_no_hazards(std::span<const device::Command>);

// A command's label without the number of a repeated pass's row.
std::string without_row(const std::string& label);

}  // namespace assay::frame
