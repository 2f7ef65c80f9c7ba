// A generated solver and its lanes behind a plain interface, as a shared library: bench/beside.sh
// Macros: SOLVER (namespace), SOLVER_HEADER, BATCH_HEADER.
#include SOLVER_HEADER
#include BATCH_HEADER

#include <cstddef>

namespace {

constexpr int kStates = 16, kRestart = 256;
constexpr double kStep = 1e-3;  // s

SOLVER::Parameters parameters;
SOLVER::Inputs inputs;
SOLVER::State states[kStates], state;
SOLVER::Derivative derivative;
double tau[SOLVER::kCoordinates];
SOLVER::batch::Parameters many_parameters;
SOLVER::batch::Inputs many_inputs;
SOLVER::batch::State many_states, many;
SOLVER::batch::JointForces many_forces;
SOLVER::batch::Derivative many_derivatives;

/// From -0.5 to 0.5, the same numbers every time.
double next_random() {
  static unsigned long long seed = 88172645463325252ULL;
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return static_cast<double>(seed >> 11) / 9007199254740992.0 - 0.5;
}

}  // namespace

extern "C" {

int coordinates() { return SOLVER::kCoordinates; }
int count_of_states() { return kStates; }
/// Up to the time, which every mbgen has; what stands behind it, as charts of balls, is 0 in these states.
int doubles_of_state() { return static_cast<int>(offsetof(SOLVER::State, t) / sizeof(double)) + 1; }
double* state_at(int k) { return reinterpret_cast<double*>(&states[k]); }

/// Consistent states near the start; the start itself where the loops do not close.
void make_states() {
  for (SOLVER::State& one : states) {
    one = SOLVER::State{};
    for (double& value : one.z) value += 0.01 * next_random();
    for (double& value : one.zd) value += 0.05 * next_random();
    if (!SOLVER::assemble(parameters, inputs, one).ok()) one = SOLVER::State{};
  }
}

/// Takes over the states as they stand.
void load_states() {
  state = states[0];
  for (int lane = 0; lane < SOLVER::batch::kLanes; ++lane) SOLVER::batch::set_lane(many_states, lane, states[lane]);
  for (int lane = 0; lane < SOLVER::batch::kLanes; ++lane) SOLVER::batch::set_lane(many_parameters, lane, parameters);
  for (int lane = 0; lane < SOLVER::batch::kLanes; ++lane) SOLVER::batch::set_lane(many_inputs, lane, inputs);
  many = many_states;
}

const double* accelerations_at(int k) {
  return SOLVER::accelerations(parameters, inputs, states[k], tau, derivative).ok() ? derivative.zdd : nullptr;
}

void evaluate(int count) {
  for (int k = 0; k < count; ++k) (void)SOLVER::accelerations(parameters, inputs, states[k % kStates], tau, derivative);
}

void step(int count) {
  for (int k = 0; k < count; ++k) {
    if (k % kRestart == 0) state = states[0];
    (void)SOLVER::step_rk4(parameters, inputs, state, kStep);
  }
}

/// count, here and below: of instances; a multiple of the lanes.
void evaluate_in_lanes(int count) {
  for (int k = 0; k < count / SOLVER::batch::kLanes; ++k)
    (void)SOLVER::batch::accelerations(many_parameters, many_inputs, many_states, many_forces, many_derivatives);
}

void step_in_lanes(int count) {
  for (int k = 0; k < count / SOLVER::batch::kLanes; ++k) {
    if (k % kRestart == 0) many = many_states;
    (void)SOLVER::batch::step_rk4(many_parameters, many_inputs, many, kStep);
  }
}
}
