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

constexpr const char* kOtherCoordinates = "a loop has, or needs, other independent coordinates than at the start";

/// A reason is set only with its refusal: beside an ok it would be told as a remark.
template <class Model>
Answer without_derivatives(Core<Model>& core, const char* reason) noexcept {
  core.refusal.reason = reason;
  return Answer::discard;
}

/// Completes a direction of independent coordinates, auxiliary states, time, inputs and parameters: the loops stay
/// closed, and accelerations and multipliers follow. The Newton step of the closure has the derivative of the closed
/// positions: at the solution it does not depend on the dependent positions.
/// Answer: discard where a loop block needs another partition.
template <class Model>
Answer complete(Core<Model>& core, typename Model::Direction& direction, typename Model::AccelerationsAlong& rates,
                typename Model::OutputsAlong& outputs) noexcept {
  const Run<Model>& run = core.run;
  if constexpr (Model::kHasClosure) {
    typename Model::ClosureAlong closure;
    Model::closure_along(run.parameters, run.inputs, core.solved, direction, closure);
    if (!is_frozen<Model>(closure)) return without_derivatives(core, kOtherCoordinates);
    for (int i = 0; i < Model::kCoordinates; ++i) direction.z[i] += closure.dz[i];
    Model::closure_along(run.parameters, run.inputs, core.solved, direction, closure);
    for (int i = 0; i < Model::kCoordinates; ++i) direction.zd[i] = closure.zd[i];
  }
  Model::accelerations_along(run.parameters, run.inputs, core.solved, direction, rates);
  if (!is_frozen<Model>(rates)) return without_derivatives(core, kOtherCoordinates);
  for (int i = 0; i < Model::kCoordinates; ++i) direction.zdd[i] = rates.zdd[i];
  typename Model::Multipliers multipliers{};
  if constexpr (Model::kOutputsTakeMultipliers) {
    core.status = Model::multipliers(run.parameters, run.inputs, core.solved, core.derivative, multipliers);
    if (!core.status.ok()) return Answer::discard;
    typename Model::MultipliersAlong forces;
    Model::multipliers_along(run.parameters, run.inputs, core.solved, core.derivative, direction, forces);
    for (int i = 0; i < Model::kMultipliers; ++i) direction.lambda[i] = forces.lambda[i];
    for (int i = 0; i < Model::kDrives; ++i) direction.drive[i] = forces.drive[i];
  }
  Model::outputs_along(run.parameters, run.inputs, core.solved, core.derivative, multipliers, direction, outputs);
  return Answer::ok;
}

/// Adds a known's rate to a direction. Dependent positions have no effect: they are guesses of the closed ones. Result:
/// whether it is a known.
template <class Model>
bool add_known(const Run<Model>& run, Place place, double rate, typename Model::Direction& direction) noexcept {
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
      return is_undriven<Model>(place.index);
    case Group::zd:
      direction.zd[place.index] += rate;
      return is_independent<Model>(place.index);
    case Group::x:
      direction.x[place.index] += rate;
      return true;
    case Group::q:
      direction.z[chosen_coordinate(run, place.index)] += rate;
      return true;
    case Group::qd:
      direction.zd[chosen_coordinate(run, place.index)] += rate;
      return true;
    case Group::start:
      for (int i = 0; i < Model::kCoordinates; ++i) {
        if (is_independent<Model>(i))
          direction.zd[i] += rate * Model::kStartRate[place.index * Model::kCoordinates + i];
      }
      return run.mode == kInitialization;
    default:
      return false;
  }
}

constexpr bool is_unknown(Group group) noexcept {
  return group == Group::output || group == Group::z || group == Group::zd || group == Group::zdd ||
         group == Group::xd || group == Group::q || group == Group::qd || group == Group::qdd;
}

/// Rate of an unknown along a completed direction.
template <class Model>
double rate_of(const Run<Model>& run, Place place, const typename Model::Direction& direction,
               const typename Model::AccelerationsAlong& rates, const typename Model::OutputsAlong& outputs) noexcept {
  switch (place.group) {
    case Group::output:
      return outputs.y[place.index];
    case Group::z:
      return direction.z[place.index];
    case Group::zd:
      return direction.zd[place.index];
    case Group::zdd:
      return rates.zdd[place.index];
    case Group::q:
      return direction.z[chosen_coordinate(run, place.index)];
    case Group::qd:
      return direction.zd[chosen_coordinate(run, place.index)];
    case Group::qdd:
      return rates.zdd[chosen_coordinate(run, place.index)];
    default:
      return rates.xd[place.index];
  }
}

