#pragma once
// Directional derivatives of an FMU, by the differentiated programs of <model>_directional.hpp: a direction holds the
// rates of change of everything that the programs of the solver read. See fmu.hpp.

#include "mbgen/blocks.hpp"
#include "mbgen/fmu.hpp"

namespace mbgen::fmu {

/// Whether every loop block stands well with its frozen partition, which the differentiated programs have.
template <class Model, class Along>
bool is_frozen(const Along& along) noexcept {
  for (int b = 0; b < Model::kLoopBlocks; ++b) {
    if (!(along.pivot[b] >= kPivotThreshold<double>)) return false;
  }
  return true;
}

/// Completes a direction of independent coordinates, auxiliary states, time, inputs and parameters: the loops stay
/// closed, and accelerations and multipliers follow. The Newton step of the closure has the derivative of the closed
/// positions: at the solution it does not depend on the dependent positions.
/// Answer: discard where a loop block needs another partition.
template <class Model>
Answer complete(const Core<Model>& core, typename Model::Direction& direction,
                typename Model::AccelerationsAlong& rates, typename Model::OutputsAlong& outputs) noexcept {
  const Run<Model>& run = core.run;
  if constexpr (Model::kHasClosure) {
    typename Model::ClosureAlong closure;
    Model::closure_along(run.parameters, run.inputs, core.solved, direction, closure);
    if (!is_frozen<Model>(closure)) return Answer::discard;
    for (int i = 0; i < Model::kCoordinates; ++i) direction.z[i] += closure.dz[i];
    Model::closure_along(run.parameters, run.inputs, core.solved, direction, closure);
    for (int i = 0; i < Model::kCoordinates; ++i) direction.zd[i] = closure.zd[i];
  }
  Model::accelerations_along(run.parameters, run.inputs, core.solved, direction, rates);
  if (!is_frozen<Model>(rates)) return Answer::discard;
  for (int i = 0; i < Model::kCoordinates; ++i) direction.zdd[i] = rates.zdd[i];
  typename Model::Multipliers multipliers{};
  if constexpr (Model::kOutputsTakeMultipliers) {
    if (!Model::multipliers(run.parameters, run.inputs, core.solved, core.derivative, multipliers).ok()) {
      return Answer::discard;
    }
    typename Model::MultipliersAlong forces;
    Model::multipliers_along(run.parameters, run.inputs, core.solved, core.derivative, direction, forces);
    for (int i = 0; i < Model::kMultipliers; ++i) direction.lambda[i] = forces.lambda[i];
    for (int i = 0; i < Model::kDrives; ++i) direction.drive[i] = forces.drive[i];
  }
  Model::outputs_along(run.parameters, run.inputs, core.solved, core.derivative, multipliers, direction, outputs);
  return Answer::ok;
}

/// Adds a known's rate to a direction. Dependent positions change nothing: they are guesses of the closed ones.
/// Result: whether it is a known.
template <class Model>
bool add_known(Place place, double rate, typename Model::Direction& direction) noexcept {
  switch (place.group) {
    case Group::time:
      direction.t += rate;
      return true;
    case Group::parameter:
      direction.par[place.index] += rate;
      return true;
    case Group::input:
      direction.in[place.index] += rate;
      return true;
    case Group::z:
      if (is_independent<Model>(place.index)) direction.z[place.index] += rate;
      return position_is_state<Model>(place.index);
    case Group::zd:
      direction.zd[place.index] += rate;
      return is_independent<Model>(place.index);
    case Group::x:
      direction.x[place.index] += rate;
      return true;
    default:
      return false;
  }
}

/// Sum over the knowns of d(unknown)/d(known) times its rate. Answer: error for a known or unknown that is none.
template <class Model>
Answer directional_derivative(Core<Model>& core, const unsigned* unknowns, unsigned long unknown_count,
                              const unsigned* knowns, unsigned long known_count, const double* rates_of_knowns,
                              double* rates_of_unknowns) noexcept {
  typename Model::Direction direction{};
  for (unsigned long i = 0; i < known_count; ++i) {
    if (!add_known<Model>(place_of<Model>(knowns[i]), rates_of_knowns[i], direction)) return Answer::error;
  }
  for (unsigned long i = 0; i < unknown_count; ++i) {
    const Group group = place_of<Model>(unknowns[i]).group;
    if (group != Group::output && group != Group::z && group != Group::zd && group != Group::zdd &&
        group != Group::xd) {
      return Answer::error;
    }
  }
  if (!solve(core)) return Answer::discard;
  typename Model::AccelerationsAlong rates;
  typename Model::OutputsAlong outputs;
  const Answer answer = complete(core, direction, rates, outputs);
  if (answer != Answer::ok) return answer;
  for (unsigned long i = 0; i < unknown_count; ++i) {
    const Place place = place_of<Model>(unknowns[i]);
    rates_of_unknowns[i] = place.group == Group::output ? outputs.y[place.index]
                           : place.group == Group::z    ? direction.z[place.index]
                           : place.group == Group::zd   ? direction.zd[place.index]
                           : place.group == Group::zdd  ? rates.zdd[place.index]
                                                        : rates.xd[place.index];
  }
  return Answer::ok;
}

}  // namespace mbgen::fmu
