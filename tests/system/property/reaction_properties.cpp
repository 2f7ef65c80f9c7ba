// Forces and moments that joints and rods of random mechanisms transmit: against the Cartesian judge, whose outputs are
// its own, and against the rates of momentum of every body.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/judges/cartesian.hpp"
#include "tests/support/reaction_support.hpp"
#include "tests/system/property/properties.hpp"

namespace mbgen::testing {
namespace {

using What = ReactionOutput::What;
using End = ReactionOutput::End;

/// Appends everything that is shown of every joint and rod.
void add_all_reactions(Model& model) {
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    for (const auto what : {What::force, What::moment})
      for (const auto end : {End::to, End::from})
        for (const bool in_body_axes : {false, true})
          add_vector(model, ReactionOutput{what, static_cast<int>(j), -1, 0, in_body_axes, end});
  for (std::size_t r = 0; r < model.rods.size(); ++r)
    for (const auto end : {End::to, End::from})
      for (const bool in_body_axes : {false, true})
        add_vector(model, ReactionOutput{What::force, -1, static_cast<int>(r), 0, in_body_axes, end});
  for (std::size_t k = 0; k < model.motions.size(); ++k)
    model.outputs.push_back({"drive" + std::to_string(k), {}, "", DriveOutput{static_cast<int>(k)}});
}

/// Of redundant equations everyone leaves out others; without them reactions are unique.
bool are_reactions_unique(const Mechanism& m) {
  return std::ranges::all_of(m.analysis.blocks,
                             [](const BlockAnalysis& block) { return block.redundant_equations.empty(); });
}

/// Kinetic energy and power. That of gravity has another zero for rods that stand on ground; momenta show it.
std::vector<double> balance_of(const GenericOutputs& outputs) {
  return {1.0, outputs.kinetic_energy, outputs.applied_power};
}

/// Outputs of the two ends of a joint or rod, and of the points where its forces act.
struct Connection {
  int to = 0, from = 0;  ///< bodies
  int on_to = 0, on_from = 0, moment_to = -1, moment_from = -1;
  int place_to = 0, place_from = 0;
};

/// A model that shows momentum, place and reactions of every body.
struct Balanced {
  Mechanism m;
  std::vector<int> momentum, turning, centre;  ///< outputs per body
  std::vector<Connection> connections;
};

Connection joint_of(Model& model, int joint) {
  const Attachment to = model.joints[joint].to, from = model.joints[joint].from;
  const auto reaction = [&](What what, End end) { return add_reaction(model, joint, -1, what, end); };
  const int place = add_motion(model, to, PointOutput::What::position);
  return {to.body,
          from.body,
          reaction(What::force, End::to),
          reaction(What::force, End::from),
          reaction(What::moment, End::to),
          reaction(What::moment, End::from),
          place,
          place};
}

Connection rod_of(Model& model, int rod) {
  const Attachment to = model.rods[rod].to, from = model.rods[rod].from;
  return {to.body,
          from.body,
          add_reaction(model, -1, rod, What::force, End::to),
          add_reaction(model, -1, rod, What::force, End::from),
          -1,
          -1,
          add_motion(model, to, PointOutput::What::position),
          add_motion(model, from, PointOutput::What::position)};
}

Balanced balanced(Model model) {
  Balanced result;
  model.outputs.clear();
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    const Vector3Quantity& com = model.bodies[b].com;
    const Attachment centre = add_point(model, b, {com[0].value, com[1].value, com[2].value});
    result.centre.push_back(add_motion(model, centre, PointOutput::What::position));
    MomentumOutput source{.what = MomentumOutput::What::momentum, .body = b};
    result.momentum.push_back(add_vector(model, source));
    source.what = MomentumOutput::What::angular_momentum;
    result.turning.push_back(add_vector(model, source));
  }
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    result.connections.push_back(joint_of(model, static_cast<int>(j)));
  for (std::size_t r = 0; r < model.rods.size(); ++r) result.connections.push_back(rod_of(model, static_cast<int>(r)));
  result.m = analysed(std::move(model));
  return result;
}

/// Outputs at times around the state on a way of its position, velocity and acceleration.
std::vector<double> outputs_near(const GenericSolver& solver, const GenericState& state, const std::vector<double>& tau,
                                 const GenericDerivative& rates, double s) {
  GenericState moved = state;
  for (std::size_t i = 0; i < moved.z.size(); ++i) {
    moved.z[i] += s * state.zd[i] + 0.5 * s * s * rates.zdd[i];
    moved.zd[i] += s * rates.zdd[i];
  }
  return solver.outputs(moved, tau, rates).y;
}

/// Forces on every body by joints, rods and weight, and rates of its momentum: N, N m about its centre.
struct Sums {
  std::vector<Force> force, moment;
  double size = 1;  ///< of the largest part

