// Where cases come from: the kernel's hard ones, fixtures, files, seeds; and how well the random ones spread.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "harness/check/check.h"
#include "harness/kernel.h"

namespace assay::check {

struct NamedCase {
  std::string name;
  std::function<Case()> make;
  std::string replay;  // arguments of `assay check KERNEL`
};
// The kernel's hard cases, the nightly ones where asked for, then fixtures/<kernel>/*.case by name.
std::vector<NamedCase> hard_cases(const Kernel&, const std::filesystem::path& fixtures, bool nightly);
constexpr const char* kTypical = "typical";
// The case of that name: the benchmark's input at the kernel's first extent. None where the kernel has no benchmark.
std::vector<NamedCase> typical_case(const Kernel&);
// One of them all, nightly or not, or a case file; none where the kernel has no such case.
std::vector<NamedCase> cases_named(const Kernel&, const std::filesystem::path& fixtures, const std::string& name);
bool is_case_path(const std::string& name);
// The kernel that a case file is for. Throws std::runtime_error.
std::string kernel_of_case(const std::filesystem::path&);

struct Trial {
  Case input;
  uint64_t items = 0;  // pixels, or elements of the largest buffer where that is more
  bool wide = false;   // over 4 tiles a side; of a kernel without images as many items
  std::set<std::string> taken;
};
Trial random_case(const Kernel&, uint64_t seed);

// How often each branch of a generator fired and how large its cases were.
struct Coverage {
  uint64_t trials = 0, wide = 0, large = 0;
  std::map<std::string, uint64_t> branches;
};
void note(Coverage&, const Trial&);
// Undeclared branches at any time; from 1000 trials on starved branches (under 1 %), too few trials over 4 tiles a side
// (under 30 %) or over 100,000 items (under 5 %).
std::vector<std::string> complaints(const Coverage&, const std::vector<std::string>& declared);

}  // namespace assay::check
