#include "runtime/judges/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mbgen/solver/newton.hpp"
#include "runtime/judges/methods.hpp"

namespace mbgen {
namespace {

constexpr double kZeroPivot = 1e-10;  // relative to the first
/// Closures open by 1 m or 1 turn a zero into a pivot of up to 2, relative to the first one, in all our models; pivots
/// of independent equations are above 0.02.
constexpr double kPivotPerResidual = 10, kLargestZero = 5e-3;
/// Relative rounding of c, and its error from closures open by 1 m or 1.
constexpr double kCompatible = 1e-8;
constexpr double kBiasPerResidual = 100;
/// Relative difference of rates below which they count as equal.
constexpr double kTie = 1e-6;

double largest(const Eigen::VectorXd& values) { return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff(); }

/// Tree coordinate that moves most in a motion of the bodies.
int leading_coordinate(const Mechanics& mechanics, const PlacedState& at, const Eigen::VectorXd& motion) {
  CartesianState moving = at.bodies;
  mechanics.system.set_velocities(moving, motion);
  const std::vector<double> rates = mechanics.system.joint_state(moving, at.z).zd;
  double most = 0;
  for (double rate : rates) most = std::max(most, std::abs(rate));
  const auto leads = [most](double rate) { return std::abs(rate) >= (1 - kTie) * most; };
  return static_cast<int>(std::find_if(rates.begin(), rates.end(), leads) - rates.begin());
}

/// Newton step for the positions, shortened if it would leave the basin of attraction.
Eigen::VectorXd newton_step(const Evaluation& evaluation) {
  const Eigen::VectorXd dq =
      mass_orthogonal_correction(evaluation.terms.mass, *evaluation.factors, -evaluation.terms.residual);
  return shortening(largest(dq), kLargestNewtonStep<double>) * dq;
}

}  // namespace

Status evaluate(const Mechanics& mechanics, const PlacedState& at, const std::vector<double>& tau,
                const std::vector<int>& equations, Evaluation& evaluation) {
  evaluation.terms = mechanics.system.terms(at.bodies, at.z, tau);
  const CartesianTerms& terms = evaluation.terms;
  if (const Status status = check_holds(terms.hold); !status.ok()) return status;
  if (!terms.jacobian.allFinite() || !terms.mass.allFinite() || !terms.force.allFinite() || !terms.bias.allFinite())
    return {Code::not_a_number, -1};
  PivotRule rule{kZeroPivot, equations, terms.late};
  if (equations.empty())
    rule.smallest = std::clamp(kPivotPerResidual * largest(terms.residual), kZeroPivot, kLargestZero);
  evaluation.factors.emplace(terms.jacobian, rule);
  const std::optional<Eigen::VectorXd> motion = motion_without_inertia(terms.mass, *evaluation.factors);
  if (motion) return {Code::no_inertia, leading_coordinate(mechanics, at, *motion)};
  return {};
}

Status check_compatibility(const Mechanics& mechanics, const Evaluation& evaluation, const ReducedBias& bias) {
  if (bias.dropped.size() == 0) return {};
  const CartesianTerms& terms = evaluation.terms;
  const double size = 1 + largest(terms.bias);
  const double opening = size * largest(terms.residual) + std::sqrt(size) * largest(terms.velocity);
  Eigen::Index worst = 0;
  if (bias.dropped.cwiseAbs().maxCoeff(&worst) <= kCompatible * size + kBiasPerResidual * opening) return {};
  const Eigen::VectorXd weights = evaluation.factors->dependency(static_cast<int>(worst));
  return {Code::loop_singular, block_of(mechanics, weights)};
}

int block_of(const Mechanics& mechanics, const Eigen::VectorXd& weights) {
  double most = 0;
  int leading = -1;
  for (int e = 0; e < mechanics.system.equations(); ++e)
    if (mechanics.system.loop_of(e) >= 0 && std::abs(weights[e]) > most) {
      most = std::abs(weights[e]);
      leading = mechanics.system.loop_of(e);
    }
  const auto contains = [leading](const LoopBlock& block) {
    return std::find(block.loops.begin(), block.loops.end(), leading) != block.loops.end();
  };
  const std::vector<LoopBlock>& blocks = mechanics.topology.blocks;
  const auto block = std::find_if(blocks.begin(), blocks.end(), contains);
  return block == blocks.end() ? -1 : static_cast<int>(block - blocks.begin());
}

Status close(const Mechanics& mechanics, double tolerance, PlacedState& configuration) {
  const std::vector<double> no_tau(configuration.z.z.size(), 0.0);
  CartesianState& bodies = configuration.bodies;
  const int start = block_of(mechanics, mechanics.system.terms(bodies, configuration.z, no_tau).residual);
  double previous = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= kNewtonIterations; ++step) {
    Evaluation evaluation;
    if (const Status status = evaluate(mechanics, configuration, no_tau, {}, evaluation); !status.ok()) return status;
    const double opening = largest(evaluation.terms.residual);
    if (!std::isfinite(opening)) return {Code::not_a_number, -1};
    const bool gains = opening < 0.5 * previous;
    previous = opening;
    if (opening <= tolerance || (!gains && opening <= kClosed)) {
      const Eigen::VectorXd change =
          mass_orthogonal_correction(evaluation.terms.mass, *evaluation.factors, -evaluation.terms.velocity);
      mechanics.system.set_velocities(bodies, mechanics.system.velocities(bodies) + change);
      configuration.z = mechanics.system.joint_state(bodies, configuration.z);
      return {};
    }
    mechanics.system.displace(bodies, newton_step(evaluation));
    configuration.z = mechanics.system.joint_state(bodies, configuration.z);
  }
  return {Code::loop_not_closed, start};
}

}  // namespace mbgen