  Sums(const Balanced& b, const std::vector<double>& y) : force(b.centre.size()), moment(b.centre.size()) {
    const auto at = [&](int first) { return first < 0 ? Force{} : vector_at(y, first); };
    const auto act = [&](int body, const Force& f, const Force& place, const Force& turn) {
      force[body] = force[body] + f;
      moment[body] = moment[body] + turn + cross(place - at(b.centre[body]), f);
      size = std::max({size, norm(f), norm(turn)});
    };
    for (const Connection& c : b.connections) {
      act(c.to, at(c.on_to), at(c.place_to), at(c.moment_to));
      act(c.from, at(c.on_from), at(c.place_from), at(c.moment_from));
    }
    const Vector3Quantity& g = b.m.model.gravity;
    for (std::size_t body = 0; body < force.size(); ++body)
      force[body] = force[body] + b.m.model.bodies[body].mass.value * Force{g[0].value, g[1].value, g[2].value};
  }
};

/// Reactions and weight against rates of momentum by differences of fourth order.
Complaint momentum_disagrees(const Balanced& b, const GenericSolver& solver, const GenericState& state) {
  constexpr double kOfDifferences = 1e-6;
  const std::vector<double> tau = random_tau(b.m, 3);
  GenericDerivative rates;
  if (!solver.accelerations(state, tau, rates).ok()) return "generic refuses a state";
  const double h = std::min(2e-4, 0.01 / std::sqrt(1 + largest_absolute(rates.zdd)));
  const auto at = [&](double s) { return outputs_near(solver, state, tau, rates, s * h); };
  const std::vector<double> far_behind = at(-2), behind = at(-1), ahead = at(1), far_ahead = at(2);
  const auto rate = [&](int first) {
    const auto gap = [&](const auto& late, const auto& early) {
      return vector_at(late, first) - vector_at(early, first);
    };
    return (1 / (12 * h)) * (8.0 * gap(ahead, behind) - gap(far_ahead, far_behind));
  };
  const Sums sums(b, at(0));
  for (std::size_t body = 0; body < b.centre.size(); ++body) {
    if (static_cast<int>(body) == b.m.model.ground) continue;
    const double error =
        std::max(norm(sums.force[body] - rate(b.momentum[body])), norm(sums.moment[body] - rate(b.turning[body]))) /
        sums.size;
    if (!(error < kOfDifferences))
      return "what acts on " + b.m.model.bodies[body].name + " differs from its change of momentum by " +
             std::to_string(error) + " of the largest reaction";
  }
  return {};
}

}  // namespace

Complaint outputs_of_judges_disagree(const RandomMechanism&, const Mechanism& given) {
  Model model = given.model;
  const auto own = static_cast<std::ptrdiff_t>(model.outputs.size());
  add_all_reactions(model);
  const Mechanism m{std::move(model), given.topology, given.analysis};
  const GenericSolver generic(m.model, m.topology, m.analysis);
  const auto part = [&](const std::vector<double>& y, bool reactions) {
    return reactions ? std::vector<double>(y.begin() + own, y.end()) : std::vector<double>(y.begin(), y.begin() + own);
  };
  for (const GenericState& state : good_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 3);
    GenericDerivative derivative;
    if (!generic.accelerations(state, tau, derivative).ok()) return "generic refuses a state";
    const GenericOutputs ours = generic.outputs(state, tau, derivative);
    for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::maggi}) {
      const CartesianSolver judge(m.model, m.topology, method, Stabilisation::projection);
      GenericOutputs theirs;
      if (!judge.outputs(state, tau, theirs).ok()) return "a Cartesian judge refuses a state";
      if (const Complaint c = differ("an output", part(ours.y, false), part(theirs.y, false), kTolerance)) return c;
      if (are_reactions_unique(m))
        if (const Complaint c = differ("a reaction", part(ours.y, true), part(theirs.y, true), kTolerance)) return c;
      if (const Complaint c = differ("the energy balance", balance_of(ours), balance_of(theirs), kTolerance)) return c;
    }
  }
  return {};
}

Complaint reactions_do_not_move_bodies(const RandomMechanism& random, const Mechanism&) {
  RandomMechanism bare = random;  // without forces that no joint or rod transmits
  std::erase_if(bare.links, [](const RandomLink& link) { return link.stiffness > 0; });
  bare.bushings.clear();
  bare.contacts.clear();
  const Result<Mechanism> understood_bare = understood(bare);
  if (!understood_bare) return {};
  const Balanced b = balanced(understood_bare->model);
  const GenericSolver solver(b.m.model, b.m.topology, b.m.analysis);
  for (const GenericState& state : good_states(b.m, 2))
    if (const Complaint c = momentum_disagrees(b, solver, state)) return c;
  return {};
}

}  // namespace mbgen::testing
