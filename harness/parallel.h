// Oracles' work on all of the host's threads. Host only.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace assay {

// Calls of(0) to of(n - 1), each once, in any order and at the same time; they must not write the same words, nor
// throw.
template <class Of>
void in_parallel(uint64_t n, const Of& of) {
  std::atomic<uint64_t> next = 0;
  const auto work = [&] {
    for (uint64_t i; (i = next++) < n;) of(i);
  };
  std::vector<std::jthread> others;
  for (uint64_t t = 1; t < std::min<uint64_t>(n, std::thread::hardware_concurrency()); ++t) others.emplace_back(work);
  work();
}

}  // namespace assay
