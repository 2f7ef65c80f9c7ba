#include "compiler/base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace mbgen::cli {
namespace {

constexpr int kWidth = 40;
constexpr std::chrono::milliseconds kInterval{100};

}  // namespace

Progress::Progress(long total) : total_(total), is_terminal_(::isatty(STDERR_FILENO) == 1), last_(Clock::now()) {}

void Progress::show(long done) {
  if (!is_terminal_ || Clock::now() - last_ < kInterval) return;
  last_ = Clock::now();
  is_shown_ = true;
  const double part = static_cast<double>(done) / static_cast<double>(total_);
  fmt::print(stderr, "\r[{:<{}}] {:3.0f} %", std::string(static_cast<std::size_t>(part * kWidth), '#'), kWidth,
             100 * part);
  std::fflush(stderr);
}

void Progress::clear() {
  if (is_shown_) fmt::print(stderr, "\r{:{}}\r", "", kWidth + 10);
}

}  // namespace mbgen::cli
