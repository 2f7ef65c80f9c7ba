// The run of check.c by the solver itself, printed alike.

#include <cstdio>

#include "four_bar.hpp"

int main() {
  four_bar::State state = four_bar::initial_state();
  four_bar::Parameters parameters;
  four_bar::Inputs inputs;
  if (!four_bar::assemble(parameters, inputs, state).ok()) return 1;
  for (int i = 0; i < 1000; ++i) {
    if (i == 500) parameters.k = 1500, inputs.torque = 2;
    if (!four_bar::step_rk4(parameters, inputs, state, 1e-3).ok()) return 1;
  }
  const decltype(four_bar::State::z) tau = {};
  four_bar::Derivative derivative;
  four_bar::Outputs outputs;
  if (!four_bar::accelerations(parameters, inputs, state, tau, derivative).ok()) return 1;
  if (!four_bar::outputs(parameters, inputs, state, tau, derivative, outputs).ok()) return 1;
  for (int i = 0; i < four_bar::kCoordinates; ++i) std::printf("%a %a\n", double{state.z[i]}, double{state.zd[i]});
  std::printf("%a %a %a\n", state.t, double{outputs.spring_force}, double{outputs.kinetic_energy});
}
