// Force elements as a custom force of Simbody, motions as its prescribed coordinates.

#include "tests/system/oracle/simbody_system.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Vector3d;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

SimTK::Rotation rotation(const Eigen::Matrix3d& m) {
  return SimTK::Rotation(SimTK::Mat33(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)));
}

/// Angular velocity is this times the rate of the rotation vector.
SimTK::Mat33 spin_of_rate(const Vec3& theta) {
  const double angle = theta.norm();
  const SimTK::Mat33 cross = SimTK::crossMat(theta);
  const double first = angle < 1e-4 ? 0.5 : (1 - std::cos(angle)) / (angle * angle);
  const double second = angle < 1e-2 ? 1.0 / 6 - angle * angle / 120 : (angle - std::sin(angle)) / std::pow(angle, 3);
  return SimTK::Mat33(1) + first * cross + second * cross * cross;
}

/// All force elements of a system. Simbody owns it.
class Elements : public SimTK::Force::Custom::Implementation {
 public:
  explicit Elements(const SimbodySystem& system) : s_(system) {}

  void calcForce(const State& state, SimTK::Vector_<SpatialVec>& on_bodies, SimTK::Vector_<Vec3>&,
                 SimTK::Vector& on_coordinates) const override {
    const ForeignState at = foreign_state(s_, state);
    for (const LineElement& line : s_.elements.lines) add(line, at, state, on_bodies);
    for (const FrameElement& element : s_.elements.frames) add(element, at, state, on_bodies);
    for (const BodyLoad& load : s_.elements.loads) add(load, at, state, on_bodies);
    for (const CoordinateLoad& load : s_.elements.coordinates) {
      const SimbodyCoordinate& c = s_.coordinates[load.coordinate];
      s_.mobilizers[c.body].applyOneMobilityForce(state, c.place, c.sign * load.force(at), on_coordinates);
    }
  }
  SimTK::Real calcPotentialEnergy(const State&) const override { return 0; }

 private:
  void add(const FrameElement& element, const ForeignState& at, const State& state,
           SimTK::Vector_<SpatialVec>& on_bodies) const {
    const SimTK::MobilizedBody &from = s_.body(element.from), &to = s_.body(element.to);
    const Vec3 on_from = s_.local(element.from, element.at_from), on_to = s_.local(element.to, element.at_to);
    const SimTK::Rotation axes = rotation(element.axes);
    const SimTK::Rotation now = from.getBodyRotation(state) * axes;
    const SimTK::Rotation turn = ~now * to.getBodyRotation(state) * axes;
    const SimTK::Vec4 angle_axis = turn.convertRotationToAngleAxis();
    const Vec3 theta = angle_axis[0] * angle_axis.getSubVec<3>(1);
    const SimTK::Mat33 rate_of_spin = spin_of_rate(theta).invert();
    const Vec3 place = to.findStationLocationInGround(state, on_to);
    const Vec3 gap = place - from.findStationLocationInGround(state, on_from);
    const Vec3 spin = from.getBodyAngularVelocity(state);
    const Vec3 drift = to.findStationVelocityInGround(state, on_to) - from.findStationVelocityInGround(state, on_from) -
                       SimTK::cross(spin, gap);
    const Vec3 shift = ~now * gap, shift_rate = ~now * drift;
    const Vec3 theta_rate = rate_of_spin * (~now * (to.getBodyAngularVelocity(state) - spin));
    const std::array<double, 6> f =
        element.forces({shift[0], shift[1], shift[2], theta[0], theta[1], theta[2]},
                       {shift_rate[0], shift_rate[1], shift_rate[2], theta_rate[0], theta_rate[1], theta_rate[2]}, at);
    const Vec3 force = now * Vec3(f[0], f[1], f[2]), moment = now * (~rate_of_spin * Vec3(f[3], f[4], f[5]));
    from.applyForceToBodyPoint(state, from.findStationAtGroundPoint(state, place), force, on_bodies);
    from.applyBodyTorque(state, moment, on_bodies);
    to.applyForceToBodyPoint(state, on_to, -force, on_bodies);
    to.applyBodyTorque(state, -moment, on_bodies);
  }
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
  for (const LinearFrameElement& linear : s.elements.linear_frames) {
    const FrameElement& f = linear.frames;
    const SimTK::Rotation axes = rotation(f.axes);
    const auto rotations_first = [](const std::array<double, 6>& v) {
      return SimTK::Vec6(v[3], v[4], v[5], v[0], v[1], v[2]);
    };
    SimTK::Force::LinearBushing(s.forces, s.body(f.from), SimTK::Transform(axes, s.local(f.from, f.at_from)),
                                s.body(f.to), SimTK::Transform(axes, s.local(f.to, f.at_to)),
                                rotations_first(linear.stiffness), rotations_first(linear.damping));
  }
  if (!s.elements.lines.empty() || !s.elements.frames.empty() || !s.elements.loads.empty() ||
      !s.elements.coordinates.empty())
    SimTK::Force::Custom(s.forces, new Elements(s));
  for (const PrescribedCoordinate& motion : s.elements.motions) {
    const SimbodyCoordinate& c = s.coordinates[motion.coordinate];
    s.drives.push_back(SimTK::Constraint::PrescribedMotion(s.matter, new Prescribed(motion, c.sign),
                                                           s.mobilizers[c.body].getMobilizedBodyIndex(),
                                                           SimTK::MobilizerQIndex(c.place)));
  }
}

}  // namespace mbgen::foreign
