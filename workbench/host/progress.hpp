#pragma once
// Progress of long work, on standard error if it is a terminal.

#include <chrono>
#include <string>

namespace mbgen {

/// A line that is rewritten at most a few times a second. Silent unless on a terminal.
class StatusLine {
 public:
  StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  ~StatusLine() { clear(); }
  /// Whether to show something now: on a terminal, and some time after the last change.
  bool is_due() const;
  /// Writes the text, cut to the width of the terminal. Requires: is_due().
  void show(const std::string& text);
  /// Clears the line.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point last_;
};

/// Progress bar by completed steps.
class Progress {
 public:
  void show(long done, long of);
  /// Clears the bar.
  void clear() { line_.clear(); }

 private:
  StatusLine line_;
};

}  // namespace mbgen
