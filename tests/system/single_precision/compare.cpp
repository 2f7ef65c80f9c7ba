// A solver in single precision against the same in double precision; see check.sh.
//   compare STEPS H MOMENT UNITS, built with -DSOLVER=four_bar -DSINGLE=four_bar_float and their headers
//
// Accelerations: at states of the single trajectory, those of float code may differ from those of double code by what
// UNITS units of the last place in each coordinate and velocity, in the time, and of MOMENT (N m or N) in each joint's
// force would change, and by as many units of their own. MOMENT is what forces have about the origin of the body on
// which their loop or tree stands, and is rounded at: joints far from there get small differences of such moments.
// Trajectory: it may leave the double one by kFactor times as much as a double trajectory does whose coordinates and
// velocities are moved after every step by up to kMoved units of single precision, at random: closures are left open by
// 2^-20, that is sixteen units.

#include DOUBLE_INTERFACE
#include SINGLE_INTERFACE
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>
#include <vector>

namespace {

namespace exact = SOLVER;
namespace single = SINGLE;

constexpr int kCount = exact::kCoordinates;
constexpr double kUnit = 0x1p-24, kMoved = 16, kFactor = 2;
constexpr int kLook = 10;  // steps between two looks at the accelerations

template <class From, class To>
void convert(const From& from, To& to) {
  using Number = std::remove_all_extents_t<decltype(To::z)>;
  for (int i = 0; i < kCount; ++i) to.z[i] = static_cast<Number>(from.z[i]);
  for (int i = 0; i < kCount; ++i) to.zd[i] = static_cast<Number>(from.zd[i]);
  for (int i = 0; i < exact::kAuxiliaryStates; ++i) to.x[i] = static_cast<Number>(from.x[i]);
  to.t = from.t;
}

double unit_of(double value) { return kUnit * std::max(std::abs(value), 1.0); }

/// Results of one run; distances in z are in rad or m.
struct Findings {
  double acceleration = 0;                 ///< largest error over what it may be
  double apart = 0, moved = 0;             ///< of the single and of the moved trajectory from the double one
  double residual = 0, residual_rate = 0;  ///< of the single trajectory, computed in double
  double balance = 0, balance_double = 0;  ///< energy gained less work, over the largest kinetic energy
  double last_z = 0, last_zd = 0;          ///< sums of the coordinates and velocities at the end, for their bits
  int failures = 0;
};

double distance(const exact::State& a, const exact::State& b) {
  double largest = 0;
  for (int i = 0; i < kCount; ++i) largest = std::max(largest, std::abs(a.z[i] - b.z[i]));
  return largest;
}

const exact::Parameters kParameters;
const exact::Inputs kInputs;
const single::Parameters kSingleParameters;
const single::Inputs kSingleInputs;
constexpr double kNoForces[kCount] = {};
constexpr float kNoSingleForces[kCount] = {};

void look_at_accelerations(const single::State& state, double moment, double units, Findings& findings) {
  single::Derivative found{};
  exact::Derivative right{}, other{};
  exact::State at{};
  convert(state, at);
  if (!exact::accelerations(kParameters, kInputs, at, kNoForces, right).ok() ||
      !single::accelerations(kSingleParameters, kSingleInputs, state, kNoSingleForces, found).ok()) {
    ++findings.failures;
    return;
  }
  std::vector<double> allowed(kCount);
  for (int i = 0; i < kCount; ++i) allowed[i] = unit_of(right.zdd[i]);
  double tau[kCount] = {};
  const auto add_change = [&](double& argument, double change) {
    const double kept = argument;
    argument += change;
    exact::accelerations(kParameters, kInputs, at, tau, other);
    argument = kept;
    for (int i = 0; i < kCount; ++i) allowed[i] += std::abs(other.zdd[i] - right.zdd[i]);
  };
  for (double& z : at.z) add_change(z, unit_of(z));
  for (double& zd : at.zd) add_change(zd, unit_of(zd));
  for (double& force : tau) add_change(force, kUnit * moment);
  add_change(at.t, unit_of(at.t));
  for (int i = 0; i < kCount; ++i) {
    const double error = std::abs(static_cast<double>(found.zdd[i]) - right.zdd[i]);
    findings.acceleration = std::max(findings.acceleration, error / (units * allowed[i]));
  }
}

/// Energy balance of a trajectory, by the outputs of the double solver and the trapezoidal rule.
class Balance {
 public:
  void add(const exact::State& state, double h) {
    exact::Derivative derivative{};
    exact::Outputs values{};
    exact::accelerations(kParameters, kInputs, state, kNoForces, derivative);
    exact::outputs(kParameters, kInputs, state, kNoForces, derivative, values);
    const double energy = values.kinetic_energy + values.potential_energy;
    if (count_++ == 0)
      start_ = energy;
    else
      work_ += h / 2 * (values.applied_power + power_);
    power_ = values.applied_power;
    kinetic_ = std::max(kinetic_, values.kinetic_energy);
    worst_ = std::max(worst_, std::abs(energy - start_ - work_));
  }
  double worst() const { return worst_ / kinetic_; }

