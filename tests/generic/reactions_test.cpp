// Newton's and Euler's laws for every body of every model in motion: what its joints, rods, springs, forces and tyres
// give it against the second differences of its positions.

#include "compiler/model/element_access.hpp"
#include "compiler/model/tyres.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using What = ReactionOutput::What;
using End = ReactionOutput::End;

/// Outputs that show the motion of a body of the model: its centre of mass and its axes as three more points.
struct BodyProbe {
  std::array<int, 4> position, velocity, acceleration;  ///< output of com, com + x, com + y, com + z
};

/// Outputs of a joint or rod; a rod's two forces act at different points.
struct ReactionProbe {
  Attachment to, from;
  int force_to, moment_to, force_from, moment_from;
  int point_to, point_from;  ///< outputs: where the wrench is about
};

/// A model with outputs for all that Newton's law needs. It has no forces by expressions, no friction in the ends of
/// rods, and tyres on flat roads without overturning moment and rolling resistance, which no output shows.
struct Probes {
  Model model;
  std::vector<BodyProbe> bodies;  ///< per Model::bodies
  std::vector<ReactionProbe> reactions;
  std::vector<std::array<int, 3>> springs;  ///< outputs: position of from and to, tension
  std::vector<Attachment> spring_from, spring_to;
  std::vector<int> force_at;                 ///< outputs: position, per Model::forces
  std::vector<std::array<int, 5>> tyres;     ///< outputs: position of the centre, load, fx, fy, mz
  std::vector<std::array<int, 3>> bushings;  ///< outputs: position of `to`, force and moment on it
  std::vector<std::array<int, 3>> stops;     ///< outputs: position of from and to, force; not of those on coordinates
};

int add_scalar(Model& model, const decltype(Output::source)& source) {
  model.outputs.push_back({"probe" + std::to_string(model.outputs.size()), {}, "", source});
  return static_cast<int>(model.outputs.size()) - 1;
}

void probe_body(Probes& p, int b) {
  const auto com = [&](int axis) {
    Vector3 place{};
    for (int i = 0; i < 3; ++i) place[i] = p.model.bodies[b].com[i].value + (i == axis ? 1.0 : 0.0);
    return place;
  };
  BodyProbe probe{};
  for (int k = 0; k < 4; ++k) {
    const Attachment point = add_point(p.model, b, com(k - 1));
    probe.position[k] = add_motion(p.model, point, PointOutput::What::position);
    probe.velocity[k] = add_motion(p.model, point, PointOutput::What::velocity);
    probe.acceleration[k] = add_motion(p.model, point, PointOutput::What::acceleration);
  }
  p.bodies.push_back(probe);
}

void probe_reaction(Probes& p, int joint, int rod, const Attachment& from, const Attachment& to) {
  const auto reaction = [&](What what, End end) { return add_reaction(p.model, joint, rod, what, end); };
  const auto position = [&](const Attachment& at) { return add_motion(p.model, at, PointOutput::What::position); };
  p.reactions.push_back({to, from, reaction(What::force, End::to), reaction(What::moment, End::to),
                         reaction(What::force, End::from), reaction(What::moment, End::from), position(to),
                         position(rod >= 0 ? from : to)});
}

template <class Spring>
void probe_springs(Probes& p, const std::vector<Spring>& springs) {
  for (std::size_t i = 0; i < springs.size(); ++i) {
    p.spring_from.push_back(springs[i].from);
    p.spring_to.push_back(springs[i].to);
    p.springs.push_back({add_motion(p.model, springs[i].from, PointOutput::What::position),
                         add_motion(p.model, springs[i].to, PointOutput::What::position),
                         add_scalar(p.model, output_of<Spring>("force", i))});
  }
}

