#pragma once
// A progress bar on standard error, when that is a terminal.

#include <chrono>

namespace mbgen::cli {

/// Shows how many of `total` steps are done, a few times a second. Silent in a pipe.
class Progress {
 public:
  explicit Progress(long total);
  void show(long done);
  /// Takes the bar away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  long total_;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point last_;
};

}  // namespace mbgen::cli
