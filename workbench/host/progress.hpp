#pragma once
// Progress of long work, on standard error: a line that is rewritten on a terminal, now and then a line of its own in a
// log.

#include <chrono>
#include <string>
#include <utility>

namespace mbgen {

/// Seconds between lines in a log: the number in the environment variable MBGEN_PROGRESS, 0 for no line; else
/// kSecondsBetweenLines.
constexpr double kSecondsBetweenLines = 5;
double seconds_between_lines();

/// On a terminal a line that is rewritten at most a few times a second, elsewhere lines of a log, the first one after
/// the seconds between two.
class StatusLine {
 public:
  StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  ~StatusLine() { clear(); }
  bool is_terminal() const { return is_terminal_; }
  /// Whether to show something now: some time after the last change.
  bool is_due() const;
  /// Writes the text, cut to the width of the terminal. Requires: is_due().
  void show(const std::string& text);
  /// Clears the line of a terminal.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::duration<double> interval_;  ///< zero: none is due
  Clock::time_point last_;
};

/// "12 s", "3 min", for people.
std::string time_text(double seconds);

/// Completed steps of a task, with an estimate of the time that is left.
class Progress {
 public:
  /// task: the first word of its lines in a log, as "simulate".
  explicit Progress(std::string task) : task_(std::move(task)) {}
  void show(long done, long of);
  /// Clears the bar.
  void clear() { line_.clear(); }

 private:
  std::string task_;
  StatusLine line_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace mbgen
