// For messages about a name that does not exist.
#pragma once
#include <span>
#include <string>

namespace assay {

// "; did you mean 'atomic'?" with the name that takes the fewest edits; empty where there is none to offer.
std::string did_you_mean(const std::string& name, std::span<const std::string> there);

}  // namespace assay
