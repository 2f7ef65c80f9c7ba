#include "compiler/study/steady_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "compiler/algebra/dense.hpp"
#include "compiler/base/number.hpp"
#include "compiler/base/user_error.hpp"
#include "compiler/engines/engine.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/newton.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

using StateKind = LinearState::Kind;

constexpr double kMoves = 1e-9;        // rad/s or m/s: a coordinate that moves at the start
constexpr double kSteady = 1e-7;       // rad/s^2 or m/s^2
constexpr double kComesToRest = 0.05;  // of the speed at the start: below it the search has gone to standstill

/// A search for a steady motion.
class Search {
 public:
  Search(const Compilation& compilation, OperatingPoint start, const SteadyWish& wish)
      : c_(compilation), solver_(compilation.model, compilation.topology, compilation.analysis) {
    motion_.point = std::move(start);
    independent_ = free_coordinates(c_.topology, c_.analysis);
    take_rates(wish);
    take_inputs(wish);
    find_turning();
    for (const int i : independent_) {
      if (!travels(i)) motion_.point.zd[i] = 0;
    }
    close();
  }

  SteadyMotion find() {
    for (int step = 0; step < kSteadyIterations; ++step) {
      const LinearSystem system = expect(linearise(c_, motion_.point));
      const Eigen::VectorXd left = residual(system);
      motion_.largest = left.size() > 0 ? left.cwiseAbs().maxCoeff() : 0.0;
      leading_ = leading(system, left);
      if (std::abs(motion_.point.zd[leader_]) < kComesToRest * std::abs(rate_at_start_)) break;
      if (motion_.largest < kSteady) return motion_;
      change(system, left);
    }
    throw UserError(fmt::format("{}: no steady motion found: {} goes on to accelerate at {:.3g} {}/s^2\n  hint: {}\n",
                                c_.model.file, c_.topology.bodies[leading_].coordinate, motion_.largest,
                                unit_of(c_.topology.bodies[leading_].kind), hint()));
  }

 private:
  bool travels(int i) const { return std::find(travelling_.begin(), travelling_.end(), i) != travelling_.end(); }
  bool is_held(int i) const { return std::find(held_.begin(), held_.end(), i) != held_.end(); }

  /// Which coordinates move, and which of their rates are given.
  void take_rates(const SteadyWish& wish) {
    for (const std::string& assignment : wish.hold) {
      const std::size_t sign = assignment.find('=');
      const std::string name = assignment.substr(0, sign);
      const int i = find_coordinate(c_.topology, name);
      const bool is_independent = std::find(independent_.begin(), independent_.end(), i) != independent_.end();
      if (!is_independent) {
        throw UserError(
            fmt::format("--hold: \"{}\" is no independent coordinate of the model; mbgen inspect lists them\n", name));
      }
      if (sign != std::string::npos) motion_.point.zd[i] = parse_number(assignment.substr(sign + 1), "--hold: " + name);
      held_.push_back(i);
    }
    for (const int i : independent_) {
      if (is_held(i) || std::abs(motion_.point.zd[i]) > kMoves) travelling_.push_back(i);
    }
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
    if (held_.empty() && !wish.solve.empty()) held_.push_back(leader_);
  }

  void take_inputs(const SteadyWish& wish) {
    for (const std::string& name : wish.solve) {
      const auto found = std::find_if(c_.model.inputs.begin(), c_.model.inputs.end(),
                                      [&](const Input& input) { return input.name == name; });
      if (found == c_.model.inputs.end()) {
        std::vector<std::string_view> names;
        for (const Input& input : c_.model.inputs) names.push_back(input.name);
        const std::string near = did_you_mean(name, names);
        throw UserError(
            fmt::format("--solve: the model has no input \"{}\"{}{}\n", name, near.empty() ? "" : "; ", near));
      }
      inputs_.push_back(static_cast<int>(found - c_.model.inputs.begin()));
    }
  }

