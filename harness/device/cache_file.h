// A file that is a cache: damaged or half written, it is as good as none.
#pragma once
#include <filesystem>
#include <span>

#include "harness/kernel.h"

namespace assay::device {

// The bytes behind a seal of their length and checksum. Written beside and renamed, so that two processes cannot mix.
void write_sealed(const std::filesystem::path&, std::span<const std::byte>);
// Empty where there is no such file, or its seal does not fit.
Bytes read_sealed(const std::filesystem::path&);

}  // namespace assay::device