/// Without the moments that no output shows, on a road whose contact is made again here.
void make_plain(Tyre& tyre) {
  tyre.road = -1;
  tyre.rolling_resistance = 0.0;
  const std::span<const TyreField> fields = tyre_fields(tyre.model);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string_view name = fields[i].name;
    // Of MF 6.1 also what has a rolling radius of its own.
    const bool of_radius = name.starts_with("Q_") || name == "PFZ1" || name.ends_with("REFF");
    if (name.starts_with("QSX") || name.starts_with("QSY") || of_radius)
      tyre.coefficients[i] = of_radius ? fields[i].default_value : 0.0;
  }
}

bool has_expression(const AppliedForce& applied) {
  const auto is_expression = [](const Quantity& q) { return q.expression >= 0; };
  return std::any_of(applied.force.begin(), applied.force.end(), is_expression) ||
         std::any_of(applied.torque.begin(), applied.torque.end(), is_expression);
}

Probes probes_of(Model model) {
  std::erase_if(model.forces, has_expression);
  model.rod_frictions.clear();
  model.ropes.clear();  // no output shows where these act: the judges compare reactions with them
  model.contacts.clear();
  model.outputs.clear();
  Probes p{std::move(model), {}, {}, {}, {}, {}, {}, {}, {}, {}};
  const Model plain = p.model;
  for (Tyre& tyre : p.model.tyres) make_plain(tyre);
  for (std::size_t b = 0; b < plain.bodies.size(); ++b) probe_body(p, static_cast<int>(b));
  for (std::size_t j = 0; j < plain.joints.size(); ++j)
    probe_reaction(p, static_cast<int>(j), -1, plain.joints[j].from, plain.joints[j].to);
  for (std::size_t r = 0; r < plain.rods.size(); ++r)
    probe_reaction(p, -1, static_cast<int>(r), plain.rods[r].from, plain.rods[r].to);
  probe_springs(p, plain.springs);
  probe_springs(p, plain.air_springs);
  for (const AppliedForce& force : plain.forces)
    p.force_at.push_back(add_motion(p.model, force.at, PointOutput::What::position));
  for (std::size_t t = 0; t < plain.tyres.size(); ++t) {
    const auto of = [&](const char* what) { return add_scalar(p.model, output_of<Tyre>(what, t)); };
    p.tyres.push_back({add_motion(p.model, plain.tyres[t].centre, PointOutput::What::position), of("load"),
                       of("longitudinal_force"), of("lateral_force"), of("aligning_moment")});
  }
  for (std::size_t b = 0; b < plain.bushings.size(); ++b) {
    const auto vector = [&](const char* what) { return add_vector(p.model, output_of<Bushing>(what, b)); };
    p.bushings.push_back(
        {add_motion(p.model, plain.bushings[b].to, PointOutput::What::position), vector("force"), vector("moment")});
  }
  for (std::size_t s = 0; s < plain.bump_stops.size(); ++s) {
    const BumpStop& stop = plain.bump_stops[s];
    if (stop.is_on_joint()) {  // a force of its joint
      p.stops.push_back({-1, -1, -1});
      continue;
    }
    p.stops.push_back({add_motion(p.model, stop.from, PointOutput::What::position),
                       add_motion(p.model, stop.to, PointOutput::What::position),
                       add_scalar(p.model, output_of<BumpStop>("force", s))});
  }
  return p;
}

/// Force and moment about a point in space.
struct Sum {
  Force force, moment;
  double size = 0;  ///< of all that was added: what rounding is relative to
  void add(const Force& f, const Force& arm, const Force& m = {}) {
    force = force + f;
    moment = moment + cross(arm, f) + m;
    size += norm(f) + norm(m);
  }
};