  /// A turning coordinate that only translations carry: those across its axis turn with it.
  void find_turning() {
    for (const int i : independent_) {
      const TreeBody& body = c_.topology.bodies[i];
      if (body.kind != FreedomKind::revolute) continue;
      std::vector<int> across;
      bool is_carried = true;
      for (int p = body.parent; p != kGround; p = c_.topology.bodies[p].parent) {
        const TreeBody& carrier = c_.topology.bodies[p];
        is_carried = is_carried && carrier.kind == FreedomKind::prismatic;
        const double along =
            carrier.axis[0] * body.axis[0] + carrier.axis[1] * body.axis[1] + carrier.axis[2] * body.axis[2];
        if (std::abs(along) < 1e-9) across.push_back(p);
      }
      const auto is_free = [&](int p) { return row_of(p) < static_cast<Eigen::Index>(independent_.size()); };
      if (!is_carried || across.size() != 2 || !std::all_of(across.begin(), across.end(), is_free)) continue;
      if (!travels(i) && !travels(across[0]) && !travels(across[1])) continue;
      if (!travels(i)) travelling_.push_back(i);
      yaw_ = i;
      const Vector3 &a = c_.topology.bodies[across[0]].axis, &b = c_.topology.bodies[across[1]].axis;
      const double triple = body.axis[0] * (a[1] * b[2] - a[2] * b[1]) + body.axis[1] * (a[2] * b[0] - a[0] * b[2]) +
                            body.axis[2] * (a[0] * b[1] - a[1] * b[0]);
      motion_.across[0] = across[triple > 0 ? 0 : 1];  // the second is a quarter turn ahead of the first
      motion_.across[1] = across[triple > 0 ? 1 : 0];
      for (const int p : across) {
        if (!travels(p)) travelling_.push_back(p);
      }
    }
  }

  /// Rates of velocities and auxiliary states that should vanish.
  Eigen::VectorXd residual(const LinearSystem& system) const {
    Eigen::VectorXd left = share_of_magnitudes(system.drift.tail(system.drift.size() - position_count(system)));
    if (yaw_ < 0) return left;
    const double turn = motion_.point.zd[yaw_];
    left[row_of(motion_.across[0])] += turn * motion_.point.zd[motion_.across[1]];
    left[row_of(motion_.across[1])] -= turn * motion_.point.zd[motion_.across[0]];
    return left;
  }

  /// Accelerations as they are, then rates of auxiliary states over what these count.
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

  /// Whether a state may be changed: positions of coordinates at rest, rates of moving ones, auxiliary states.
  bool is_unknown(const LinearState& state) const {
    if (state.kind == StateKind::position) return !travels(state.index);
    return state.kind == StateKind::auxiliary || (travels(state.index) && !is_held(state.index));
  }

  /// d residual / d state, with the terms of the turning.
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

  void change(const LinearSystem& system, const Eigen::VectorXd& left) {
    std::vector<Eigen::Index> unknown;
    for (Eigen::Index j = 0; j < system.A.cols(); ++j) {
      if (is_unknown(system.states[static_cast<std::size_t>(j)])) unknown.push_back(j);
    }
    const auto states = static_cast<Eigen::Index>(unknown.size());
    Eigen::MatrixXd matrix(left.size(), states + static_cast<Eigen::Index>(inputs_.size()));
    for (Eigen::Index k = 0; k < states; ++k) matrix.col(k) = column(system, unknown[static_cast<std::size_t>(k)]);
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      matrix.col(states + static_cast<Eigen::Index>(k)) =
          share_of_magnitudes(system.B.col(inputs_[k]).tail(left.size()));
    }
    // Columns of one size: inputs are torques as well as angles.
    const Eigen::VectorXd size = matrix.colwise().norm().transpose().cwiseMax(1e-12);
    const Eigen::VectorXd scaled = least_squares(matrix * size.cwiseInverse().asDiagonal(), left, kIndifferentShare);
    Eigen::VectorXd by = -(size.cwiseInverse().asDiagonal() * scaled);
    double longest = 0;
    for (Eigen::Index k = 0; k < states; ++k) {
      const bool is_position =
          system.states[static_cast<std::size_t>(unknown[static_cast<std::size_t>(k)])].kind == StateKind::position;
      if (is_position) longest = std::max(longest, std::abs(by[k]));
    }
    by *= shortening(longest, kLargestBalanceStep);
    for (Eigen::Index k = 0; k < states; ++k) move(system, unknown[static_cast<std::size_t>(k)], by[k]);
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      motion_.point.inputs[static_cast<std::size_t>(inputs_[k])] += by[states + static_cast<Eigen::Index>(k)];
    }
    close();
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

  /// Closes the loops and makes the velocities consistent.
  void close() {
    OperatingPoint& point = motion_.point;
    solver_.set_inputs(point.inputs);
    GenericState state{point.z, point.zd, point.x, point.t};
    const Status status = solver_.project(state);
    if (!status.ok()) {
      throw UserError(fmt::format("{}: no steady motion found: {}\n", c_.model.file, describe(c_, status)));
    }
    point.z = std::move(state.z);
    point.zd = std::move(state.zd);
    if (yaw_ >= 0) motion_.turning = point.zd[yaw_];
  }

  std::string hint() const {
    const std::string leader = c_.topology.bodies[leader_].coordinate;
    if (c_.model.inputs.empty() || !inputs_.empty()) {
      return fmt::format("the rate of {} needs a drive against drag and rolling resistance", leader);
    }
    return fmt::format("the rate of {} needs a drive: --solve NAME finds an input that drives or steers", leader);
  }

  const Compilation& c_;
  GenericSolver solver_;
  SteadyMotion motion_;
  std::vector<int> independent_, travelling_, held_;
  std::vector<int> inputs_;
  int yaw_ = -1, leader_ = -1;  ///< the coordinate that turns; the one whose rate is the speed
  int leading_ = 0;             ///< coordinate with the largest acceleration
  double rate_at_start_ = 0;
};

}  // namespace

