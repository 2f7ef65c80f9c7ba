#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/formulation/elements/bristle_ends.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/solver/newton.hpp"
#include "runtime/generic/balance.hpp"

namespace mbgen {
namespace {

constexpr double kIndifferent = 1e-7;    // kIndifferentShare for a stiffness, which differences give to seven digits
constexpr double kBalanced = 1e-3;       // rad/s^2 or m/s^2: accelerations below it are left to Newton's steps alone
constexpr double kSettledStates = 1e-8;  // of their magnitudes: states of the user's own that differences resolve
constexpr double kStandStill = 1e-6;     // 1/s: rates of states over their magnitudes, below which they stand still
constexpr double kFarthestState = 10;    // magnitudes: a state that its slope would send farther is led by its rate,
constexpr double kStateStep = 0.3;       // by so much in a step
constexpr double kGrowth = 2;            // of the rates of states in a step
constexpr int kMostHalvings = 8;
constexpr double kOfSlips = 0.5;        // part of slips in a direction beyond which it is no place of the bodies
constexpr double kStiff = 1e8;          // 1/s^2: beams are stiffer, and would make springs look indifferent beside them
constexpr double kCounted = 1e6;        // 1/s^2, as which they count
constexpr double kLongestReturn = 0.3;  // rad or m: a step back to a start that the search left
constexpr double kSlipReach = 0.1;      // m: a slip deflection of this size counts as much as a unit of a coordinate

/// Whether the search goes downhill, or straight to where the forces balance, which need not hold the bodies there.
enum class Search { downhill, straight };

/// The linearised balance in units in which inertias, rates of states and all unknowns count alike.
struct WeightedBalance {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd wanted;
  Eigen::VectorXd reach;  ///< of the unknowns: a unit of the solution moves one so far
  Eigen::VectorXd drag;   ///< of a drag on the inertias, in the matrix
  double unit = 1;
};

WeightedBalance weighted(const Balance& b, const Eigen::MatrixXd& stiffness) {
  WeightedBalance w;
  const Eigen::Index free = b.rz.cols();
  const Eigen::Index states = b.force.size() - free;
  const Eigen::VectorXd scale = effective_inertia(b).cwiseSqrt().cwiseInverse();
  w.unit = free > 0 ? scale.minCoeff() : 1;
  w.reach = Eigen::VectorXd::Constant(stiffness.cols(), kSlipReach);
  w.reach.head(free) = scale / w.unit;
  w.reach.tail(states).setOnes();
  // Rates of states count as much as accelerations, whatever their units.
  Eigen::VectorXd weight(b.force.size());
  weight.head(free) = scale;
  const auto size_of_row = [&](Eigen::Index row) {
    return stiffness.row(row).cwiseProduct(w.reach.transpose()).norm();
  };
  double largest = 0;
  for (Eigen::Index i = 0; i < free; ++i) largest = std::max(largest, scale[i] * size_of_row(i));
  for (Eigen::Index i = free; i < free + states; ++i)
    weight[i] = (largest > 0 ? largest : 1) / std::max(size_of_row(i), 1e-300);
  w.drag = Eigen::VectorXd::Ones(free);
  for (Eigen::Index i = 0; i < free; ++i) {
    const double square = std::abs(scale[i] * scale[i] * stiffness(i, i));
    if (!(square > kStiff)) continue;
    const double share = std::sqrt(kCounted / square);
    weight[i] *= share;
    w.reach[i] *= share;
    w.drag[i] = share * share;
  }
  w.matrix = weight.asDiagonal() * stiffness * w.reach.asDiagonal();
  w.wanted = -(weight.asDiagonal() * b.force);
  return w;
}

/// Largest rate of a state over its magnitude, 1/s.
double fastest_state(const Balance& b) {
  const Eigen::Index states = b.force.size() - b.rz.cols();
  return states == 0 ? 0 : b.force.tail(states).cwiseAbs().maxCoeff();
}

/// A drag on states whose rates hardly change with any unknown, as where a law saturates: there they follow their
/// rates. Source: as next_change.
void lead_states(const Balance& b, Eigen::MatrixXd& stiffness) {
  const Eigen::Index free = b.rz.cols(), states = b.force.size() - free;
  for (Eigen::Index i = 0; i < states; ++i) {
    const double rate = std::abs(b.force[free + i]);
    if (rate > kStandStill && rate > kFarthestState * stiffness.row(free + i).cwiseAbs().maxCoeff())
      stiffness(free + i, stiffness.cols() - states + i) -= rate / kStateStep;
  }
}

/// The next change of the unknowns: of all that balance the linearised forces the smallest. Far from balance a drag on
/// the inertias joins the stiffness: where nothing holds the bodies they sink no further than kLargestBalanceStep, and
/// they go downhill. It fades with the unbalanced acceleration (1/s^2 or m/s^2), so that the end is Newton's. Source:
/// C. T. Kelley, D. E. Keyes, "Convergence Analysis of Pseudo-Transient Continuation", SIAM J. Numer. Anal. 35(2),
/// 1998, with the drag of switched evolution relaxation.
Eigen::VectorXd next_change(const Balance& b, const Eigen::MatrixXd& stiffness, double unbalanced, Search search) {
  WeightedBalance w = weighted(b, stiffness);
  if (search == Search::downhill && unbalanced > kBalanced)
    w.matrix.leftCols(b.rz.cols()).diagonal() -= unbalanced / (kLargestBalanceStep * w.unit) * w.drag;
  return w.reach.asDiagonal() * least_squares(w.matrix, w.wanted, kIndifferent);
}

/// Largest change of a coordinate, rad or m.
double longest_move(const Balance& b, const Eigen::VectorXd& change) {
  return b.rz.cols() == 0 ? 0 : (b.rz * change.head(b.rz.cols())).cwiseAbs().maxCoeff();
}

/// Largest change of a state of the user's own, in parts of its magnitude.
double longest_of_states(const Balance& b, const Eigen::VectorXd& change) {
  const Eigen::Index states = b.force.size() - b.rz.cols();
  return states == 0 ? 0 : change.tail(states).cwiseAbs().maxCoeff();
}

/// Moves a state and its balance as `moved`, with shorter steps of the states as long as their rates grow: laws that
/// saturate send them back and forth.
Status move_guarded(const GenericSolver& solver, GenericEquations& equations, Eigen::VectorXd change,
                    GenericState& state, Balance& here) {
  const Eigen::Index states = here.force.size() - here.rz.cols();
  const double most = std::max(kGrowth * fastest_state(here), kStandStill);
  for (int halvings = 0;; ++halvings) {
    GenericState next;
    if (const Status status = moved(solver, equations, state, here, change, next); !status.ok()) return status;
    Balance there = balance(equations, next);
    if (states == 0 || halvings == kMostHalvings || fastest_state(there) <= most) {
      state = std::move(next);
      here = std::move(there);
      return {};
    }
    change.tail(states) /= 2;
  }
}

/// Walks from a state at rest to a balance; `trial` is the last state that was tried.
Status walk_to_balance(const GenericSolver& solver, GenericEquations& equations, const Pinned& pinned, Search search,
                       int most_steps, GenericState& trial) {
  Balance here = balance(equations, trial);
  if (here.force.size() == 0) return {};
  for (int step = 0;; ++step) {
    const double unbalanced = unbalanced_acceleration(here);
    Eigen::MatrixXd stiffness;
    if (const Status status = stiffness_at(solver, equations, trial, here, pinned, stiffness); !status.ok())
      return status;
    lead_states(here, stiffness);
    Eigen::VectorXd change = next_change(here, stiffness, unbalanced, search);
    if (!change.allFinite()) return {Code::not_a_number, -1};
    const double longest = longest_move(here, change), of_states = longest_of_states(here, change);
    const bool is_still = longest < kRoundingStep && of_states < kSettledStates;
    if (is_still && unbalanced < kBalanced) return {};
    const bool is_stuck = is_still && change.tail(change.size() - here.rz.cols()).isZero(kRoundingStep);
    if (is_stuck || step + 1 == most_steps) return {Code::no_equilibrium, -1};
    change *= shortening(longest, kLargestBalanceStep);
    if (const Status status = move_guarded(solver, equations, std::move(change), trial, here); !status.ok())
      return status;
  }
}

/// Turns and bristles: bent at rest they would bear any load.
Pinned straight_states(const Model& model) {
  Pinned pinned(static_cast<std::size_t>(auxiliary_state_count(model)), false);
  std::fill(pinned.begin() + first_turn(model), pinned.begin() + slip_state_count(model), true);
  return pinned;
}

/// Pins bristles that bend farther than they can at their end. Result: whether there were none.
bool all_hold(const std::vector<BristleHold>& holds, Pinned& pinned, std::vector<double>& x) {
  bool hold_all = true;
  for (const BristleHold& hold : holds) {
    if (pinned[hold.first]) continue;
    double square = 0;
    for (std::size_t i = hold.first; i < hold.first + hold.count; ++i) square += x[i] * x[i];
    const double bent = std::sqrt(square);
    if (bent <= hold.limit) continue;
    for (std::size_t i = hold.first; i < hold.first + hold.count; ++i) x[i] *= hold.limit / bent, pinned[i] = true;
    hold_all = false;
  }
  return hold_all;
}

/// Walks to where bristles that stick hold the bodies near `trial`. A bristle that would have to bend farther than it
/// can slides: it stays at its end, and the others go on.
Status walk_to_hold(const GenericSolver& solver, GenericEquations& equations, GenericState& trial) {
  const auto holds_at = [&](const GenericState& state) {
    System<double>& system = equations.system(state);
    const Kinematics<double> k = kinematics(system);
    return bristle_holds(system, k, velocities(system, k));
  };
  Pinned pinned = straight_states(equations.model);
  std::vector<BristleHold> holds = holds_at(trial);
  for (const BristleHold& hold : holds)
    std::fill_n(pinned.begin() + static_cast<std::ptrdiff_t>(hold.first), hold.count, !hold.bears);
  if (std::ranges::none_of(holds, &BristleHold::bears)) return {Code::no_equilibrium, -1};
  for (std::size_t round = 0; round <= holds.size(); ++round) {
    const Status status = walk_to_balance(solver, equations, pinned, Search::straight, kStraightIterations, trial);
    if (!status.ok()) return status;
    holds = holds_at(trial);
    if (all_hold(holds, pinned, trial.x)) return {};
  }
  return {Code::no_equilibrium, -1};
}

/// The same where reactions press frictions: these follow from the rest, and the rest from them.
Status hold_pressed(const GenericSolver& solver, GenericEquations& equations, GenericState& trial) {
  constexpr int kMostTurns = 20;
  constexpr double kPressed = 1e-9;  // of a reaction
  if (!takes_reactions(equations.model)) return walk_to_hold(solver, equations, trial);
  const auto first = static_cast<std::size_t>(first_sampled_value(equations.model));
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const std::vector<double> before = trial.x;
    if (const Status status = solver.set_friction_loads(trial); !status.ok()) return status;
    bool has_settled = turn > 0;
    for (std::size_t i = first; i < trial.x.size(); ++i)
      has_settled = has_settled && std::abs(trial.x[i] - before[i]) <= kPressed * std::max(1.0, std::abs(before[i]));
    if (const Status status = walk_to_hold(solver, equations, trial); has_settled || !status.ok()) return status;
  }
  return {Code::no_equilibrium, -1};
}

/// Directions of the unknowns along which the forces do not change, in the units of the weighted balance, and the free
/// directions by whose values one tells where they are.
struct Indifferent {
  Eigen::MatrixXd directions;        ///< unknowns x directions
  std::vector<Eigen::Index> places;  ///< one free direction for each
};

/// Directions that move coordinates more than slips: slips that strain a suspension against itself are no places.
/// Requires: there are free directions.
Indifferent indifferent_places(const WeightedBalance& w, Eigen::Index free, const Pinned& pinned) {
  std::vector<Eigen::Index> moving;
  for (Eigen::Index u = 0; u < w.matrix.cols(); ++u)
    if (u < free || !pinned[static_cast<std::size_t>(u - free)]) moving.push_back(u);
  const Eigen::MatrixXd still = mbgen::indifferent_directions(w.matrix(Eigen::all, moving), kIndifferent);
  Indifferent result;
  if (still.cols() == 0) return result;
  Eigen::MatrixXd chosen = still;
  if (still.rows() > free) {
    const auto [shares, vectors] = right_singular_vectors(still.bottomRows(still.rows() - free));
    const auto slips = std::count_if(shares.begin(), shares.end(), [](double share) { return share > kOfSlips; });
    chosen = still * vectors.rightCols(vectors.cols() - slips);
  }
  if (chosen.cols() == 0) return result;
  result.directions = Eigen::MatrixXd::Zero(w.matrix.cols(), chosen.cols());
  result.directions(moving, Eigen::all) = chosen;
  for (const int place : leading_columns(chosen.topRows(free).transpose(), kIndifferentShare))
    result.places.push_back(place);
  return result;
}

/// Brings free directions of which the balance leaves open where they are back to where they were at the start: on
/// their way bodies are pushed about by forces that are gone at its end. Leaves `found` where that fails.
void keep_indifferent(const GenericSolver& solver, GenericEquations& equations, const Pinned& pinned,
                      const GenericState& start, GenericState& found) {
  const std::vector<int> coordinates = free_coordinates(equations.topology, equations.analysis);
  GenericState trial = found;
  std::vector<Eigen::Index> places;
  for (int step = 0; step < kStraightIterations; ++step) {
    const Balance here = balance(equations, trial);
    Eigen::MatrixXd stiffness;
    if (here.rz.cols() == 0 || !stiffness_at(solver, equations, trial, here, pinned, stiffness).ok()) return;
    const WeightedBalance w = weighted(here, stiffness);
    const Indifferent open = indifferent_places(w, here.rz.cols(), pinned);
    if (step == 0) places = open.places;
    if (places.empty() || open.directions.cols() != static_cast<Eigen::Index>(places.size())) return;
    Eigen::VectorXd change = least_squares(w.matrix, w.wanted, kIndifferent);
    Eigen::VectorXd back(open.directions.cols());
    for (Eigen::Index i = 0; i < back.size(); ++i) {
      const Eigen::Index u = places[static_cast<std::size_t>(i)];
      const auto z = static_cast<std::size_t>(coordinates[static_cast<std::size_t>(u)]);
      back[i] = (start.z[z] - trial.z[z]) / w.reach[u] - change[u];
    }
    change += open.directions * solved(open.directions(places, Eigen::all), back);
    change = w.reach.asDiagonal() * change;
    if (!change.allFinite()) return;
    const double longest = longest_move(here, change);
    const bool is_still = longest < kRoundingStep && longest_of_states(here, change) < kSettledStates;
    if (is_still && unbalanced_acceleration(here) < kBalanced) {
      for (const Eigen::Index u : places) {
        const auto z = static_cast<std::size_t>(coordinates[static_cast<std::size_t>(u)]);
        trial.z[z] = start.z[z];  // to the last digit
      }
      if (brought_to_rest(solver, trial).ok()) found = std::move(trial);
      return;
    }
    change *= shortening(longest, kLongestReturn);
    GenericState next;
    if (!moved(solver, equations, trial, here, change, next).ok()) return;
    trial = std::move(next);
  }
}

}  // namespace

Status GenericSolver::equilibrium(GenericState& state) const {
  GenericState start = state;
  std::fill(start.zd.begin(), start.zd.end(), 0.0);
  const auto x = start.x.begin();  // turns and bristles straight, Maxwell branches relaxed
  std::fill(x + first_turn(equations_->model), x + first_user_state(equations_->model), 0.0);
  if (const Status status = brought_to_rest(*this, start); !status.ok()) return status;
  GenericState found = start;
  const Pinned straight = straight_states(equations_->model);
  Status status = walk_to_balance(*this, *equations_, straight, Search::downhill, kBalanceIterations, found);
  const auto look_near = [&](const auto& walk) {
    if (GenericState near = start; !status.ok() && walk(near).ok()) {
      found = std::move(near);
      status = {};
    }
  };
  look_near([&](GenericState& near) { return hold_pressed(*this, *equations_, near); });
  look_near([&](GenericState& near) {
    return walk_to_balance(*this, *equations_, straight, Search::straight, kStraightIterations, near);
  });
  if (status.ok()) keep_indifferent(*this, *equations_, straight, start, found);
  state = std::move(found);
  return status;
}

}  // namespace mbgen
