// A trajectory to the last bit, for comparison between compilers and processors; see trajectories.sh.
//   c++ ... -DSOLVER=coach -DINTERFACE='"coach.hpp"' trajectory.cpp, with the solver's sources
// Prints the state at every 50th step of both integrators in hexadecimal, and the accelerations and outputs there.

#include INTERFACE

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <type_traits>

namespace {

using namespace SOLVER;

using Number = std::remove_all_extents_t<decltype(State::z)>;  // double or float

constexpr int kSteps = 500;
constexpr double kStep = 1e-3;

/// Every number of a struct of them.
template <class Struct>
void print(const char* what, const Struct& values) {
  constexpr std::size_t kNumbers = sizeof(Struct) / sizeof(Number);
  Number numbers[kNumbers];
  std::memcpy(numbers, &values, sizeof numbers);
  std::printf("%s", what);
  for (const Number number : numbers) std::printf(" %a", static_cast<double>(number));
  std::printf("\n");
}

/// Without its time, which is a double, and what the compiler puts before that.
void print(const char* what, const State& state) {
  print(what, state.z);
  print(what, state.zd);
  print(what, state.x);
  std::printf("t %a\n", state.t);
}

void print(const char* what, mbgen::Status status) {
  std::printf("%s: %s %s\n", what, mbgen::text(status.code), describe(status));
}

void look_at(const Parameters& parameters, const Inputs& inputs, const State& state) {
  const Number tau[kCoordinates] = {};
  Derivative derivative{};
  Outputs values{};
  Multipliers forces{};
  print("state", state);
  print("accelerations", accelerations(parameters, inputs, state, tau, derivative));
  print("derivative", derivative);
  print("outputs", outputs(parameters, inputs, state, tau, derivative, values));
  print("values", values);
  print("multipliers", multipliers(parameters, inputs, state, tau, derivative, forces));
  print("forces", forces);
}

}  // namespace

int main() {
  const Parameters parameters;
  const Inputs inputs;
  State state{};
  for (int i = 0; i < kCoordinates; ++i) state.zd[i] = static_cast<Number>(0.1 + 0.01 * (i % 7));
  print("assemble", assemble(parameters, inputs, state));
  History history{};
  for (int step = 0; step <= 2 * kSteps; ++step) {
    if (step % 50 == 0) look_at(parameters, inputs, state);
    const mbgen::Status status = step < kSteps ? step_rk4(parameters, inputs, state, kStep)
                                               : step_abm4(parameters, inputs, state, history, kStep);
    if (status.ok()) continue;
    print("step", status);
    break;
  }
}
