#pragma once
// Instants of sampled values in an FMU. Inner steps of co-simulation are cut there, and the step that begins at an
// instant sets the values; in model exchange they are time events. Models without such values have none of it.

#include "mbgen/fmu/fmu_way.hpp"
#include "mbgen/sampling.hpp"

namespace mbgen::fmu {

/// Seconds up to the next instant of sampled values, which the step that begins there sets; `left` where that is later.
template <class Model>
double until_instant([[maybe_unused]] double t, double left) noexcept {
  if constexpr (kHeld<Model> != 0) {
    const double width = Model::next_instant(t) - t;
    if (width + same_instant(t + left) < left) return width;
  }
  return left;
}

/// End of a step from `begin` with a rounded size: the next instant if it would be beyond.
template <class Model>
double not_beyond_instant([[maybe_unused]] double begin, double t) noexcept {
  if constexpr (kHeld<Model> != 0) {
    const double instant = Model::next_instant(begin);
    if (t - same_instant(t) > instant) return instant;
  }
  return t;
}

/// Whether the next event is at this time.
template <class Model>
bool is_at_event(const Run<Model>& run) noexcept {
  return run.state.t + same_instant(run.state.t) >= run.next_event;
}

/// Answer: error where the importer has gone beyond the next event.
template <class Model>
Answer check_event(Core<Model>& core) noexcept {
  const double t = core.run.state.t, event = core.run.next_event;
  if (t - same_instant(t) > event)
    return refuse(core, Refusal::of_limit("the time must not go beyond the next event, at", event, t));
  return Answer::ok;
}

/// Sets the sampled values whose instant is now, once. Result: whether it went well. Requires: closed.
template <class Model>
bool take_samples([[maybe_unused]] Core<Model>& core) noexcept {
  if constexpr (kHeld<Model> != 0) {
    Run<Model>& run = core.run;
    if (!is_at_event(run)) return true;
    core.status = Model::sample(run.parameters, run.inputs, run.state);
    core.is_solved = false;
    if (!core.status.ok()) return false;
    run.next_event = Model::next_instant(run.state.t);
  }
  return true;
}

}  // namespace mbgen::fmu
