// Whole steps of a generated solver: evaluations, sums and projection, without outputs. Made and run by steps.sh:
//   steps STATE STEPS TURNS rk4|abm4     STATE: a file with all z, then all zd
// Prints the least and the median time of a step over the turns, s. With LANES: of one instance of a batch, whose lanes
// all start there.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include INTERFACE

namespace {

constexpr double kStep = 1e-3;  // s

#ifdef LANES
namespace solver = SOLVER::batch;
constexpr int kInstances = solver::kLanes;

solver::State in_every_lane(const SOLVER::State& start) {
  solver::State all{};
  for (int lane = 0; lane < kInstances; ++lane) set_lane(all, lane, start);
  return all;
}

bool is_ok(const solver::Statuses& statuses) {
  bool result = true;
  for (int lane = 0; lane < kInstances; ++lane) result = result && statuses[lane].ok();
  return result;
}
#else
namespace solver = SOLVER;
constexpr int kInstances = 1;

const SOLVER::State& in_every_lane(const SOLVER::State& start) { return start; }

bool is_ok(const mbgen::Status& status) { return status.ok(); }
#endif

bool read_state(const char* path, SOLVER::State& state) {
  std::ifstream file(path);
  for (double& value : state.z) file >> value;
  for (double& value : state.zd) file >> value;
  return !file.fail();
}

/// Seconds per step of an instance; -1 when a step fails.
double run(const SOLVER::State& start, int steps, bool is_multistep) {
  const solver::Parameters parameters{};
  const solver::Inputs inputs{};
  solver::State state = in_every_lane(start);
  solver::History history{};
  const auto before = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) {
    const auto status = is_multistep ? step_abm4(parameters, inputs, state, history, kStep)
                                     : step_rk4(parameters, inputs, state, kStep);
    if (!is_ok(status)) return -1;
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count() / steps / kInstances;
}

}  // namespace

int main(int count, char** words) {
  SOLVER::State start{};
  if (count != 5 || !read_state(words[1], start)) return 1;
  if (!SOLVER::assemble(SOLVER::Parameters{}, SOLVER::Inputs{}, start).ok()) return 1;
  std::vector<double> seconds;
  for (int turn = 0; turn < std::atoi(words[3]); ++turn) {
    seconds.push_back(run(start, std::atoi(words[2]), std::string(words[4]) == "abm4"));
    if (seconds.back() < 0) return 1;
  }
  std::sort(seconds.begin(), seconds.end());
  std::printf("%.9g %.9g\n", seconds.front(), seconds[seconds.size() / 2]);
}
