#include "harness/report/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace assay::report {

namespace {

constexpr size_t kBarCells = 24;

size_t terminal_columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string bar(const std::string& what, uint64_t done, uint64_t of, size_t columns) {
  std::string text;
  if (of == 0) {
    text = fmt::format("{:>6}  {}", done, what);
  } else {
    const double share = static_cast<double>(std::min(done, of)) / static_cast<double>(of);
    const auto full = static_cast<size_t>(share * static_cast<double>(kBarCells));
    text = fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  {}", "", full, "", kBarCells - full, 100 * share, what);
  }
  return text.substr(0, columns);
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::update(const std::string& what, uint64_t done, uint64_t of) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (!terminal_ || now - start_ < 2s || now - drawn_ < 100ms) return;
  drawn_ = now;
  visible_ = true;
  fmt::print(stderr, "\r\x1b[K{}", bar(what, done, of, terminal_columns() - 1));
  std::fflush(stderr);
}

void Progress::clear() {
  if (!visible_) return;
  visible_ = false;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace assay::report
