// A progress bar on stderr for whoever waits: drawn only on a terminal and only once the work has lasted two seconds.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace assay::report {

class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  // At most ten redraws a second. `of` 0: the total is not known.
  void update(const std::string& what, uint64_t done, uint64_t of);
  void clear();  // before anything else is printed

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), drawn_ = {};
  bool terminal_ = false, visible_ = false;
};

// "[#####.....] 50 %  what", at most `columns` wide.
std::string bar(const std::string& what, uint64_t done, uint64_t of, size_t columns);

}  // namespace assay::report
