#pragma once
// Settings by which a thread keeps a period on PREEMPT_RT; each that is not permitted is left out.

#include <cstdint>
#include <cstdio>

namespace hil_rig {

struct Realtime {
  int priority = 80;  ///< of SCHED_FIFO, 1 to 98; 0: leave the scheduler as it is
  int cpu = -1;       ///< the processor to stay on; -1: any
};

/// Makes the calling thread real-time: memory locked, stack touched, pinned, SCHED_FIFO. Each step that is refused is
/// said in a line to `messages`, with what would permit it, and left out.
void enter_realtime(const Realtime& realtime, std::FILE* messages);

/// Asks the kernel to keep the processors out of deep sleep while the result is open. Result: a descriptor, -1 with a
/// line to `messages` when it is refused.
int keep_awake(std::FILE* messages);

/// ns of the monotonic clock.
std::int64_t monotonic_now() noexcept;

/// Sleeps until a time of the monotonic clock, ns.
void sleep_until(std::int64_t time) noexcept;

}  // namespace hil_rig
