// Simbody's results for a mechanism: accelerations, reactions, motion.

#include <cmath>

#include "tests/system/oracle/simbody_system.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Vector3d;
using SimTK::MobilizedBody;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::Vec3;

Vector3d vector_of(const Vec3& v) { return {v[0], v[1], v[2]}; }

/// Sets the angles of a rod's universal joint (turns a about x, then b about y) so that it points to its far end, and
/// their rates likewise. Requires: the state of the tree is set and realised to velocity.
void lay_rod(SimbodySystem& s, const SimbodyRod& rod) {
  const MobilizedBody &from = s.body(rod.closure->from), &to = s.body(rod.closure->to);
  const Vec3 gap = to.findStationLocationInAnotherBody(s.state, rod.far_end, from) - rod.frame.p();
  const Vec3 d = ~rod.frame.R() * gap;
  const Vec3 rate = ~rod.frame.R() * to.findStationVelocityInAnotherBody(s.state, rod.far_end, from);
  const double across = d[1] * d[1] + d[2] * d[2], length = d.norm();
  const MobilizedBody& bar = s.mobilizers[rod.body];
  bar.setOneQ(s.state, 0, std::atan2(-d[1], d[2]));
  bar.setOneQ(s.state, 1, std::asin(d[0] / length));
  bar.setOneU(s.state, 0, (d[1] * rate[2] - d[2] * rate[1]) / across);
  const double length_rate = SimTK::dot(d, rate) / length;
  bar.setOneU(s.state, 1, (rate[0] - d[0] / length * length_rate) / std::sqrt(across));
}

/// The same wrench about another place: `from` minus the new place is `arm`.
Wrench shifted(const SpatialVec& wrench, const Vec3& arm) {
  return {vector_of(wrench[1]), vector_of(wrench[0] + arm % wrench[1])};
}

/// Wrench of a closure's constraints on a body, about a point of it.
Wrench constraint_wrench(const SimbodySystem& s, const std::vector<SimTK::Constraint>& constraints,
                         const MobilizedBody& body, const Vec3& station) {
  SpatialVec sum(Vec3(0), Vec3(0));
  for (const SimTK::Constraint& constraint : constraints) {
    const SimTK::Vector_<SpatialVec> forces = constraint.getConstrainedBodyForcesAsVector(s.state);
    for (SimTK::ConstrainedBodyIndex i(0); i < constraint.getNumConstrainedBodies(); ++i)
      if (constraint.getMobilizedBodyFromConstrainedBody(i).getMobilizedBodyIndex() == body.getMobilizedBodyIndex())
        sum -= forces[i];  // constraint forces stand on the left-hand side in Simbody
  }
  return shifted(sum, body.getBodyOriginLocation(s.state) - body.findStationLocationInGround(s.state, station));
}

/// The tree body that is the parent of all freedoms of a joint.
int parent_of_joint(const ReferenceMechanism& mechanism, int tree) {
  const int joint = mechanism.bodies[tree].joint;
  while (tree != kGround && mechanism.bodies[tree].joint == joint) tree = mechanism.bodies[tree].parent;
  return tree;
}

Wrench joint_wrench(const SimbodySystem& s, int tree, const SimTK::Vector_<SpatialVec>& on_children) {
  const ReferenceBody& body = s.mechanism.bodies[tree];
  const MobilizedBody& child = s.body(tree);
  const int to = body.reversed ? parent_of_joint(s.mechanism, tree) : tree;
  const Vec3 at = s.body(to).findStationLocationInGround(s.state, s.local(to, body.at_to));
  const Vec3 moving_frame = child.findStationLocationInGround(s.state, child.getOutboardFrame(s.state).p());
  const Wrench on_child = shifted(on_children[child.getMobilizedBodyIndex()], moving_frame - at);
  return body.reversed ? Wrench{-on_child.force, -on_child.moment} : on_child;
}

bool is_last_of_joint(const ReferenceMechanism& mechanism, std::size_t tree) {
  return tree + 1 == mechanism.bodies.size() || mechanism.bodies[tree + 1].joint != mechanism.bodies[tree].joint;
}

}  // namespace

ForeignState foreign_state(const SimbodySystem& s, const SimTK::State& at) {
  ForeignState result;
  result.t = at.getTime();
  for (const SimbodyCoordinate& c : s.coordinates) {
    result.z.push_back(c.sign * s.mobilizers[c.body].getOneQ(at, c.place));
    result.zd.push_back(c.sign * s.mobilizers[c.body].getOneU(at, c.place));
  }
  return result;
}

