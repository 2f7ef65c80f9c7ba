#include "workbench/motion/turn_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/model.hpp"
#include "mbgen/turns.hpp"
#include "workbench/describe/names.hpp"

namespace mbgen {
namespace {

/// Change of a closure residual, m, that opens a loop.
constexpr double kOpens = 1e-9;

bool is_power_of_two(long count) { return (count & (count - 1)) == 0; }

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

TurnWatch::TurnWatch(const Compilation& compilation, SolverSettings::Integrator integrator, double step)
    : compilation_(compilation),
      integrator_(integrator),
      step_(step),
      solver_(compilation.model, compilation.topology, compilation.analysis),
      turns_(compilation.topology.bodies.size()) {}

void TurnWatch::add(const Sample& sample) {
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    if (compilation_.topology.bodies[i].kind != FreedomKind::revolute) continue;
    const double turn = std::abs(sample.moving.zd[i]) * step_;
    if (!(turn > largest_turn(integrator_))) continue;
    Turn& known = turns_[i];
    ++known.seen;
    if (!known.matters && is_power_of_two(known.seen) && matters(i, sample)) {
      known.matters = true;
      known.since = sample.state.t;
    }
    if (known.matters) known.largest = std::max(known.largest, turn);
  }
}

bool TurnWatch::matters(std::size_t coordinate, const Sample& sample) const {
  solver_.set_inputs(sample.inputs);
  const std::vector<double> no_forces(sample.moving.z.size(), 0.0);
  GenericDerivative here, there;
  if (!solver_.accelerations(sample.moving, no_forces, here).ok()) return true;
  const std::vector<double> positions = solver_.position_residuals(sample.moving),
                            velocities = solver_.velocity_residuals(sample.moving);
  const double rate = sample.moving.zd[coordinate];
  for (const double turn : kTriedTurns) {
    GenericState turned = sample.moving;
    turned.z[coordinate] += turn;
    if (largest_difference(positions, solver_.position_residuals(turned)) > kOpens) return true;
    if (largest_difference(velocities, solver_.velocity_residuals(turned)) > kOpens * std::abs(rate)) return true;
    if (!solver_.accelerations(turned, no_forces, there).ok()) return true;
    if (differ_by_turn(here.zdd.data(), there.zdd.data(), static_cast<int>(here.zdd.size()), rate)) return true;
  }
  return false;
}

double TurnWatch::longest_step() const {
  double largest = 0;
  for (const Turn& turn : turns_) largest = std::max(largest, turn.largest);
  return largest > 0 ? largest_turn(integrator_) / largest * step_ : 0;
}

std::vector<std::string> TurnWatch::warnings() const {
  const auto farthest = std::max_element(turns_.begin(), turns_.end(),
                                         [](const Turn& a, const Turn& b) { return a.largest < b.largest; });
  if (farthest == turns_.end() || farthest->largest == 0) return {};
  const auto i = static_cast<std::size_t>(farthest - turns_.begin());
  const double limit = largest_turn(integrator_);
  return {fmt::format(
      "{} turns by {:.3g} rad in a step of {:.6g} s from t = {:.6g} s on, and forces turn with it: {} bears {:g} rad; "
      "--step {:.2g} would do",
      compilation_.topology.bodies[i].coordinate, farthest->largest, step_, farthest->since, name_of(integrator_),
      limit, 0.95 * longest_step())};
}

}  // namespace mbgen
