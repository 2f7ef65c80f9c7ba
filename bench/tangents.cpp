// Steps of a solver with derivatives, and steps backwards, beside plain ones, in turns in one process. Made and run by
// tangents.sh:
//   tangents STATE STEPS TURNS     STATE: a file with all z, then all zd
// Prints the least processor time of a plain step, of one with derivatives by the first eight parameters and of one
// backwards, s, and the medians of the ratios of the last two to the first in one turn.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <vector>

#include ADJOINT_HEADER
#include PLAIN_HEADER
#include TANGENTS_HEADER

namespace {

constexpr double kStep = 1e-3;  // s

double now() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Seconds per step; -1 when one fails.
template <class Tuned, class Inputs, class State>
double run(const Tuned& parameters, const Inputs& inputs, State state, int steps) {
  const double before = now();
  for (int i = 0; i < steps; ++i)
    if (!step_rk4(parameters, inputs, state, kStep).ok()) return -1;
  return (now() - before) / steps;
}

/// Seconds per step backwards, from derivatives of the sum of all velocities at the end; -1 when one fails.
double run_back(const PLAIN::Tuned& parameters, const PLAIN::Inputs& inputs, const PLAIN::State& start, int steps) {
  std::vector<PLAIN::State> states = {start};
  for (int i = 0; i < steps; ++i) {
    states.push_back(states.back());
    if (!step_rk4(parameters, inputs, states.back(), kStep).ok()) return -1;
  }
  ADJOINT::Adjoints cost{};
  std::fill(std::begin(cost.zd), std::end(cost.zd), 1.0);
  const double before = now();
  for (std::size_t k = states.size() - 1; k-- > 0;)
    if (!ADJOINT::step_rk4_back(parameters, inputs, states[k], kStep, cost).ok()) return -1;
  return (now() - before) / steps;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

bool read_state(const char* path, PLAIN::State& state) {
  std::ifstream file(path);
  for (double& value : state.z) file >> value;
  for (double& value : state.zd) file >> value;
  return !file.fail() && PLAIN::assemble(PLAIN::Parameters{}, PLAIN::Inputs{}, state).ok();
}

/// The same state over numbers with derivatives, of which it has none.
TANGENTS::State with_derivatives(const PLAIN::State& plain) {
  TANGENTS::State state{};
  std::copy(std::begin(plain.z), std::end(plain.z), state.z);
  std::copy(std::begin(plain.zd), std::end(plain.zd), state.zd);
  std::copy(std::begin(plain.x), std::end(plain.x), state.x);
  state.t = plain.t;
  return state;
}

}  // namespace

int main(int count, char** words) {
  PLAIN::State plain{};
  if (count != 4 || !read_state(words[1], plain)) return 1;
  const TANGENTS::State state = with_derivatives(plain);
  TANGENTS::Parameters parameters;
  auto* number = reinterpret_cast<TANGENTS::Real*>(&parameters);
  for (int k = 0; k < std::min(TANGENTS::kParameters, TANGENTS::kDirections); ++k)
    number[k] = TANGENTS::Real::along(number[k].value, k);
  const TANGENTS::Tuned tuned(parameters);
  std::vector<double> of_plain, of_tangents, of_back, ratios, ratios_back;
  const PLAIN::Tuned numbers{PLAIN::Parameters{}};
  for (int turn = 0; turn < std::atoi(words[3]); ++turn) {
    of_plain.push_back(run(numbers, PLAIN::Inputs{}, plain, std::atoi(words[2])));
    of_tangents.push_back(run(tuned, TANGENTS::Inputs{}, state, std::atoi(words[2])));
    of_back.push_back(run_back(numbers, PLAIN::Inputs{}, plain, std::atoi(words[2])));
    if (of_plain.back() < 0 || of_tangents.back() < 0 || of_back.back() < 0) return 1;
    ratios.push_back(of_tangents.back() / of_plain.back());
    ratios_back.push_back(of_back.back() / of_plain.back());
  }
  const auto least = [](const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); };
  std::printf("%.9g %.9g %.9g %.9g %.9g\n", least(of_plain), least(of_tangents), least(of_back), median(ratios),
              median(ratios_back));
}