void set_state(SimbodySystem& s, const SimbodyState& at, Stage stage) {
  if (s.state.getTime() != at.t) s.state.setTime(at.t);
  s.state.updQ() = at.q;
  s.state.updU() = at.u;
  s.tau.setAllMobilityForces(s.state, at.force);
  s.system.realize(s.state, stage);
}

SimbodyState native_state(SimbodySystem& s, const ForeignState& at) {
  SimTK::Vector force(s.state.getNU(), 0.0);
  s.state.updQ() = 0;
  s.state.updU() = 0;
  for (std::size_t i = 0; i < s.coordinates.size(); ++i) {
    const SimbodyCoordinate& c = s.coordinates[i];
    const MobilizedBody& mobilizer = s.mobilizers[c.body];
    mobilizer.setOneQ(s.state, c.place, c.sign * at.z[i]);
    mobilizer.setOneU(s.state, c.place, c.sign * at.zd[i]);
    if (!at.tau.empty()) force[mobilizer.getFirstUIndex(s.state) + c.place] = c.sign * at.tau[i];
  }
  s.state.setTime(at.t);
  s.system.realize(s.state, Stage::Velocity);
  for (const SimbodyRod& rod : s.rods) {
    lay_rod(s, rod);
    s.system.realize(s.state, Stage::Velocity);
  }
  return {s.state.getQ(), s.state.getU(), force, at.t};
}

std::vector<double> SimbodyMechanism::accelerations(const ForeignState& state) {
  SimbodySystem& s = *system_;
  set_state(s, native_state(s, state), Stage::Acceleration);
  std::vector<double> zdd;
  for (const SimbodyCoordinate& c : s.coordinates)
    zdd.push_back(c.sign * s.mobilizers[c.body].getOneUDot(s.state, c.place));
  return zdd;
}

ForeignReactions SimbodyMechanism::reactions(const ForeignState& state) {
  SimbodySystem& s = *system_;
  set_state(s, native_state(s, state), Stage::Acceleration);
  SimTK::Vector_<SpatialVec> on_children;
  s.matter.calcMobilizerReactionForces(s.state, on_children);
  ForeignReactions result;
  for (std::size_t i = 0; i < s.mechanism.bodies.size(); ++i)
    result.joints.push_back(is_last_of_joint(s.mechanism, i) ? joint_wrench(s, static_cast<int>(i), on_children)
                                                             : Wrench{});
  for (std::size_t c = 0; c < s.constraints.size(); ++c) {
    const ReferenceClosure& closure = s.mechanism.closures[c];
    result.closures.push_back(
        constraint_wrench(s, s.constraints[c], s.body(closure.to), s.local(closure.to, closure.at_to)));
  }
  for (std::size_t m = 0; m < s.drives.size(); ++m) {
    const SimbodyCoordinate& c = s.coordinates[s.elements.motions[m].coordinate];
    const SimTK::ConstrainedUIndex place =
        s.drives[m].getConstrainedUIndex(s.state, SimTK::ConstrainedMobilizerIndex(0), SimTK::MobilizerUIndex(c.place));
    result.drives.push_back(-c.sign * s.drives[m].getConstrainedMobilityForcesAsVector(s.state)[place]);
  }
  return result;
}

std::vector<ForeignState> SimbodyMechanism::motion(const ForeignState& start, const std::vector<double>& times,
                                                   double accuracy) {
  SimbodySystem& s = *system_;
  set_state(s, native_state(s, start), Stage::Acceleration);
  SimTK::RungeKuttaMersonIntegrator integrator(s.system);
  integrator.setAccuracy(accuracy);
  integrator.setConstraintTolerance(accuracy);
  integrator.setAllowInterpolation(false);
  integrator.initialize(s.state);
  std::vector<ForeignState> result;
  for (const double t : times) {
    while (integrator.getTime() < t) integrator.stepTo(t);
    s.system.realize(integrator.getState(), Stage::Velocity);
    result.push_back(foreign_state(s, integrator.getState()));
  }
  return result;
}

void SimbodyMechanism::load(const std::vector<ForeignState>& states) {
  system_->loaded.clear();
  for (const ForeignState& state : states) system_->loaded.push_back(native_state(*system_, state));
}

void SimbodyMechanism::run(int repetitions) {
  for (int r = 0; r < repetitions; ++r)
    for (const SimbodyState& at : system_->loaded) set_state(*system_, at, Stage::Acceleration);
}

}  // namespace mbgen::foreign
