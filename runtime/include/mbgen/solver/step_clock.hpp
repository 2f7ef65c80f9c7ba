#pragma once
// Time spent in each of the nine steps of the paper's tables 1 and 2.

// The builtin, not the header of the intrinsics: reading that took half the time of compiling a small solver.
#if !defined(__x86_64__)
#include <chrono>
#endif

namespace mbgen {

constexpr int kSteps = 9;

/// Ticks of the fastest steady counter there is; only ratios of ticks have a meaning.
inline long long ticks_now() noexcept {
#if defined(__x86_64__)
  return static_cast<long long>(__builtin_ia32_rdtsc());
#else
  return std::chrono::steady_clock::now().time_since_epoch().count();
#endif
}

/// Accumulates ticks by step: start(), then at_end_of(step) after each of them. Steps count from 1.
struct StepClock {
  long long ticks[kSteps] = {};
  long long since = 0;
  void start() noexcept { since = ticks_now(); }
  void at_end_of(int step) noexcept {
    const long long now = ticks_now();
    ticks[step - 1] += now - since;
    since = now;
  }
};

}  // namespace mbgen
