#include "workbench/operating/steady_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/algebra/dense.hpp"
#include "compiler/linearisation/bristles.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "mbgen/solver/newton.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/operating/steady_checks.hpp"
#include "workbench/operating/steady_request.hpp"
#include "workbench/operating/turning_frame.hpp"

namespace mbgen {
namespace {

using StateKind = LinearState::Kind;

constexpr double kMoves = 1e-9;         // rad/s or m/s: threshold of a moving coordinate
constexpr int kMostVain = 8;            // steps without a smaller residual
constexpr double kShortest = 1.0 / 64;  // of a step
constexpr double kFlat = 1e-9;          // of the largest derivative: threshold of zero
constexpr double kComesToRest = 0.05;   // of the initial speed: below it the search has reached standstill

/// Search for a steady motion by Newton's method.
class Search {
 public:
  Search(const Compilation& compilation, OperatingPoint start, const SteadyRequest& request, bool scales_rows)
      : c_(compilation),
        scales_rows_(scales_rows),
        solver_(compilation.model, compilation.topology, compilation.analysis) {
    motion_.point = std::move(start);
    independent_ = free_coordinates(c_.topology, c_.analysis);
    take(request);
    find_turning();
    if (request.finds_heading) heading_ = yaw_;
    for (const int i : independent_)
      if (!travels(i)) motion_.point.zd[i] = 0;
    require_closed(close());
  }

  SteadyMotion find() {
    set_steady_states(c_, motion_.point);
    SteadyMotion best = motion_;
    best.largest = std::numeric_limits<double>::infinity();
    int since_best = 0;
    for (int step = 0; step < kSteadyIterations && since_best < kMostVain; ++step, ++since_best) {
      const LinearSystem system = expect(linearise(c_, motion_.point));
      const Eigen::VectorXd left = residual(system);
      motion_.largest = left.size() > 0 ? left.cwiseAbs().maxCoeff() : 0.0;
      if (std::abs(motion_.point.zd[leader_]) < kComesToRest * std::abs(rate_at_start_)) break;
      if (motion_.largest < best.largest) {
        best = motion_;
        since_best = 0;
      }
      if (motion_.largest < kSteady) return finished(system);
      change(system, left);
    }
    if (std::isfinite(best.largest)) motion_ = best;
    const LinearSystem system = expect(linearise(c_, motion_.point));
    const Eigen::VectorXd left = residual(system);
    if (missed(left) < 0 && is_weighed_out(c_, solver_, motion_.point, rates_of(left)) &&
        std::abs(motion_.point.zd[leader_]) >= kComesToRest * std::abs(rate_at_start_))
      return finished(system);
    fail(system, left);
  }

 private:
  bool travels(int i) const { return std::find(travelling_.begin(), travelling_.end(), i) != travelling_.end(); }
  bool is_held(int i) const { return std::find(held_.begin(), held_.end(), i) != held_.end(); }

  [[noreturn]] void fail(const LinearSystem& system, const Eigen::VectorXd& left) const {
    const double rates = rates_of(left).cwiseAbs().maxCoeff();
    if (const int place = missed(left); place >= 0 && rates < kSteady) {
      const OutputGoal& goal = goals_[static_cast<std::size_t>(place)];
      throw UserError(fmt::format(
          "{}: no steady motion found: output \"{}\" is {:.6g} in place of {:.6g}\n  hint: --solve an input that "
          "moves it\n",
          c_.model.file, c_.model.outputs[static_cast<std::size_t>(goal.output)].name,
          goal.value + left[left.size() - static_cast<Eigen::Index>(goals_.size()) + place], goal.value));
    }
    const TreeBody& leading_body = c_.topology.bodies[static_cast<std::size_t>(leading(system, left))];
    throw UserError(fmt::format("{}: no steady motion found: {} goes on to accelerate at {:.3g} {}/s^2\n  hint: {}\n",
                                c_.model.file, leading_body.coordinate, rates, unit_of(leading_body.kind), hint()));
  }

