// What was found once and is asked for again.
#pragma once
#include <map>
#include <string>

namespace assay {

// The truth of an error table's class, by its name: the same for all variants, and the most of the work. Not for
// threads.
template <class T>
class Known {
 public:
  template <class Find>
  const T& at(const std::string& name, Find find) {
    const auto [found, is_new] = of_.try_emplace(name);
    if (is_new) found->second = find();
    return found->second;
  }

 private:
  std::map<std::string, T> of_;
};

}  // namespace assay
