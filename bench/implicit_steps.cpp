// Steps of Runge-Kutta and implicit steps of one generated solver in turns, one instance and lanes. Made and run by
// implicit_steps.sh:
//   implicit_steps STATE STEPS TURNS     STATE: a file with all z, then all zd; STEPS of 0.1 ms in each turn
// Prints for one instance and for lanes: least times of a step of both, s, and the median of the ratios in a turn.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <vector>

#include BATCH_INTERFACE

namespace {

constexpr double kStep = 1e-4;  // s, which Runge-Kutta bears

/// Seconds of processor time a step that `step(state)` takes; -1 when one fails.
template <class State, class Step>
double time_of(State state, int steps, const Step& step) {
  const std::clock_t before = std::clock();
  for (int i = 0; i < steps; ++i)
    if (!step(state)) return -1;
  return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / steps;
}

/// Whether every turn went well.
template <class State, class Explicit, class Implicit>
bool compare(const State& start, int steps, int turns, int lanes, const Explicit& by_rk4, const Implicit& implicit) {
  std::vector<double> rk4, rosenbrock, ratio;
  for (int turn = 0; turn < turns; ++turn) {
    rk4.push_back(time_of(start, steps, by_rk4) / lanes);
    rosenbrock.push_back(time_of(start, steps, implicit) / lanes);
    if (rk4.back() < 0 || rosenbrock.back() < 0) return false;
    ratio.push_back(rosenbrock.back() / rk4.back());
  }
  for (std::vector<double>* values : {&rk4, &rosenbrock, &ratio}) std::sort(values->begin(), values->end());
  std::printf("%d %.9g %.9g %.3f\n", lanes, rk4.front(), rosenbrock.front(), ratio[ratio.size() / 2]);
  return true;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  SOLVER::State start{};
  std::ifstream file(words[1]);
  for (double& value : start.z) file >> value;
  for (double& value : start.zd) file >> value;
  const SOLVER::Parameters parameters{};
  const SOLVER::Inputs inputs{};
  if (!file || !assemble(parameters, inputs, start).ok()) return 1;
  const int steps = std::atoi(words[2]), turns = std::atoi(words[3]);
  const bool one = compare(
      start, steps, turns, 1, [&](SOLVER::State& s) { return step_rk4(parameters, inputs, s, kStep).ok(); },
      [&](SOLVER::State& s) { return step_rosenbrock(parameters, inputs, s, kStep).ok(); });

  namespace batch = SOLVER::batch;
  const batch::Parameters batch_parameters{};
  const batch::Inputs batch_inputs{};
  batch::State lanes = batch::initial_state();
  for (int lane = 0; lane < batch::kLanes; ++lane) set_lane(lanes, lane, start);
  const auto all_ok = [](const batch::Statuses& statuses) {
    bool ok = true;
    for (int lane = 0; lane < batch::kLanes; ++lane) ok = ok && statuses[lane].ok();
    return ok;
  };
  const bool many = compare(
      lanes, steps, turns, batch::kLanes,
      [&](batch::State& s) { return all_ok(step_rk4(batch_parameters, batch_inputs, s, kStep)); },
      [&](batch::State& s) { return all_ok(step_rosenbrock(batch_parameters, batch_inputs, s, kStep)); });
  return one && many ? 0 : 1;
}
