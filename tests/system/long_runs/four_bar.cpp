// The conservative four-bar for many steps: energy, closures and memory at every power of ten.
//   four_bar STEPS H rk4|abm4
// Exit code 1 when a step fails.

#include "four_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

/// Memory of this process that is resident, kB.
long resident() {
  long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%*d %ld", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return 4 * pages;
}

struct Energy {
  double kinetic, whole;  ///< J
};

Energy energy_of(const four_bar::Parameters& parameters, const four_bar::State& state) {
  const double tau[four_bar::kCoordinates] = {};
  four_bar::Derivative derivative{};
  four_bar::Outputs outputs{};
  if (!accelerations(parameters, {}, state, tau, derivative).ok()) std::exit(1);
  if (!four_bar::outputs(parameters, {}, state, tau, derivative, outputs).ok()) std::exit(1);
  return {outputs.kinetic_energy, outputs.kinetic_energy + outputs.potential_energy};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const long steps = std::atol(arguments[1]);
  const double h = std::atof(arguments[2]);
  const bool adams = std::string(arguments[3]) == "abm4";
  // The energy of a spring is not among the outputs, so there is none.
  four_bar::Parameters parameters;
  parameters.k = 0;
  four_bar::State state{};
  state.zd[four_bar::Coordinate::crank_pin] = 3;
  four_bar::History history{};
  if (!assemble(parameters, {}, state).ok()) return 1;
  const Energy start = energy_of(parameters, state);
  double lowest = start.kinetic, highest = start.kinetic, drift = 0, position = 0, velocity = 0;
  std::printf("%s, h = %g s\n%11s %10s %22s %22s %14s %14s %9s\n", arguments[3], h, "steps", "t, s",
              "energy change/exchanged", "largest so far", "residual, m", "m/s", "RSS, kB");
  long next = 1000000;
  for (long step = 1; step <= steps; ++step) {
    const mbgen::Status status =
        adams ? step_abm4(parameters, {}, state, history, h) : step_rk4(parameters, {}, state, h);
    if (!status.ok()) {
      std::printf("step %ld: %s %s\n", step, mbgen::text(status.code), four_bar::describe(status));
      return 1;
    }
    if (step % 1000 != 0) continue;
    const Energy now = energy_of(parameters, state);
    lowest = std::min(lowest, now.kinetic);
    highest = std::max(highest, now.kinetic);
    drift = std::max(drift, std::abs(now.whole - start.whole));
    four_bar::ClosureResidual residual{};
    if (!closure_residual(parameters, {}, state, residual).ok()) return 1;
    position = std::max(position, residual.largest_position);
    velocity = std::max(velocity, residual.largest_velocity);
    if (step != next && step != steps) continue;
    const double exchanged = highest - lowest;
    std::printf("%11ld %10.0f %22.3e %22.3e %14.2e %14.2e %9ld\n", step, state.t, (now.whole - start.whole) / exchanged,
                drift / exchanged, position, velocity, resident());
    std::fflush(stdout);
    next *= 10;
  }
  return 0;
}
