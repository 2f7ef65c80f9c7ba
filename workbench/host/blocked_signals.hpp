#pragma once
// Blocking of termination signals during work that has to be cleaned up.

#include <atomic>
#include <chrono>
#include <csignal>

namespace mbgen {

/// Blocks SIGINT, SIGTERM and SIGHUP in its thread and in threads started from it, for its lifetime, except signals
/// that are already ignored, handled or blocked. A pending signal acts at the end.
class BlockedSignals {
 public:
  /// beside: another signal to block, for `wait`.
  explicit BlockedSignals(int beside = 0);
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;
  ~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  /// Waits for a blocked signal. Result: the termination signal; 0 for `beside`, or after the longest time.
  int wait(std::chrono::nanoseconds longest) const;
  /// The pending termination signal, 0 for none; polled a few times a second. Thread-safe.
  int taken();
  /// Signal mask before this object.
  const sigset_t& before() const { return before_; }

 private:
  int beside_;
  sigset_t blocked_ = {}, before_ = {};
  std::atomic<int> signal_{0};
  std::atomic<std::chrono::steady_clock::time_point> next_look_{};
};

}  // namespace mbgen
