// Every function of a batch interface against the scalar solver, lane by lane: statuses and bits; none may touch the
// heap.
//   c++ ... -DSOLVER=four_bar -DINTERFACE='"four_bar_batch.hpp"' check.cpp heap.cpp, with the solver's sources
// With -DIMPLICIT the solver has step_rosenbrock as well. Without heap.cpp the heap is not watched. Prints what
// differs; exit code 1 then.

#include INTERFACE

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

/// Calls of the heap so far, by heap.cpp.
extern "C" [[gnu::weak]] long heap_calls();

namespace {

namespace solver = SOLVER;
namespace batch = SOLVER::batch;
using batch::kLanes;
using solver::kCoordinates;

constexpr int kRounds = 20;
constexpr double kStep = 1e-3;
constexpr double kLongStep = 0.02;  // whose drift is more than rounding: poor pivots are corrected otherwise

int failures = 0;
std::mt19937 random_bits(1);

double number(double range) { return std::uniform_real_distribution<double>(-range, range)(random_bits); }

void expect_status(const char* what, int lane, mbgen::Status found, mbgen::Status expected) {
  if (found.code == expected.code && found.index == expected.index) return;
  if (failures++ < 20) {
    std::printf("%s, lane %d: %s %d instead of %s %d\n", what, lane, text(found.code), found.index, text(expected.code),
                expected.index);
  }
}

/// The same bits, or both no number.
template <class Struct>
void expect_same(const char* what, int lane, const Struct& found, const Struct& expected) {
  constexpr std::size_t kNumbers = sizeof(Struct) / sizeof(double);
  double a[kNumbers], b[kNumbers];
  std::memcpy(a, &found, sizeof a);
  std::memcpy(b, &expected, sizeof b);
  for (std::size_t i = 0; i < kNumbers; ++i) {
    if (std::memcmp(a + i, b + i, sizeof(double)) == 0 || (std::isnan(a[i]) && std::isnan(b[i]))) continue;
    if (failures++ < 20) std::printf("%s, lane %d, number %zu: %.17g instead of %.17g\n", what, lane, i, a[i], b[i]);
  }
}

/// Expects no call of the heap since `before`.
void expect_no_heap(const char* what, long before) {
  if (heap_calls == nullptr || heap_calls() == before) return;
  const long count = heap_calls() - before;
  if (failures++ < 20) std::printf("%s: %ld calls of the heap\n", what, count);
}

long heap_now() { return heap_calls == nullptr ? 0 : heap_calls(); }

/// One instance, as the scalar solver has it.
struct Instance {
  solver::Parameters parameters;
  solver::Inputs inputs;
  solver::State state{};
  double tau[kCoordinates] = {};
  solver::Derivative derivative{};
  solver::Outputs outputs{};
  solver::Multipliers multipliers{};
  solver::History history{};
};

struct Batch {
  batch::Parameters parameters;
  batch::Inputs inputs;
  batch::State state{};
  batch::JointForces forces{};
  batch::Derivative derivative{};
  batch::Outputs outputs{};
  batch::Multipliers multipliers{};
  batch::History history{};
};

/// A consistent state near the reference configuration.
void make_consistent(Instance& one) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const double range = 0.2 / (1 + attempt);
    for (double& z : one.state.z) z = number(range);
    for (double& zd : one.state.zd) zd = number(0.5);
    for (double& x : one.state.x) x = number(1e-4);
    if (solver::kAuxiliaryStates == 0) one.state.x[0] = 0;
    one.state.t = number(1) + 1;
    // Most at a multiple of the step, where sampled values can be due.
    if (number(1) > -0.8) one.state.t = kStep * std::nearbyint(one.state.t / kStep);
    if (assemble(one.parameters, one.inputs, one.state).ok()) return;
  }
  std::printf("no consistent state found\n");
  ++failures;
}

void gather(const Instance (&all)[kLanes], Batch& lanes) {
  for (int lane = 0; lane < kLanes; ++lane) {
    set_lane(lanes.parameters, lane, all[lane].parameters);
    set_lane(lanes.inputs, lane, all[lane].inputs);
    set_lane(lanes.state, lane, all[lane].state);
    set_lane(lanes.derivative, lane, all[lane].derivative);
    set_lane(lanes.outputs, lane, all[lane].outputs);
    set_lane(lanes.multipliers, lane, all[lane].multipliers);
    for (int i = 0; i < kCoordinates; ++i) lanes.forces.tau[i][lane] = all[lane].tau[i];
  }
}

void check_evaluation(Instance (&all)[kLanes], Batch& lanes) {
  const batch::Statuses a = accelerations(lanes.parameters, lanes.inputs, lanes.state, lanes.forces, lanes.derivative);
  for (int lane = 0; lane < kLanes; ++lane) {
    Instance& one = all[lane];
    expect_status("accelerations", lane, a[lane],
                  accelerations(one.parameters, one.inputs, one.state, one.tau, one.derivative));
    expect_same("derivative", lane, lane_of(lanes.derivative, lane), one.derivative);
  }
  const batch::Statuses m =
      multipliers(lanes.parameters, lanes.inputs, lanes.state, lanes.forces, lanes.derivative, lanes.multipliers);
  const batch::Statuses o =
      outputs(lanes.parameters, lanes.inputs, lanes.state, lanes.forces, lanes.derivative, lanes.outputs);
  for (int lane = 0; lane < kLanes; ++lane) {
    Instance& one = all[lane];
    expect_status("multipliers", lane, m[lane],
                  multipliers(one.parameters, one.inputs, one.state, one.tau, one.derivative, one.multipliers));
    expect_same("multipliers", lane, lane_of(lanes.multipliers, lane), one.multipliers);
    expect_status("outputs", lane, o[lane],
                  outputs(one.parameters, one.inputs, one.state, one.tau, one.derivative, one.outputs));
    expect_same("outputs", lane, lane_of(lanes.outputs, lane), one.outputs);
    solver::ClosureResidual residual;
    solver::Derivative moving = one.derivative;
    solver::closure_residual(one.parameters, one.inputs, one.state, residual);
    solver::describe(solver::accelerations_in_motion(one.parameters, one.inputs, one.state, kStep, moving));
  }
}

