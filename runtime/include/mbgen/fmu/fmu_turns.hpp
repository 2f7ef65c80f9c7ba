#pragma once
// Bodies that turn farther within a step than the method's limit, for the steps of an FMU and of an importer.

#include <cmath>

#include "mbgen/fmu.hpp"
#include "mbgen/turns.hpp"

namespace mbgen::fmu {

/// Whether a rotation of a coordinate changes an acceleration of the run; it does not for an axisymmetric wheel. If it
/// opens a loop, all change.
template <class Model>
bool turn_matters(const Run<Model>& run, int coordinate) noexcept {
  typename Model::Derivative here{}, there{};
  if (!Model::derivative(run.parameters, run.inputs, run.state, here).ok()) return true;
  for (const double turn : kTriedTurns) {
    typename Model::State turned = run.state;
    turned.z[coordinate] += turn;
    if (!Model::derivative(run.parameters, run.inputs, turned, there).ok()) return true;
    if (differ_by_turn(here.zdd, there.zdd, Model::kCoordinates, run.state.zd[coordinate])) return true;
  }
  return false;
}

/// Reports a coordinate that turns too far, once, and only if forces turn with it. A turn that does not matter now is
/// tested again after twice as many turns. Result: whether it was reported.
template <class Model>
bool log_turn(Core<Model>& core, int coordinate, const char* reason, double limit, double turn) noexcept {
  const unsigned seen = ++core.turned;
  if ((seen & (seen - 1)) != 0 || !turn_matters(core.run, coordinate)) return false;
  constexpr unsigned kFirstPosition = kFirstInput<Model> + static_cast<unsigned>(Model::kInputs + Model::kOutputs);
  core.has_warned_of_turns = true;
  core.refusal = {reason, true, true, true, kFirstPosition + static_cast<unsigned>(coordinate), limit, turn};
  return true;
}

/// Answer: warning, once, if a coordinate turns farther in an inner step of `size` seconds than the method's limit, and
/// forces turn with it.
template <class Model>
Answer compare_turns(Core<Model>& core, double size) noexcept {
  for (int i = 0; i < Model::kCoordinates && !core.has_warned_of_turns; ++i) {
    const double turn = std::abs(core.run.state.zd[i]) * size;
    if (!(turn > Model::kLargestTurn) || !Model::is_rotation(i)) continue;
    if (log_turn(core, i,
                 "turns too far within a step inside, and forces turn with it; give the model a shorter step: the "
                 "method bears, in rad,",
                 Model::kLargestTurn, turn))
      return Answer::warning;
  }
  return Answer::ok;
}

/// Reports, once, a completed step with a gap between its evaluations in which a coordinate turns farther than the
/// limit of any method, or farther from one evaluation to the next, in the mean, than methods with so many bear, if
/// forces turn with it. Requires: closed.
template <class Model>
void compare_gaps(Core<Model>& core) noexcept {
  if (core.has_warned_of_turns) return;
  const Gap gap = core.evaluations.widest(core.run.state.t);
  if (gap.coordinate >= 0) {
    log_turn(core, gap.coordinate,
             "turns too far between two evaluations of a completed step, and forces turn with it; take shorter "
             "steps: methods of integration bear less than, in rad,",
             kFarTurn, gap.turn);
    return;
  }
  const bool two = core.evaluations.instants == 2;
  const Gap mean = core.evaluations.widest_in_mean(core.run.state.t, [](int i) { return Model::is_rotation(i); });
  if (mean.coordinate < 0) return;
  log_turn(core, mean.coordinate,
           "turns far from one evaluation of a completed step to the next, in the mean, and forces turn with it; "
           "take shorter steps: methods with so few bear, in rad,",
           two ? kTurnOfTwo : kTurnOfOthers, mean.turn);
}

}  // namespace mbgen::fmu
