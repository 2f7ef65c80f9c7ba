// Steps of a solver with derivatives beside the plain one's, in turns in one process. Made and run by tangents.sh:
//   tangents STATE STEPS TURNS     STATE: a file with all z, then all zd
// Prints the least processor time of a plain step and of one with derivatives by the first eight parameters, s, and the
// median of their ratios in one turn.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <vector>

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
  std::vector<double> of_plain, of_tangents, ratios;
  for (int turn = 0; turn < std::atoi(words[3]); ++turn) {
    of_plain.push_back(run(PLAIN::Tuned(PLAIN::Parameters{}), PLAIN::Inputs{}, plain, std::atoi(words[2])));
    of_tangents.push_back(run(tuned, TANGENTS::Inputs{}, state, std::atoi(words[2])));
    if (of_plain.back() < 0 || of_tangents.back() < 0) return 1;
    ratios.push_back(of_tangents.back() / of_plain.back());
  }
  std::sort(ratios.begin(), ratios.end());
  std::printf("%.9g %.9g %.9g\n", *std::min_element(of_plain.begin(), of_plain.end()),
              *std::min_element(of_tangents.begin(), of_tangents.end()), ratios[ratios.size() / 2]);
}
