// Reading JSON that may be broken: every error is a std::runtime_error of one line, "<file>: <place>: <what>".
#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace assay::scene {

// Throws "<place>: <what>"; naming() puts the file before it.
[[noreturn]] void refuse(const std::string& place, const std::string& what);
// Runs `read`; whatever it throws, libraries' own exceptions and running out of memory too, becomes one line that
// begins with the file.
void naming(const std::filesystem::path& file, const std::function<void()>& read);

std::string read_file(const std::filesystem::path&);
nlohmann::json parse_json(std::string_view);  // an object

}  // namespace assay::scene