SteadyMotion steady_motion(const Compilation& compilation, const OperatingPoint& start, const SteadyWish& wish) {
  return Search(compilation, start, wish).find();
}

std::string steady_text(const Compilation& compilation, const SteadyMotion& steady, const SteadyWish& wish) {
  constexpr double kStill = 1e-9;  // rad/s or m/s: rounding
  std::string text = fmt::format("steady motion, accelerations at most {:.1e}:\n", steady.largest);
  for (const int i : free_coordinates(compilation.topology, compilation.analysis)) {
    const TreeBody& body = compilation.topology.bodies[i];
    if (std::abs(steady.point.zd[i]) < kStill) continue;
    text += fmt::format("  {:<32}{:>16.9g} {}/s\n", "zd." + body.coordinate, steady.point.zd[i], unit_of(body.kind));
  }
  for (std::size_t i = 0; i < compilation.model.inputs.size(); ++i) {
    const Input& input = compilation.model.inputs[i];
    if (std::find(wish.solve.begin(), wish.solve.end(), input.name) == wish.solve.end()) continue;
    text += fmt::format("  {:<32}{:>16.9g} {}\n", input.name, steady.point.inputs[i], input.unit);
  }
  return text + "\n";
}

void settle_auxiliary(const Compilation& compilation, OperatingPoint& point) {
  const std::vector<AuxiliaryState> states = auxiliary_states(compilation.model);
  const auto count = static_cast<Eigen::Index>(point.x.size()) - held_state_count(compilation.model);
  Eigen::VectorXd size(count);
  for (Eigen::Index i = 0; i < count; ++i) size[i] = magnitude_of(states[static_cast<std::size_t>(i)]);
  for (int step = 0; step < kNewtonIterations && count > 0; ++step) {
    const LinearSystem system = expect(linearise(compilation, point));
    const Eigen::VectorXd left = system.drift.tail(count).cwiseQuotient(size);
    if (left.cwiseAbs().maxCoeff() < kSteady) return;
    const Eigen::MatrixXd matrix =
        size.cwiseInverse().asDiagonal() * system.A.bottomRightCorner(count, count) * size.asDiagonal();
    const Eigen::VectorXd by = least_squares(matrix, left, kIndifferentShare);
    for (Eigen::Index i = 0; i < count; ++i) point.x[static_cast<std::size_t>(i)] -= size[i] * by[i];
  }
}

LinearSystem turning_with(const SteadyMotion& motion, LinearSystem system) {
  if (motion.across[0] < 0) return system;
  const auto row_of = [&](StateKind kind, int coordinate) -> Eigen::Index {
    const auto is_it = [&](const LinearState& state) { return state.kind == kind && state.index == coordinate; };
    return std::find_if(system.states.begin(), system.states.end(), is_it) - system.states.begin();
  };
  for (const StateKind kind : {StateKind::position, StateKind::velocity}) {
    const Eigen::Index first = row_of(kind, motion.across[0]), second = row_of(kind, motion.across[1]);
    system.A(first, second) += motion.turning;
    system.A(second, first) -= motion.turning;
  }
  return system;
}

void mark_places(const SteadyMotion& motion, std::vector<Mode>& list) {
  constexpr double kSame = 1e-6;  // rad/s
  if (motion.across[0] < 0) return;
  for (Mode& mode : list) {
    const double off = std::abs(mode.eigenvalue - std::complex<double>(0, std::abs(motion.turning)));
    if (off > kSame) continue;
    mode.is_neutral = true;
    mode.is_unstable = false;
  }
  std::stable_partition(list.begin(), list.end(), [](const Mode& mode) { return !mode.is_neutral; });
}

}  // namespace mbgen
