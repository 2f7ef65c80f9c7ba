// Force elements as a custom force of Simbody, motions as its prescribed coordinates.

#include "tests/system/oracle/simbody_system.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Vector3d;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

Vec3 vec(const Vector3d& v) { return {v[0], v[1], v[2]}; }

/// All force elements of a system. Simbody owns it.
class Elements : public SimTK::Force::Custom::Implementation {
 public:
  explicit Elements(const SimbodySystem& system) : s_(system) {}

  void calcForce(const State& state, SimTK::Vector_<SpatialVec>& on_bodies, SimTK::Vector_<Vec3>&,
                 SimTK::Vector& on_coordinates) const override {
    const ForeignState at = foreign_state(s_, state);
    for (const LineElement& line : s_.elements.lines) add(line, at, state, on_bodies);
    for (const BodyLoad& load : s_.elements.loads) add(load, at, state, on_bodies);
    for (const CoordinateLoad& load : s_.elements.coordinates) {
      const SimbodyCoordinate& c = s_.coordinates[load.coordinate];
      s_.mobilizers[c.body].applyOneMobilityForce(state, c.place, c.sign * load.force(at), on_coordinates);
    }
  }
  SimTK::Real calcPotentialEnergy(const State&) const override { return 0; }

 private:
  void add(const LineElement& line, const ForeignState& at, const State& state,
           SimTK::Vector_<SpatialVec>& on_bodies) const {
    const SimTK::MobilizedBody &from = s_.body(line.from), &to = s_.body(line.to);
    const Vec3 on_from = s_.local(line.from, line.at_from), on_to = s_.local(line.to, line.at_to);
    const Vec3 gap = to.findStationLocationInGround(state, on_to) - from.findStationLocationInGround(state, on_from);
    const double length = gap.norm();
    const Vec3 along = gap / length;
    const double rate = SimTK::dot(
        along, to.findStationVelocityInGround(state, on_to) - from.findStationVelocityInGround(state, on_from));
    const Vec3 pull = line.tension(length, rate, at) * along;
    from.applyForceToBodyPoint(state, on_from, pull, on_bodies);
    to.applyForceToBodyPoint(state, on_to, -pull, on_bodies);
  }
  void add(const BodyLoad& load, const ForeignState& at, const State& state,
           SimTK::Vector_<SpatialVec>& on_bodies) const {
    const SimTK::MobilizedBody& body = s_.body(load.body);
    const auto in_ground = [&](const Vector3d& v) {
      return load.in_body_axes ? body.expressVectorInGroundFrame(state, vec(v)) : vec(v);
    };
    body.applyForceToBodyPoint(state, s_.local(load.body, load.at), in_ground(load.force(at)), on_bodies);
    body.applyBodyTorque(state, in_ground(load.torque(at)), on_bodies);
  }

  const SimbodySystem& s_;
};

/// A prescribed coordinate of Simbody: sign times that of the mechanism.
class Prescribed : public SimTK::Function {
 public:
  Prescribed(const PrescribedCoordinate& motion, double sign) : motion_(motion), sign_(sign) {}
  SimTK::Real calcValue(const SimTK::Vector& t) const override { return sign_ * motion_.motion(t[0])[0]; }
  SimTK::Real calcDerivative(const SimTK::Array_<int>& components, const SimTK::Vector& t) const override {
    return sign_ * motion_.motion(t[0]).at(components.size());
  }
  int getArgumentSize() const override { return 1; }
  int getMaxDerivativeOrder() const override { return 2; }

 private:
  const PrescribedCoordinate& motion_;
  double sign_;
};

}  // namespace

void add_elements(SimbodySystem& s) {
  if (!s.elements.lines.empty() || !s.elements.loads.empty() || !s.elements.coordinates.empty())
    SimTK::Force::Custom(s.forces, new Elements(s));
  for (const PrescribedCoordinate& motion : s.elements.motions) {
    const SimbodyCoordinate& c = s.coordinates[motion.coordinate];
    s.drives.push_back(SimTK::Constraint::PrescribedMotion(s.matter, new Prescribed(motion, c.sign),
                                                           s.mobilizers[c.body].getMobilizedBodyIndex(),
                                                           SimTK::MobilizerQIndex(c.place)));
  }
}

}  // namespace mbgen::foreign