  /// Finds the moving coordinates, their prescribed rates, and the outputs with prescribed values.
  void take(const SteadyRequest& request) {
    const TypedRequest typed = typed_request(c_, independent_, request);
    goals_ = typed.goals;
    inputs_ = typed.inputs;
    for (const auto& [coordinate, rate] : typed.rates) {
      if (rate) motion_.point.zd[static_cast<std::size_t>(coordinate)] = *rate;
      held_.push_back(coordinate);
    }
    for (const int i : independent_)
      if (is_held(i) || std::abs(motion_.point.zd[i]) > kMoves) travelling_.push_back(i);
    if (travelling_.empty()) {
      throw UserError(
          fmt::format("{}: nothing moves at the start; give a rate, --hold coordinate=rate, or use --at "
                      "equilibrium\n",
                      c_.model.file));
    }
    const auto slides = [&](int i) { return c_.topology.bodies[i].kind == FreedomKind::prismatic; };
    const auto first = std::find_if(travelling_.begin(), travelling_.end(), slides);
    leader_ = first != travelling_.end() ? *first : travelling_.front();
    rate_at_start_ = motion_.point.zd[leader_];
    if (held_.empty() && goals_.empty() && !request.solve.empty()) held_.push_back(leader_);
  }

  /// Finds the rotating coordinate; the translations across its axis rotate with it.
  void find_turning() {
    for (const TurningFrame& frame : turning_frames(c_.model, c_.topology, independent_)) {
      const auto& [first, second] = frame.across;
      if (!travels(frame.turning) && !travels(first) && !travels(second)) continue;
      if (!is_flat({first, second})) continue;
      yaw_ = frame.turning;
      motion_.across[0] = first;
      motion_.across[1] = second;
      for (const int i : {yaw_, first, second})
        if (!travels(i)) travelling_.push_back(i);
    }
  }

  /// Whether rates are independent of the position in a plane; otherwise they are not constant in the rotating frame.
  bool is_flat(const std::vector<int>& plane) const {
    const LinearSystem system = expect(linearise(c_, motion_.point));
    const Eigen::Index rates = system.A.rows() - position_count(system);
    const double largest = system.A.cwiseAbs().maxCoeff();
    return std::all_of(plane.begin(), plane.end(), [&](int p) {
      return system.A.col(row_of(p)).tail(rates).cwiseAbs().maxCoeff() <= kFlat * largest;
    });
  }

  /// Residual: rates of velocities and auxiliary states, then errors of the goals.
  Eigen::VectorXd residual(const LinearSystem& system) const {
    const Eigen::VectorXd rates = seen_turning(system.drift.tail(system.drift.size() - position_count(system)));
    if (goals_.empty()) return rates;
    const OperatingPoint& point = motion_.point;
    const GenericState state{point.z, point.zd, point.x, point.t};
    GenericDerivative derivative;
    const Status status = solver_.accelerations(state, std::vector<double>(point.z.size(), 0.0), derivative);
    return with_goals(rates, status, state, derivative);
  }

  /// Rates, then errors of the goals; not finite without accelerations.
  Eigen::VectorXd with_goals(const Eigen::VectorXd& rates, Status status, const GenericState& state,
                             const GenericDerivative& derivative) const {
    Eigen::VectorXd left(rates.size() + static_cast<Eigen::Index>(goals_.size()));
    left << rates, goal_errors(goals_, solver_, status, state, derivative);
    return left;
  }

  Eigen::VectorXd rates_of(const Eigen::VectorXd& left) const {
    return left.head(left.size() - static_cast<Eigen::Index>(goals_.size()));
  }

  /// The goal with the largest error, if that counts; -1: all are met.
  int missed(const Eigen::VectorXd& left) const {
    Eigen::Index worst = 0;
    if (goals_.empty()) return -1;
    const double error = left.tail(static_cast<Eigen::Index>(goals_.size())).cwiseAbs().maxCoeff(&worst);
    return error < kSteady ? -1 : static_cast<int>(worst);
  }

