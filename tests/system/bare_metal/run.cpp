// A trajectory on any machine that can put characters somewhere; see check.sh.
//   c++ ... -DSOLVER=four_bar -DINTERFACE='"four_bar.hpp"' run.cpp, with a machine's put() and the solver
// Prints the bits of the state after kSteps steps of Runge-Kutta and as many of Adams, and of the outputs there.

#include INTERFACE

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "machine.hpp"

namespace {

using namespace SOLVER;
using Real = std::remove_all_extents_t<decltype(State::z)>;

constexpr int kSteps = 250;
constexpr double kStep = 1e-3;

void put_hexadecimal(std::uint64_t bits, int digits) noexcept {
  char text[17];
  for (int i = 0; i < digits; ++i) text[i] = "0123456789abcdef"[(bits >> (4 * (digits - 1 - i))) & 15];
  text[digits] = 0;
  put(text);
}

void put_number(float number) noexcept { put_hexadecimal(__builtin_bit_cast(std::uint32_t, number), 8); }
void put_number(double number) noexcept { put_hexadecimal(__builtin_bit_cast(std::uint64_t, number), 16); }

template <class Number>
void put_numbers(const char* what, const Number* numbers, std::size_t count) noexcept {
  put(what);
  for (std::size_t i = 0; i < count; ++i) {
    put(" ");
    put_number(numbers[i]);
  }
  put("\n");
}

void put_status(const char* what, mbgen::Status status) noexcept {
  put(what);
  put(" ");
  put(mbgen::text(status.code));
  put("\n");
}

// Data that a task on the target keeps off its stack.
State state{};
History history{};
Derivative derivative{};
Outputs values{};
constexpr Real kNoForces[kCoordinates] = {};

}  // namespace

void run() noexcept {
  const Parameters parameters;
  const Inputs inputs;
  for (int i = 0; i < kCoordinates; ++i) state.zd[i] = static_cast<Real>(i % 7) * Real(0.015625);
  put_status("assemble", assemble(parameters, inputs, state));
  mbgen::Status status;
  for (int step = 0; step < 2 * kSteps && status.ok(); ++step) {
    status = step < kSteps ? step_rk4(parameters, inputs, state, kStep)
                           : step_abm4(parameters, inputs, state, history, kStep);
  }
  put_status("steps", status);
  put_status("accelerations", accelerations(parameters, inputs, state, kNoForces, derivative));
  put_status("outputs", outputs(parameters, inputs, state, kNoForces, derivative, values));
  put_numbers("z", state.z, kCoordinates);
  put_numbers("zd", state.zd, kCoordinates);
  put_numbers("x", state.x, kAuxiliaryStates);
  put_numbers("t", &state.t, 1);
  put_numbers("zdd", derivative.zdd, kCoordinates);
  put_numbers("outputs", reinterpret_cast<const Real*>(&values), sizeof values / sizeof(Real));
}
