// Every function of an emitted solver and of its batches in four threads at once; see emitted.sh.

#include INTERFACE

#include <cstdio>
#include <cstring>
#include <thread>

namespace {

using namespace SOLVER;

constexpr int kThreads = 4, kSteps = 50;
constexpr double kStep = 1e-3;

struct Results {
  State state{};
  Derivative derivative{};
  Outputs values{};
  Multipliers forces{};
  batch::State states{};
  batch::Derivative derivatives{};
};

void work(Results& r) {
  for (int i = 0; i < kCoordinates; ++i) {
    r.state.zd[i] = 0.1;
    for (int lane = 0; lane < batch::kLanes; ++lane) r.states.zd[i][lane] = 0.1 + 0.1 * lane;
  }
  const double tau[kCoordinates] = {};
  const batch::JointForces taus{};
  History history{};
  batch::History histories{};
  assemble({}, {}, r.state);
  assemble({}, {}, r.states);
  for (int step = 0; step < kSteps; ++step) {
    step_rk4({}, {}, r.state, kStep);
    step_abm4({}, {}, r.state, history, kStep);
    step_rk4({}, {}, r.states, kStep);
    step_abm4({}, {}, r.states, histories, kStep);
  }
  accelerations({}, {}, r.state, tau, r.derivative);
  outputs({}, {}, r.state, tau, r.derivative, r.values);
  multipliers({}, {}, r.state, tau, r.derivative, r.forces);
  accelerations({}, {}, r.states, taus, r.derivatives);
}

}  // namespace

int main() {
  static Results alone, results[kThreads];
  work(alone);
  std::thread threads[kThreads];
  for (int k = 0; k < kThreads; ++k) threads[k] = std::thread([k] { work(results[k]); });
  for (std::thread& thread : threads) thread.join();
  for (const Results& one : results) {
    if (std::memcmp(&one, &alone, sizeof one) == 0) continue;
    std::puts("a thread has other bits");
    return 1;
  }
  return 0;
}