  /// Residual by the generic solver, without derivatives. Not finite if it has no accelerations.
  Eigen::VectorXd residual_here() const {
    const OperatingPoint& point = motion_.point;
    const GenericState state{point.z, point.zd, point.x, point.t};
    GenericDerivative rates;
    const auto moving = static_cast<Eigen::Index>(point.x.size()) - held_state_count(c_.model);
    const auto accelerations = static_cast<Eigen::Index>(independent_.size());
    Eigen::VectorXd left = Eigen::VectorXd::Constant(accelerations + moving, std::nan(""));
    const Status status = solver_.accelerations(state, std::vector<double>(point.z.size(), 0.0), rates);
    if (!status.ok()) return with_goals(left, status, state, rates);
    for (Eigen::Index i = 0; i < accelerations; ++i)
      left[i] = rates.zdd[static_cast<std::size_t>(independent_[static_cast<std::size_t>(i)])];
    for (Eigen::Index i = 0; i < moving; ++i) left[accelerations + i] = rates.xd[static_cast<std::size_t>(i)];
    return with_goals(seen_turning(std::move(left)), status, state, rates);
  }

  /// Rates in the rotating frame, for auxiliary states relative to their magnitudes.
  Eigen::VectorXd seen_turning(Eigen::VectorXd rates) const {
    Eigen::VectorXd left = share_of_magnitudes(std::move(rates));
    if (yaw_ < 0) return left;
    const double turn = motion_.point.zd[yaw_];
    left[row_of(motion_.across[0])] += turn * motion_.point.zd[motion_.across[1]];
    left[row_of(motion_.across[1])] -= turn * motion_.point.zd[motion_.across[0]];
    return left;
  }

  /// Accelerations, then rates of auxiliary states relative to their magnitudes.
  Eigen::VectorXd share_of_magnitudes(Eigen::VectorXd rates) const {
    auto place = static_cast<Eigen::Index>(independent_.size());
    for (const AuxiliaryState& state : auxiliary_states(c_.model))
      if (place < rates.size()) rates[place++] /= magnitude_of(state);
    return rates;
  }

  Eigen::Index row_of(int coordinate) const {
    return std::find(independent_.begin(), independent_.end(), coordinate) - independent_.begin();
  }

  int leading(const LinearSystem& system, const Eigen::VectorXd& left) const {
    Eigen::Index place = 0;
    left.head(static_cast<Eigen::Index>(independent_.size())).cwiseAbs().maxCoeff(&place);
    return system.states[static_cast<std::size_t>(place)].index;
  }

  /// Whether a state is unknown: positions of coordinates at rest, rates of moving ones, auxiliary states.
  bool is_unknown(const LinearState& state) const {
    if (state.kind == StateKind::position) return !travels(state.index) || state.index == heading_;
    return state.kind == StateKind::auxiliary || (travels(state.index) && !is_held(state.index));
  }

  /// d rates / d state, including the terms of the rotating frame.
  Eigen::VectorXd column(const LinearSystem& system, Eigen::Index j) const {
    Eigen::VectorXd result = share_of_magnitudes(system.A.col(j).tail(system.A.rows() - position_count(system)));
    const LinearState& state = system.states[static_cast<std::size_t>(j)];
    if (yaw_ < 0 || state.kind != StateKind::velocity) return result;
    const auto& [first, second] = motion_.across;
    const double turn = motion_.point.zd[yaw_];
    if (state.index == second) result[row_of(first)] += turn;
    if (state.index == first) result[row_of(second)] -= turn;
    if (state.index == yaw_) {
      result[row_of(first)] += motion_.point.zd[second];
      result[row_of(second)] -= motion_.point.zd[first];
    }
    return result;
  }

  /// Unknown states.
  std::vector<Eigen::Index> unknown_states(const LinearSystem& system) const {
    std::vector<Eigen::Index> unknown;
    for (Eigen::Index j = 0; j < system.A.cols(); ++j) {
      if (is_unknown(system.states[static_cast<std::size_t>(j)])) unknown.push_back(j);
    }
    return unknown;
  }