 private:
  int count_ = 0;
  double start_ = 0, work_ = 0, power_ = 0, kinetic_ = 0, worst_ = 0;
};

Findings compare(int steps, double h, double moment, double units) {
  Findings findings;
  exact::State right = exact::initial_state(), moved = right, seen{};
  single::State state{};
  convert(right, state);
  std::mt19937 random(1);
  const auto noise = [&](double value) {
    return kMoved * unit_of(value) * (std::uniform_real_distribution<double>(-1, 1)(random));
  };
  Balance balance, balance_double;
  for (int step = 0; step < steps; ++step) {
    if (step % kLook == 0) look_at_accelerations(state, moment, units, findings);
    findings.failures += exact::step_rk4(kParameters, kInputs, right, h).ok() ? 0 : 1;
    findings.failures += exact::step_rk4(kParameters, kInputs, moved, h).ok() ? 0 : 1;
    const mbgen::Status status = single::step_rk4(kSingleParameters, kSingleInputs, state, h);
    if (!status.ok()) {
      std::printf("step %d: %s %s\n", step, mbgen::text(status.code), single::describe(status));
      ++findings.failures;
      return findings;
    }
    for (int i = 0; i < kCount; ++i) moved.z[i] += noise(moved.z[i]);
    for (int i = 0; i < kCount; ++i) moved.zd[i] += noise(moved.zd[i]);
    convert(state, seen);
    findings.apart = std::max(findings.apart, distance(seen, right));
    findings.moved = std::max(findings.moved, distance(moved, right));
    exact::ClosureResidual residual{};
    exact::closure_residual(kParameters, kInputs, seen, residual);
    findings.residual = std::max(findings.residual, residual.largest_position);
    findings.residual_rate = std::max(findings.residual_rate, residual.largest_velocity);
    balance.add(seen, h);
    balance_double.add(right, h);
  }
  for (int i = 0; i < kCount; ++i) findings.last_z += seen.z[i];
  for (int i = 0; i < kCount; ++i) findings.last_zd += seen.zd[i];
  findings.balance = balance.worst();
  findings.balance_double = balance_double.worst();
  return findings;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) return 2;
  const Findings found = compare(std::atoi(words[1]), std::atof(words[2]), std::atof(words[3]), std::atof(words[4]));
  std::printf("accelerations: error %.2f of what is allowed\n", found.acceleration);
  std::printf("trajectory: apart by %.2e, moved by noise %.2e\n", found.apart, found.moved);
  std::printf("closures: residual %.2e, rate %.2e\n", found.residual, found.residual_rate);
  std::printf("end: %a %a\n", found.last_z, found.last_zd);
  std::printf("energy balance: %.2e, in double %.2e\n", found.balance, found.balance_double);
  const bool good = found.failures == 0 && found.acceleration <= 1 && found.apart <= kFactor * found.moved;
  if (found.failures > 0) std::printf("%d calls failed\n", found.failures);
  return good ? 0 : 1;
}
