#pragma once
// The real-time loop, and what other threads see of it.

#include <atomic>

#include "histogram.hpp"
#include "link.hpp"
#include "mbgen/exchange.hpp"
#include "plant.hpp"
#include "ring.hpp"
#include "udp.hpp"

namespace hil_rig {

/// Message of the loop about itself, made into words by its reader.
struct Event {
  enum class Kind { phase, parameters, overrun, session, failed } kind = Kind::phase;
  long cycle = 0;
  long value = 0;  ///< phase: Phase; overrun: periods missed; session: its number; failed: mbgen::Code
};

/// Sums over the run.
struct Tally {
  long cycles = 0;
  long overruns = 0;  ///< cycles that ended after the next one should have begun
  long missed = 0;    ///< periods that had no cycle: the model is so many steps behind the clock
  long unsent = 0;    ///< motions that the network did not take
  long unsaid = 0;    ///< events that found no room
  Histogram wakeup;   ///< from the time to wake up until awake
  Histogram work;     ///< from awake until the motion is sent
  Link link;
  mbgen::Status status;  ///< of the last step
};

/// The state of the loop for those who watch, small enough to be copied in every cycle.
struct Glance {
  long cycles = 0, overruns = 0, missed = 0;
  std::int64_t wakeup_mean = 0, wakeup_largest = 0, work_mean = 0, work_largest = 0;  ///< us
  Phase phase = Phase::silent;
  Counts counts;
  Motion motion;
};

/// All that the loop shares with other threads; neither side waits for the other.
struct Shared {
  std::atomic<bool> stop{false};                      ///< set by others: end after this cycle
  std::atomic<bool> done{false};                      ///< set by the loop
  mbgen::Exchange<coach_rig::Parameters> parameters;  ///< to the loop, taken between two steps
  mbgen::Exchange<Glance> glance;                     ///< from the loop
  Ring<Event, 256> events;                            ///< from the loop
};

struct LoopSettings {
  long cycles = 0;  ///< 0: until stopped
  Policy policy;
  sockaddr_in peer{};         ///< who gets the motion
  std::uint32_t session = 0;  ///< of the packets sent
};

/// Runs a plant that was started, a step every millisecond, until it is stopped, has done its cycles or fails.
/// Allocates nothing and waits for nothing but the clock. A cycle that ends too late is counted, the periods it missed
/// are left out: the next begins at a whole period again.
void run_loop(const LoopSettings& settings, const Socket& socket, Plant& plant, Shared& shared, Tally& tally) noexcept;

}  // namespace hil_rig
