#pragma once
// Progress of long work, on standard error, when that is a terminal.

#include <chrono>
#include <string>

namespace mbgen {

/// A line that is written over as things change, a few times a second. Silent in a pipe.
class StatusLine {
 public:
  StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  ~StatusLine() { clear(); }
  /// Whether to show something now: on a terminal, unless the line changed a moment ago.
  bool is_due() const;
  /// Writes the text, cut at the width of the terminal. Requires: is_due().
  void show(const std::string& text);
  /// Takes the line away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point last_;
};

/// A bar of how many steps are done.
class Progress {
 public:
  void show(long done, long of);
  /// Takes the bar away.
  void clear() { line_.clear(); }

 private:
  StatusLine line_;
};

}  // namespace mbgen
