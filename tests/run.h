// What the tests of one process share: the device, opened at first use, and the kernels of both registries.
#pragma once
#include <string>
#include <vector>

#include "harness/device/device.h"
#include "harness/kernel.h"

namespace assay {
const std::vector<Kernel>& planted_kernels();  // generated
}

namespace assay::tests {

// ASSAY_DEVICE (index, UUID or name) and ASSAY_VALIDATION (off, core, sync, gpuav; off where unset).
const device::Options& device_options();
device::Handle& device();
const Kernel& planted(const std::string& name);
std::vector<std::string> kernel_names();
// From the environment, for what differs between a developer's run and a nightly one; empty where unset.
std::string text_from(const char* variable);
uint32_t number_from(const char* variable, uint32_t otherwise);

}  // namespace assay::tests
