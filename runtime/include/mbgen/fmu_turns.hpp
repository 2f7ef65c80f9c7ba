#pragma once
// Bodies that turn farther within a step inside an FMU than its method bears.

#include <cmath>

#include "mbgen/fmu.hpp"

namespace mbgen::fmu {

/// Whether a turn about a coordinate changes an acceleration of the run: not that of a wheel that is symmetric about
/// its axis. A loop that it opens changes all of them.
template <class Model>
bool turn_matters(const Run<Model>& run, int coordinate) noexcept {
  constexpr double kTried[] = {0.7, 1.9, 3.3};  // rad
  constexpr double kMatters = 1e-4, kRounding = 1e-9;
  typename Model::Derivative here{}, there{};
  if (!Model::derivative(run.parameters, run.inputs, run.state, here).ok()) return true;
  double largest = 0;
  for (int i = 0; i < Model::kCoordinates; ++i) largest = std::fmax(largest, std::abs(here.zdd[i]));
  const double rate = run.state.zd[coordinate], rounding = kRounding * (rate * rate + largest);
  for (const double turn : kTried) {
    typename Model::State turned = run.state;
    turned.z[coordinate] += turn;
    if (!Model::derivative(run.parameters, run.inputs, turned, there).ok()) return true;
    for (int i = 0; i < Model::kCoordinates; ++i) {
      const double size = std::fmax(std::abs(here.zdd[i]), std::abs(there.zdd[i]));
      if (std::abs(here.zdd[i] - there.zdd[i]) > kMatters * size + rounding) return true;
    }
  }
  return false;
}

/// Answer: warning, once, where a coordinate turns farther in a step of `size` seconds inside than the method bears,
/// and forces turn with it. What does not matter now is looked at again after twice as many steps.
template <class Model>
Answer compare_turns(Core<Model>& core, double size) noexcept {
  for (int i = 0; i < Model::kCoordinates && !core.has_warned_of_turns; ++i) {
    const double turn = std::abs(core.run.state.zd[i]) * size;
    if (!(turn > Model::kLargestTurn) || !Model::is_rotation(i)) continue;
    const unsigned seen = ++core.turned;
    if ((seen & (seen - 1)) != 0 || !turn_matters(core.run, i)) continue;
    core.has_warned_of_turns = true;
    constexpr unsigned kFirstPosition = kFirstInput<Model> + static_cast<unsigned>(Model::kInputs + Model::kOutputs);
    core.refusal = {
        "turns too far within a step inside, and forces turn with it; give the model a shorter step: the "
        "method bears, in rad,",
        true,
        true,
        true,
        kFirstPosition + static_cast<unsigned>(i),
        Model::kLargestTurn,
        turn};
    return Answer::warning;
  }
  return Answer::ok;
}

}  // namespace mbgen::fmu