/// Sums over the bodies of a model at one state.
class EnergyBalance {
 public:
  EnergyBalance(const Probes& probes, const std::vector<double>& y)
      : p(probes), y_(y), sums(probes.model.bodies.size()) {
    for (const ReactionProbe& r : p.reactions) {
      act(r.to.body, at(r.force_to), at(r.point_to), at(r.moment_to));
      act(r.from.body, at(r.force_from), at(r.point_from), at(r.moment_from));
    }
    for (std::size_t i = 0; i < p.springs.size(); ++i) {
      const Force from = at(p.springs[i][0]), to = at(p.springs[i][1]), gap = to - from;
      const Force pull = (y_[p.springs[i][2]] / norm(gap)) * gap;
      act(p.spring_from[i].body, pull, from);
      act(p.spring_to[i].body, -pull, to);
    }
    for (std::size_t i = 0; i < p.force_at.size(); ++i) apply(p.model.forces[i], at(p.force_at[i]));
    for (std::size_t i = 0; i < p.tyres.size(); ++i) roll(p.model.tyres[i], p.tyres[i]);
    for (std::size_t i = 0; i < p.bushings.size(); ++i) press(p.model.bushings[i], p.bushings[i]);
    for (std::size_t i = 0; i < p.stops.size(); ++i) stop(p.model.bump_stops[i], p.stops[i]);
    for (std::size_t b = 0; b < sums.size(); ++b) {
      const Vector3Quantity& g = p.model.gravity;
      sums[b].add(p.model.bodies[b].mass.value * Force{g[0].value, g[1].value, g[2].value}, {});
    }
  }

  const Probes& p;

 private:
  const std::vector<double>& y_;
  Force at(int first) const { return vector_at(y_, first); }
  void act(int body, const Force& force, const Force& point, const Force& moment = {}) {
    sums[body].add(force, point - at(p.bodies[body].position[0]), moment);
  }
  Force axis(int body, int k) const { return at(p.bodies[body].position[k + 1]) - at(p.bodies[body].position[0]); }
  void apply(const AppliedForce& applied, const Force& point) {
    const auto global = [&](const Vector3Quantity& v) {
      if (!applied.in_body_axes) return Force{v[0].value, v[1].value, v[2].value};
      const int b = applied.at.body;
      return v[0].value * axis(b, 0) + v[1].value * axis(b, 1) + v[2].value * axis(b, 2);
    };
    act(applied.at.body, global(applied.force), point, global(applied.torque));
  }
  /// A direction that moves with a body, given in global axes at the reference.
  Force moved_along(int body, const Vector3& direction) const {
    const Matrix3& pose = p.model.bodies[body].pose.rotation;
    Force moved;
    for (int k = 0; k < 3; ++k) {
      double component = 0;
      for (int row = 0; row < 3; ++row) component += pose[3 * row + k] * direction[row];
      moved = moved + component * axis(body, k);
    }
    return moved;
  }
  /// A stop pushes its points apart or pulls them together, or pushes along its axis, both bodies at the point of `to`.
  void stop(const BumpStop& stop, const std::array<int, 3>& probe) {
    if (stop.is_on_joint()) return;
    const double sign = stop.side == BumpStop::Side::compression ? -1 : 1;
    const Force from = at(probe[0]), to = at(probe[1]), gap = to - from;
    const Force along = stop.axis ? moved_along(stop.from.body, *stop.axis) : (1 / norm(gap)) * gap;
    const Force push = sign * y_[probe[2]] * along;
    act(stop.from.body, push, stop.axis ? to : from);
    act(stop.to.body, -push, to);
  }
  /// A bushing's force and moment in its axes on `from`, counted as its freedoms are, both at the point of `to`.
  void press(const Bushing& bushing, const std::array<int, 3>& probe) {
    Force force, moment;
    for (int column = 0; column < 3; ++column) {
      const Force along =
          moved_along(bushing.from.body, {bushing.axes[column], bushing.axes[3 + column], bushing.axes[6 + column]});
      force = force + bushing_sense(bushing, column) * y_[probe[1] + column] * along;
      moment = moment + bushing_sense(bushing, 3 + column) * y_[probe[2] + column] * along;
    }
    act(bushing.to.body, force, at(probe[0]), moment);
    act(bushing.from.body, -force, at(probe[0]), -moment);
  }
  void roll(const Tyre& tyre, const std::array<int, 5>& probe) {
    const int b = tyre.centre.body;
    const Force spin = moved_along(b, tyre.axis);
    const Force up{0, 0, 1}, across = cross(spin, up), centre = at(probe[0]);
    const Force forward = (1 / norm(across)) * across, left = cross(up, forward), down = cross(spin, forward);
    // Negative where a random state has the centre below the road.
    const double loaded_radius = (tyre.road_height.value - centre.z) / down.z;
    const Force arm = loaded_radius * down;
    // The longitudinal force acts at the rolling radius, two thirds of the deflection below the contact (tyre.hpp).
    const double deflection = std::max(tyre.radius.value - loaded_radius, 0.0);
    const Force moment = y_[probe[4]] * up - (2 * deflection / 3 * y_[probe[2]]) * left;
    act(b, y_[probe[2]] * forward + y_[probe[3]] * left + y_[probe[1]] * up, centre + arm, moment);
  }

