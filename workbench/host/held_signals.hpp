#pragma once
// Signals that would end this process, held back while it does what it would have to tidy up.

#include <atomic>
#include <chrono>
#include <csignal>

namespace mbgen {

/// Holds SIGINT, SIGTERM and SIGHUP back in its thread and in threads that this thread starts, for its lifetime, except
/// signals that are already ignored, handled or held back. A signal that came and was not taken acts at the end.
class HeldSignals {
 public:
  /// beside: another signal to hold back, for `wait`.
  explicit HeldSignals(int beside = 0);
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  /// Waits for a signal that is held back. Result: the one that is to end this process; 0 for `beside`, or without one.
  int wait(std::chrono::nanoseconds longest) const;
  /// The signal that was to end this process, 0 without one; looks a few times a second. For any thread.
  int taken();
  /// The signals that were held back before.
  const sigset_t& before() const { return before_; }

 private:
  int beside_;
  sigset_t held_ = {}, before_ = {};
  std::atomic<int> signal_{0};
  std::atomic<std::chrono::steady_clock::time_point> next_look_{};
};

}  // namespace mbgen