  /// d residual / d unknown: states, then inputs.
  Eigen::MatrixXd derivatives(const LinearSystem& system, const std::vector<Eigen::Index>& unknown) const {
    const auto states = static_cast<Eigen::Index>(unknown.size());
    const Eigen::Index rows = system.A.rows() - position_count(system),
                       goals = static_cast<Eigen::Index>(goals_.size());
    Eigen::MatrixXd matrix(rows + goals, states + static_cast<Eigen::Index>(inputs_.size()));
    for (Eigen::Index k = 0; k < states; ++k)
      matrix.col(k).head(rows) = column(system, unknown[static_cast<std::size_t>(k)]);
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      matrix.col(states + static_cast<Eigen::Index>(k)).head(rows) =
          share_of_magnitudes(system.B.col(inputs_[k]).tail(rows));
    }
    for (Eigen::Index g = 0; g < goals; ++g) {
      const int output = goals_[static_cast<std::size_t>(g)].output;
      for (Eigen::Index k = 0; k < states; ++k)
        matrix(rows + g, k) = system.C(output, unknown[static_cast<std::size_t>(k)]);
      for (std::size_t k = 0; k < inputs_.size(); ++k)
        matrix(rows + g, states + static_cast<Eigen::Index>(k)) = system.D(output, inputs_[k]);
    }
    return matrix;
  }

  /// One Newton step, shortened until the next simplified Newton correction is shorter. Source: P. Deuflhard, "Newton
  /// Methods for Nonlinear Problems", 2004: the natural monotonicity test, invariant under scaling of rows.
  void change(const LinearSystem& system, const Eigen::VectorXd& left) {
    const std::vector<Eigen::Index> unknown = unknown_states(system);
    const Eigen::MatrixXd matrix = derivatives(system, unknown);
    if (matrix.cols() == 0) fail(system, left);
    const ScaledSystem scaled_system(matrix, scales_rows_);
    const Eigen::VectorXd scaled = scaled_system.correction(left);
    const Eigen::VectorXd by = -scaled_system.unknowns(scaled);
    double longest = 0;
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      const bool is_position = system.states[static_cast<std::size_t>(unknown[k])].kind == StateKind::position;
      if (is_position) longest = std::max(longest, std::abs(by[static_cast<Eigen::Index>(k)]));
    }
    const double whole = shortening(longest, kLargestBalanceStep);
    const OperatingPoint before = motion_.point;
    for (double part = 1;; part /= 2) {
      const Status closed = apply(system, unknown, by * (part * whole));
      const Eigen::VectorXd next = closed.ok() ? residual_here() : Eigen::VectorXd::Constant(1, std::nan(""));
      const bool leads_nearer =
          next.allFinite() && scaled_system.correction(next).norm() <= (1 - part * whole / 4) * scaled.norm();
      if (leads_nearer || part <= kShortest) return require_closed(closed);
      motion_.point = before;
    }
  }

  /// Changes the unknowns, then closes the loops.
  Status apply(const LinearSystem& system, const std::vector<Eigen::Index>& unknown, const Eigen::VectorXd& by) {
    for (std::size_t k = 0; k < unknown.size(); ++k) move(system, unknown[k], by[static_cast<Eigen::Index>(k)]);
    for (std::size_t k = 0; k < inputs_.size(); ++k)
      motion_.point.inputs[static_cast<std::size_t>(inputs_[k])] += by[static_cast<Eigen::Index>(unknown.size() + k)];
    return close();
  }

  void move(const LinearSystem& system, Eigen::Index j, double by) {
    OperatingPoint& point = motion_.point;
    const LinearState& state = system.states[static_cast<std::size_t>(j)];
    if (state.kind == StateKind::auxiliary) point.x[static_cast<std::size_t>(state.index)] += by;
    if (state.kind == StateKind::velocity) point.zd[static_cast<std::size_t>(state.index)] += by;
    if (state.kind != StateKind::position) return;
    for (std::size_t i = 0; i < point.z.size(); ++i)
      point.z[i] += by * system.coordinates(static_cast<Eigen::Index>(i), j);
  }

