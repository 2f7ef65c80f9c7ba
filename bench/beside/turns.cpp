// Two solvers of one model in turns, after their answers agree: turns THIS.so OTHER.so TURNS. bench/beside.sh
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>

namespace {

constexpr int kFigures = 4;
constexpr double kAgreement = 1e-9;  ///< of the largest acceleration

struct Solver {
  int (*coordinates)();
  int (*count_of_states)();
  int (*doubles_of_state)();
  double* (*state_at)(int);
  void (*make_states)();
  void (*load_states)();
  const double* (*accelerations_at)(int);
  void (*figures[kFigures])(int);
};

Solver loaded(const char* path) {
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    std::exit(1);
  }
  const auto find = [library](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
  };
  Solver solver;
  find(solver.coordinates, "coordinates");
  find(solver.count_of_states, "count_of_states");
  find(solver.doubles_of_state, "doubles_of_state");
  find(solver.state_at, "state_at");
  find(solver.make_states, "make_states");
  find(solver.load_states, "load_states");
  find(solver.accelerations_at, "accelerations_at");
  find(solver.figures[0], "evaluate");
  find(solver.figures[1], "step");
  find(solver.figures[2], "evaluate_in_lanes");
  find(solver.figures[3], "step_in_lanes");
  return solver;
}

/// Largest difference of an acceleration, relative to the largest one; infinite where a state is refused.
double deviation(const Solver& one, const Solver& other) {
  double worst = 0;
  for (int k = 0; k < one.count_of_states(); ++k) {
    const double *a = one.accelerations_at(k), *b = other.accelerations_at(k);
    if (a == nullptr || b == nullptr) return std::numeric_limits<double>::infinity();
    double largest = 0, difference = 0;
    for (int i = 0; i < one.coordinates(); ++i) {
      largest = std::max(largest, std::abs(b[i]));
      difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    worst = std::max(worst, difference / largest);
  }
  return worst;
}

double seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 1;
  const Solver both[] = {loaded(argv[1]), loaded(argv[2])};
  both[0].make_states();
  both[0].load_states();
  if (both[0].doubles_of_state() != both[1].doubles_of_state()) {
    std::fprintf(stderr, "the two solvers have other states\n");
    return 1;
  }
  for (int k = 0; k < both[0].count_of_states(); ++k)
    std::copy_n(both[0].state_at(k), both[0].doubles_of_state(), both[1].state_at(k));
  both[1].load_states();
  const double apart = deviation(both[0], both[1]);
  if (!(apart < kAgreement)) {
    std::fprintf(stderr, "the two solvers do not agree: %.1e\n", apart);
    return 1;
  }
  constexpr int kCalls[kFigures] = {400, 100, 400, 400};
  double least[kFigures][2];
  std::fill_n(&least[0][0], 2 * kFigures, std::numeric_limits<double>::infinity());
  for (int turn = 0; turn < std::atoi(argv[3]); ++turn)
    for (int figure = 0; figure < kFigures; ++figure)
      for (int who = 0; who < 2; ++who) {
        both[who].figures[figure](kCalls[figure] / 4);
        const double start = seconds();
        both[who].figures[figure](kCalls[figure]);
        least[figure][who] = std::min(least[figure][who], 1e6 * (seconds() - start) / kCalls[figure]);
      }
  for (const auto& figure : least) std::printf(" | %8.3f %8.3f %6.2f", figure[1], figure[0], figure[0] / figure[1]);
  std::printf(" | %.0e\n", apart);
}
