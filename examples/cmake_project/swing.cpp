// A pendulum let go at 40 degrees, for two seconds: what its tip does. See docs/use/embedding.md.
#include <cstdio>

#include "pendulum.hpp"

int main() {
  constexpr double kStep = 1e-3;
  const pendulum::Parameters parameters;
  pendulum::Inputs inputs;
  inputs.torque = 0.2;
  pendulum::State state = pendulum::initial_state();
  state.z[pendulum::Coordinate::hinge] = 0.698;
  for (int i = 1; i <= 2000; ++i) {
    const mbgen::Status status = pendulum::step_rk4(parameters, inputs, state, kStep);
    if (!status.ok()) {
      std::fprintf(stderr, "step %d: %s: %s\n", i, mbgen::text(status.code), pendulum::describe(status));
      return 1;
    }
    if (i % 500 == 0) std::printf("%5.3f s  hinge %8.4f rad\n", state.t, state.z[pendulum::Coordinate::hinge]);
  }
}
