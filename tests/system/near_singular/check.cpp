// The rocker's turn and the energy of near_parallelogram over offsets, steps and methods; see check.sh. Right are a
// motion on the branch that it started on (links that are not equal never come into line) and the energy, which nothing
// changes.

#include <cmath>
#include <cstdio>

#include "near_parallelogram.hpp"
#include "near_parallelogram_batch.hpp"

namespace {

using namespace near_parallelogram;

enum class Method { rk4, abm4, rosenbrock };
constexpr const char* kNames[] = {"rk4", "abm4", "rosenbrock"};
constexpr double kOffsets[] = {1e-2, 3e-3, 1e-3, 1e-4, 1e-5, -1e-2, -1e-3, -1e-4};
constexpr double kDuration = 4;  // s
/// Angles of the bars at the reference, rad.
constexpr double kCrank = 0.5, kCoupler = -0.8084000684560818, kRocker = -1.309185768711789;

/// Steps over the root of the offset that every method has to go on by: somewhat shorter than those by which energies
/// are kept to 1 %.
constexpr double kFine[] = {0.03, 0.015, 0.015};

int failures = 0;

struct Instance {
  Parameters parameters;
  State state = initial_state();
  History history{};
};

template <class One, class Inputs>
auto step_by(Method method, One& one, const Inputs& inputs, double h) {
  if (method == Method::rosenbrock) return step_rosenbrock(one.parameters, inputs, one.state, h);
  return method == Method::abm4 ? step_abm4(one.parameters, inputs, one.state, one.history, h)
                                : step_rk4(one.parameters, inputs, one.state, h);
}

double energy(const Instance& at) {
  Outputs values{};
  const double tau[kCoordinates] = {};
  if (!outputs(at.parameters, Inputs{}, at.state, tau, Derivative{}, values).ok()) return NAN;
  return values.kinetic_energy;
}

/// Sine of the angle that comes near zero: between coupler and rocker, or crank and coupler where the rocker is
/// shorter.
double side(const Instance& at) {
  const double* z = at.state.z;
  const double coupler = kCoupler + z[Coordinate::ja] + z[Coordinate::jb];
  return at.parameters.offset > 0 ? std::sin(kRocker + z[Coordinate::jc] - coupler)
                                  : std::sin(coupler - kCrank - z[Coordinate::ja]);
}

Instance start_at(double offset) {
  Instance one;
  one.parameters.offset = offset;
  if (!assemble(one.parameters, Inputs{}, one.state).ok()) ++failures, std::printf("offset %g: not closed\n", offset);
  return one;
}

/// Codes that name the loop.
bool names_the_loop(mbgen::Status status) {
  return (status.code == mbgen::Code::loop_singular || status.code == mbgen::Code::loop_not_closed) &&
         status.index == 0;
}

struct Counts {
  int right = 0, inexact = 0, refused = 0;
};

void follow(double offset, double h, Method method, Counts& counts) {
  Instance one = start_at(offset);
  const double before = energy(one), of_start = side(one);
  const bool is_fine = h <= kFine[static_cast<int>(method)] * std::sqrt(std::abs(offset));
  double error = 0;
  bool is_left = false;
  mbgen::Status status;
  for (double t = 0; t < kDuration && status.ok(); t += h) {
    status = step_by(method, one, Inputs{}, h);
    if (!status.ok()) break;
    error = std::fmax(error, std::abs(energy(one) / before - 1));
    is_left = is_left || side(one) * of_start < 0;
  }
  const char* fault = nullptr;
  if (status.ok() && is_left) fault = "is on the wrong branch, ok";
  if (status.ok() && !(error < 0.1)) fault = "has lost its energy, ok";
  if (!status.ok() && !names_the_loop(status)) fault = "ends without the loop's name";
  if (is_fine && !status.ok()) fault = "is refused, though it is fine";
  if (is_fine && !(error < 0.01)) fault = "is inexact, though it is fine";
  if (fault != nullptr) {
    ++failures;
    std::printf("offset %g, h %g, %s: %s (code %d at %g s, energy %g)\n", offset, h, kNames[static_cast<int>(method)],
                fault, static_cast<int>(status.code), one.state.t, error);
  }
  ++(!status.ok() ? counts.refused : error < 0.01 ? counts.right : counts.inexact);
}

struct Lanes {
  batch::Parameters parameters{};
  batch::State state{};
  batch::History history{};
};

/// Lanes of four offsets say and do what instances of their own do, until they fail.
void follow_lanes(double h, Method method) {
  Instance all[batch::kLanes];
  Lanes lanes;
  bool has_failed[batch::kLanes] = {};
  for (int lane = 0; lane < batch::kLanes; ++lane) {
    all[lane] = start_at(kOffsets[2 * lane]);
    set_lane(lanes.parameters, lane, all[lane].parameters);
    set_lane(lanes.state, lane, all[lane].state);
  }
  for (double t = 0; t < kDuration; t += h) {
    const batch::Statuses statuses = step_by(method, lanes, batch::Inputs{}, h);
    for (int lane = 0; lane < batch::kLanes; ++lane) {
      if (has_failed[lane]) continue;
      const mbgen::Status status = step_by(method, all[lane], Inputs{}, h);
      has_failed[lane] = !status.ok();
      const bool is_same = lane_of(lanes.state, lane).z[0] == all[lane].state.z[0];
      if (status.code == statuses[lane].code && status.index == statuses[lane].index && is_same) continue;
      ++failures;
      has_failed[lane] = true;
      std::printf("lane %d, h %g, %s, t %g: code %d, alone %d\n", lane, h, kNames[static_cast<int>(method)],
                  all[lane].state.t, static_cast<int>(statuses[lane].code), static_cast<int>(status.code));
    }
  }
}

}  // namespace

int main() {
  constexpr int kSteps = 40;
  for (const double offset : kOffsets) {
    for (const Method method : {Method::rk4, Method::abm4, Method::rosenbrock}) {
      Counts counts;
      for (int k = 0; k < kSteps; ++k) follow(offset, 1e-3 * std::pow(100, k / (kSteps - 1.0)), method, counts);
      for (const double part : {1.0, 0.7}) {
        follow(offset, part * kFine[static_cast<int>(method)] * std::sqrt(std::abs(offset)), method, counts);
      }
      std::printf("offset %6.0e %-10s right %2d, energy off by 1 to 10 %% %2d, refused %2d\n", offset,
                  kNames[static_cast<int>(method)], counts.right, counts.inexact, counts.refused);
      if (counts.right == 0 || counts.refused == 0) ++failures, std::printf("nothing right, or nothing refused\n");
    }
  }
  for (const Method method : {Method::rk4, Method::abm4, Method::rosenbrock}) {
    for (const double h : {2e-3, 0.011, 0.04, 0.07}) follow_lanes(h, method);
  }
  return failures == 0 ? 0 : 1;
}