void check_assembly(Instance (&all)[kLanes], Batch& lanes) {
  for (int lane = 0; lane < kLanes; ++lane) {
    for (double& z : all[lane].state.z) z += number(0.02);
    set_lane(lanes.state, lane, all[lane].state);
  }
  const batch::Statuses s = assemble(lanes.parameters, lanes.inputs, lanes.state);
  for (int lane = 0; lane < kLanes; ++lane) {
    expect_status("assemble", lane, s[lane], assemble(all[lane].parameters, all[lane].inputs, all[lane].state));
    expect_same("assembled state", lane, lane_of(lanes.state, lane), all[lane].state);
  }
}

enum class Method { rk4, abm4, rosenbrock };
constexpr const char* kStepOf[] = {"step_rk4", "step_abm4", "step_rosenbrock"};

/// A step of one instance, or of all lanes.
template <class One>
auto step_by(Method method, One& one, double h) {
#ifdef IMPLICIT
  if (method == Method::rosenbrock) return step_rosenbrock(one.parameters, one.inputs, one.state, h);
#endif
  return method == Method::abm4 ? step_abm4(one.parameters, one.inputs, one.state, one.history, h)
                                : step_rk4(one.parameters, one.inputs, one.state, h);
}

void check_steps(Instance (&all)[kLanes], Batch& lanes, Method method, int steps, double usual = kStep) {
  const char* what = kStepOf[static_cast<int>(method)];
  for (int step = 0; step < steps; ++step) {
    // Another step size starts the multistep method up again; one lane does so alone.
    const double h = step == 6 ? usual / 2 : usual;
    if (method == Method::abm4 && step == 9) all[1].history.count = lanes.history.count[1] = 0;
    const batch::Statuses s = step_by(method, lanes, h);
    for (int lane = 0; lane < kLanes; ++lane) {
      expect_status(what, lane, s[lane], step_by(method, all[lane], h));
      expect_same(what, lane, lane_of(lanes.state, lane), all[lane].state);
    }
  }
}

/// Everything once; `trouble` spoils some of the instances first.
template <class Trouble>
void check(const Trouble& trouble) {
  static Instance all[kLanes];
  static Batch lanes;
  lanes.history = {};
  for (Instance& one : all) {
    one = {};
    make_consistent(one);
    for (double& tau : one.tau) tau = number(10);
  }
  trouble(all);
  const long before = heap_now();
  gather(all, lanes);
  check_evaluation(all, lanes);
  expect_no_heap("evaluation", before);
  check_steps(all, lanes, Method::rk4, 3);
  check_steps(all, lanes, Method::rk4, 3, kLongStep);
  check_steps(all, lanes, Method::abm4, 12);
#ifdef IMPLICIT
  check_steps(all, lanes, Method::rosenbrock, 3);
#endif
  expect_no_heap("steps", before);
  check_evaluation(all, lanes);
  check_assembly(all, lanes);
  expect_no_heap("assembly", before);
}

}  // namespace

int main() {
  static char text_of_differences[1 << 16];  // else the first one that is printed asks for a buffer from the heap
  std::setvbuf(stdout, text_of_differences, _IOFBF, sizeof text_of_differences);
  if (heap_calls != nullptr) {
    const long before = heap_calls();
    void* volatile block = std::malloc(1);  // volatile, or the compiler does without
    std::free(block);
    double* volatile number = new double;
    delete number;
    if (heap_calls() != before + 4) std::printf("%d: the heap is not watched\n", ++failures);
  }
  for (int round = 0; round < kRounds; ++round) check([](Instance(&)[kLanes]) {});
  for (int round = 0; round < kRounds; ++round) {
    check([](Instance(&all)[kLanes]) {
      // Far from the reference, what is no number, a loop that is wide open, and a motion that
      // overflows.
      for (double& z : all[0].state.z) z += number(3);
      if (!assemble(all[0].parameters, all[0].inputs, all[0].state).ok()) make_consistent(all[0]);
      all[1].state.z[random_bits() % kCoordinates] = NAN;
      for (double& z : all[2].state.z) z += number(3);
      all[3].state.zd[random_bits() % kCoordinates] = 1e200;
    });
  }
  // Every lane starts where the scalar solver does.
  const solver::State start = solver::initial_state();
  const batch::State starts = batch::initial_state();
  for (int lane = 0; lane < kLanes; ++lane) {
    const solver::State one = lane_of(starts, lane);
    for (int i = 0; i < kCoordinates; ++i) {
      if (one.z[i] == start.z[i] && one.zd[i] == start.zd[i]) continue;
      std::printf("lane %d starts elsewhere\n", lane);
      ++failures;
    }
  }
  // A step that is none changes nothing.
  static Batch lanes;
  if (step_rk4(lanes.parameters, lanes.inputs, lanes.state, 0)[kLanes - 1].code != mbgen::Code::step_invalid) {
    std::printf("a step of no length\n");
    ++failures;
  }
  if (failures > 0) std::printf("%d differences\n", failures);
  return failures > 0 ? 1 : 0;
}