 public:
  std::vector<Sum> sums;  ///< per body, moments about its centre of mass
};

/// Rates of momentum and of angular momentum about the centre of mass, from the accelerations of a body's four points.
Sum momentum_rate(const Body& body, const std::array<Force, 4>& position, const std::array<Force, 4>& acceleration) {
  const auto j = [&](int k) { return body.inertia[k].value; };
  const double half = (j(0) + j(1) + j(2)) / 2;
  // Integral of r r' dm about the centre of mass, body axes.
  const double spread[3][3] = {{half - j(0), -j(3), -j(4)}, {-j(3), half - j(1), -j(5)}, {-j(4), -j(5), half - j(2)}};
  Sum rate;
  rate.add(body.mass.value * acceleration[0], {});
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      rate.add({}, {}, spread[r][c] * cross(position[r + 1] - position[0], acceleration[c + 1] - acceleration[0]));
  return rate;
}

/// Outputs a moment later or earlier on the parabola of the coordinates.
std::vector<double> outputs_after(const GenericSolver& solver, const GenericState& state,
                                  const std::vector<double>& tau, const GenericDerivative& derivative, double step) {
  GenericState moved = state;
  for (std::size_t i = 0; i < moved.z.size(); ++i)
    moved.z[i] += step * state.zd[i] + 0.5 * step * step * derivative.zdd[i];
  return solver.outputs(moved, tau, derivative).y;
}

class ReactionsOf : public ::testing::TestWithParam<std::string> {};

// Second differences of fourth order with steps of 0.25 ms keep seven digits of what happens in a second, shorter ones
// of what happens faster: rubber far from its rest.
TEST_P(ReactionsOf, NewtonAndEulerHoldForEveryBody) {
  const Probes probes = probes_of(load(GetParam()).model);
  const Mechanism m = analysed(probes.model);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const std::vector<GenericState> states = random_states(m, 2);
  ASSERT_FALSE(states.empty());
  for (const GenericState& state : states) {
    const std::vector<double> tau = random_tau(m, 23);
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
    const double h = std::min(2.5e-4, 0.02 / std::sqrt(1 + largest_absolute(derivative.zdd)));
    std::vector<std::vector<double>> y;
    for (int step = -2; step <= 2; ++step) y.push_back(outputs_after(solver, state, tau, derivative, step * h));
    const std::vector<double>& here = y[2];
    const EnergyBalance balance(probes, here);
    for (std::size_t b = 0; b < m.model.bodies.size(); ++b) {
      if (static_cast<int>(b) == m.model.ground) continue;
      std::array<Force, 4> position, acceleration, difference;
      for (int k = 0; k < 4; ++k) {
        const int at = probes.bodies[b].position[k];
        position[k] = vector_at(here, at);
        acceleration[k] = vector_at(here, probes.bodies[b].acceleration[k]);
        const auto moved = [&](int step) { return vector_at(y[2 + step], at) - position[k]; };
        difference[k] = (1 / (12 * h * h)) * (16.0 * (moved(1) + moved(-1)) - (moved(2) + moved(-2)));
      }
      const Body& body = m.model.bodies[b];
      const Sum &sum = balance.sums[b], rate = momentum_rate(body, position, acceleration),
                differences = momentum_rate(body, position, difference);
      const double scale = sum.size + rate.size + 1;
      EXPECT_LT(norm(sum.force - rate.force), 1e-11 * scale) << body.name;
      EXPECT_LT(norm(sum.moment - rate.moment), 1e-11 * scale) << body.name;
      EXPECT_LT(norm(sum.force - differences.force), 1e-7 * scale) << body.name;
      EXPECT_LT(norm(sum.moment - differences.moment), 1e-7 * scale) << body.name;
    }
  }
}