/// Whether the unknowns have derivatives at this state, which is solved then. Answer: error for one that is none;
/// discard where a loop block has, or needs, other independent coordinates than the frozen ones, and near poles.
template <class Model>
Answer prepare_derivatives(Core<Model>& core, const unsigned* unknowns, unsigned long count) noexcept {
  if constexpr (kCoSimulationAlone<Model>) {
    core.refusal.reason = "there are no directional derivatives: bodies roll, and positions are no states";
    return Answer::error;
  }
  for (unsigned long i = 0; i < count; ++i) {
    if (!is_unknown(place_of<Model>(unknowns[i]).group))
      return refuse(core, Refusal::of_variable(unknowns[i], "is no unknown: it has no derivative by others"));
  }
  if (!is_frozen_choice(core.run.choice)) return without_derivatives(core, kOtherCoordinates);
  if (!solve(core)) return Answer::discard;
  if (!in_other_chart(core.solved)) return Answer::ok;
  return without_derivatives(core, "a ball joint is near the pole of its angles: no derivative by them there");
}

/// Adds the rates of knowns to a direction. Answer: error for a known that is none, or a rate that is not finite.
template <class Model>
Answer add_knowns(Core<Model>& core, const unsigned* knowns, unsigned long count, const double* rates,
                  typename Model::Direction& direction) noexcept {
  for (unsigned long i = 0; i < count; ++i) {
    if (!std::isfinite(rates[i])) return refuse(core, Refusal::of_variable(knowns[i], "must have a finite rate"));
    if (!add_known(core.run, place_of<Model>(knowns[i]), rates[i], direction))
      return refuse(core, Refusal::of_variable(knowns[i], "is no known here: nothing is differentiated by it"));
  }
  return Answer::ok;
}

/// Sum over the knowns of d(unknown)/d(known) times its rate. Answer: as prepare_derivatives, add_knowns, complete.
template <class Model>
Answer directional_derivative(Core<Model>& core, const unsigned* unknowns, unsigned long unknown_count,
                              const unsigned* knowns, unsigned long known_count, const double* rates_of_knowns,
                              double* rates_of_unknowns) noexcept {
  typename Model::Direction direction{};
  if constexpr (!kCoSimulationAlone<Model>) {
    const Answer known = add_knowns(core, knowns, known_count, rates_of_knowns, direction);
    if (known != Answer::ok) return known;
  }
  const Answer prepared = prepare_derivatives(core, unknowns, unknown_count);
  if (prepared != Answer::ok) return prepared;
  typename Model::AccelerationsAlong rates;
  typename Model::OutputsAlong outputs;
  const Answer answer = complete(core, direction, rates, outputs);
  if (answer != Answer::ok) return answer;
  for (unsigned long i = 0; i < unknown_count; ++i) {
    rates_of_unknowns[i] = rate_of(core.run, place_of<Model>(unknowns[i]), direction, rates, outputs);
  }
  return Answer::ok;
}

/// Sum over the unknowns of d(unknown)/d(known) times its weight: a directional derivative for each known. Answer: as
/// directional_derivative; the sums are then unfinished.
template <class Model>
Answer adjoint_derivative(Core<Model>& core, const unsigned* unknowns, unsigned long unknown_count,
                          const unsigned* knowns, unsigned long known_count, const double* weights_of_unknowns,
                          double* weights_of_knowns) noexcept {
  const Answer prepared = prepare_derivatives(core, unknowns, unknown_count);
  if (prepared != Answer::ok) return prepared;
  for (unsigned long i = 0; i < unknown_count; ++i) {
    if (!std::isfinite(weights_of_unknowns[i]))
      return refuse(core, Refusal::of_variable(unknowns[i], "must have a finite weight"));
  }
  constexpr double kAlone = 1;
  for (unsigned long k = 0; k < known_count; ++k) {
    typename Model::Direction direction{};
    typename Model::AccelerationsAlong rates;
    typename Model::OutputsAlong outputs;
    Answer answer = add_knowns(core, knowns + k, 1, &kAlone, direction);
    if (answer == Answer::ok) answer = complete(core, direction, rates, outputs);
    if (answer != Answer::ok) return answer;
    double sum = 0;
    for (unsigned long i = 0; i < unknown_count; ++i)
      sum += weights_of_unknowns[i] * rate_of(core.run, place_of<Model>(unknowns[i]), direction, rates, outputs);
    weights_of_knowns[k] = sum;
  }
  return Answer::ok;
}

}  // namespace mbgen::fmu