  /// Closes the loops, makes the velocities consistent and sets the bristles of sliding contacts.
  Status close() {
    OperatingPoint& point = motion_.point;
    solver_.set_inputs(point.inputs);
    GenericState state{point.z, point.zd, point.x, point.t};
    const Status status = solver_.project(state);
    if (!status.ok()) return status;
    point.z = std::move(state.z);
    point.zd = std::move(state.zd);
    bristles_ = set_steady_bristles(c_.model, c_.topology, point);
    if (yaw_ >= 0) motion_.turning = point.zd[yaw_];
    return {};
  }

  void require_closed(Status status) const {
    if (!status.ok())
      throw UserError(fmt::format("{}: no steady motion found: {}\n", c_.model.file, describe(c_, status)));
  }

  /// Result of the search. Fails: UserError if a friction would exceed its limit.
  SteadyMotion finished(const LinearSystem& system) {
    require_holding(c_.model, motion_.point, bristles_);
    const std::vector<Eigen::Index> unknown = unknown_states(system);
    std::vector<SteadyChoice> choices;
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      const LinearState& state = system.states[static_cast<std::size_t>(unknown[k])];
      if (state.kind == StateKind::velocity)
        choices.push_back({k, "zd." + c_.topology.bodies[static_cast<std::size_t>(state.index)].coordinate, true});
    }
    for (std::size_t k = 0; k < inputs_.size(); ++k)
      choices.push_back({unknown.size() + k, c_.model.inputs[static_cast<std::size_t>(inputs_[k])].name, false});
    const Eigen::MatrixXd matrix = derivatives(system, unknown);
    motion_.free_directions = free_directions(matrix, choices);
    motion_.changes = changes_along(c_, system, motion_.point, motion_.turning, motion_.across);
    if (!goals_.empty()) motion_.by_goals = by_goals(system, unknown, matrix);
    return motion_;
  }

  /// d (states, inputs) / d goal, of the least change where some are undetermined.
  Eigen::MatrixXd by_goals(const LinearSystem& system, const std::vector<Eigen::Index>& unknown,
                           const Eigen::MatrixXd& matrix) const {
    const ScaledSystem scaled(matrix, true);
    const Eigen::Index goals = static_cast<Eigen::Index>(goals_.size()), states = system.A.cols();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(states + static_cast<Eigen::Index>(c_.model.inputs.size()), goals);
    for (Eigen::Index g = 0; g < goals; ++g) {
      const Eigen::VectorXd wanted = Eigen::VectorXd::Unit(matrix.rows(), matrix.rows() - goals + g);
      const Eigen::VectorXd by = scaled.unknowns(scaled.correction(wanted));
      for (std::size_t k = 0; k < unknown.size(); ++k) result(unknown[k], g) = by[static_cast<Eigen::Index>(k)];
      for (std::size_t k = 0; k < inputs_.size(); ++k)
        result(states + inputs_[k], g) = by[static_cast<Eigen::Index>(unknown.size() + k)];
    }
    return result;
  }

  std::string hint() const {
    const std::string leader = c_.topology.bodies[leader_].coordinate;
    if (c_.model.inputs.empty() || !inputs_.empty())
      return fmt::format("the rate of {} needs a drive against drag and rolling resistance", leader);
    return fmt::format("the rate of {} needs a drive: --solve NAME finds an input that drives or steers", leader);
  }

  const Compilation& c_;
  bool scales_rows_ = false;
  GenericSolver solver_;
  SteadyMotion motion_;
  std::vector<int> independent_, travelling_, held_;
  std::vector<int> inputs_;
  std::vector<BristleEnd> bristles_;  ///< at the point
  std::vector<OutputGoal> goals_;
  int yaw_ = -1, leader_ = -1;  ///< rotating coordinate; coordinate whose rate is the speed
  int heading_ = -1;            ///< rotating coordinate whose position is unknown
  double rate_at_start_ = 0;
};

}  // namespace

SteadyMotion steady_motion(const Compilation& compilation, const OperatingPoint& start, const SteadyRequest& request) {
  Compilation c = compilation;
  if (!c.directional) add_directional(c);
  try {
    return Search(c, start, request, false).find();
  } catch (const UserError&) {
    return Search(c, start, request, true).find();
  }
}

}  // namespace mbgen