/// Angular velocity from the velocities of a body's four points.
Force angular_velocity(const std::vector<double>& y, const BodyProbe& probe) {
  Force twice;
  for (int k = 1; k < 4; ++k)
    twice = twice + cross(vector_at(y, probe.position[k]) - vector_at(y, probe.position[0]),
                          vector_at(y, probe.velocity[k]) - vector_at(y, probe.velocity[0]));
  return 0.5 * twice;
}

/// Power of a wrench about a point on a body.
double power(const std::vector<double>& y, const BodyProbe& probe, const Force& force, const Force& moment,
             const Force& point) {
  const Force spin = angular_velocity(y, probe);
  const Force velocity = vector_at(y, probe.velocity[0]) + cross(spin, point - vector_at(y, probe.position[0]));
  return dot(force, velocity) + dot(moment, spin);
}

/// Place among joints and then rods of what carries the forces on a joint's coordinates: forces on a rod's length go
/// through the rod.
std::size_t carrier_of(const Model& model, int joint) {
  for (std::size_t r = 0; r < model.rods.size(); ++r)
    if (model.rods[r].drive == joint) return model.joints.size() + r;
  return static_cast<std::size_t>(joint);
}

// Constraints do no work: what a joint's two sides do together is the power of its joint forces, nothing at a cut joint
// or a massless rod. This is what wrong multipliers would break. Motions, couplings and elements on coordinates are
// left out.
TEST_P(ReactionsOf, JointsDoTheWorkOfTheirJointForces) {
  Model plain = load(GetParam()).model;
  plain.joint_springs.clear();
  plain.frictions.clear();
  plain.joint_forces.clear();
  plain.bump_stops.clear();
  plain.motions.clear();
  plain.couplings.clear();
  std::erase_if(plain.outputs, [](const Output& output) {
    const auto* multiplier = std::get_if<MultiplierOutput>(&output.source);
    return multiplier != nullptr && multiplier->coupling >= 0;
  });
  const Probes probes = probes_of(plain);
  const Mechanism m = analysed(probes.model);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  for (const GenericState& state : random_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 29), y = outputs_at(solver, state, tau);
    for (std::size_t i = 0; i < probes.reactions.size(); ++i) {
      const ReactionProbe& r = probes.reactions[i];
      const bool is_rod = i >= m.model.joints.size();
      if (is_rod && m.model.rods[i - m.model.joints.size()].mass.value != 0) continue;  // its inertia takes a part
      const double on_to = power(y, probes.bodies[r.to.body], vector_at(y, r.force_to), vector_at(y, r.moment_to),
                                 vector_at(y, r.point_to)),
                   on_from = power(y, probes.bodies[r.from.body], vector_at(y, r.force_from),
                                   vector_at(y, r.moment_from), vector_at(y, r.point_from));
      double expected = 0, traffic = std::abs(on_to) + std::abs(on_from) + 1;
      for (int c = 0; c < m.topology.size(); ++c)
        if (carrier_of(m.model, m.topology.bodies[c].joint) == i) expected += tau[c] * state.zd[c];
      EXPECT_NEAR(on_to + on_from, expected, 1e-8 * traffic)
          << (is_rod ? m.model.rods[i - m.model.joints.size()].name : m.model.joints[i].name);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ReactionsOf, ::testing::ValuesIn(all_models()), test_name);

}  // namespace
}  // namespace mbgen
