// Couplings against hand calculations: gears, planetary gears, differentials, racks, screws and cams.

#include <cmath>
#include <cstdio>
#include <vector>

#include "runtime/judges/cartesian.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A mechanism in a state that its couplings hold, with what acts there.
class Coupled : public MechanismInState {
 public:
  explicit Coupled(const std::string& model) : MechanismInState(mechanism_of(model)), tau_(state_.z.size(), 0.0) {}

  void push(const std::string& name, double force) { tau_[index(name)] = force; }

  /// Closes the couplings and solves the equations of motion, which a Cartesian judge solves, too.
  void solve() {
    ASSERT_TRUE(solver_.project(state_).ok());
    ASSERT_TRUE(solver_.accelerations(state_, tau_, derivative_).ok());
    outputs_ = solver_.outputs(state_, tau_, derivative_);
    const CartesianSolver judge(m_.model, m_.topology, CartesianMethod::augmented, Stabilisation::projection);
    GenericDerivative other;
    ASSERT_TRUE(judge.accelerations(state_, tau_, other).ok());
    for (std::size_t i = 0; i < state_.z.size(); ++i)
      EXPECT_NEAR(other.zdd[i], derivative_.zdd[i], 1e-10 * (1 + std::abs(derivative_.zdd[i])));
  }

  double output(std::size_t i) const { return outputs_.y[i]; }
  const GenericOutputs& outputs() const { return outputs_; }

 private:
  GenericOutputs outputs_;
  std::vector<double> tau_;
};

// Radii 0.2 and 0.05: the small wheel turns four times as fast the other way; the teeth carry the force J w' / r.
TEST(Gears, TeethCarryTheForce) {
  const double wheel = 0.4, pinion = 0.03, torque = 5;
  Coupled gears(R"({ "mbgen": 1, "gravity": [0, 0, 0], "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "P": [0.25, 0, 0] } },
      "wheel":  { "mass": 3, "inertia": [0.2, 0.2, 0.4], "points": { "O": [0, 0, 0] } },
      "pinion": { "mass": 1, "pose": { "origin": [0.25, 0, 0] }, "inertia": [0.02, 0.02, 0.03],
                  "points": { "O": [0, 0, 0] } } },
    "joints": {
      "wheel":  { "type": "revolute", "from": "ground.O", "to": "wheel.O", "axis": "z" },
      "pinion": { "type": "revolute", "from": "ground.P", "to": "pinion.O", "axis": "z" } },
    "couplings": { "mesh": { "relation": "0.2*z.wheel + 0.05*z.pinion" } },
    "outputs": { "tooth": { "multiplier": "mesh" } } })");
  gears.set("wheel", 100, 3);
  gears.set("pinion", -399.8, -12);
  gears.push("wheel", torque);
  gears.solve();
  EXPECT_EQ(gears.analysis().degrees_of_freedom, 1);
  EXPECT_NEAR(gears.z("wheel") / gears.z("pinion"), -0.25, 1e-15);
  EXPECT_NEAR(gears.zd("wheel") / gears.zd("pinion"), -0.25, 1e-15);
  const double acceleration = torque / (wheel + 16 * pinion);
  EXPECT_NEAR(gears.zdd("wheel"), acceleration, 1e-13);
  EXPECT_NEAR(gears.zdd("pinion"), -4 * acceleration, 1e-13);
  EXPECT_NEAR(std::abs(gears.output(0)), pinion * 4 * acceleration / 0.05, 1e-12);
}

// Sun 24 teeth, planet 30, ring 84 = 24 + 2 30: Willis' equation, and the torques of sun, carrier and ring at constant
// speeds, of which the carrier takes the sum.
TEST(PlanetaryGear, ObeysWillis) {
  const std::string model = R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": {
      "ground": { "points": { "O": [0, 0, 0] } },
      "sun":     { "mass": 1, "inertia": [0.01, 0.01, 0.02], "points": { "O": [0, 0, 0] } },
      "ring":    { "mass": 4, "inertia": [0.2, 0.2, 0.4], "points": { "O": [0, 0, 0] } },
      "carrier": { "mass": 2, "inertia": [0.05, 0.05, 0.1], "points": { "O": [0, 0, 0], "P": [0.054, 0, 0] } },
      "planet":  { "mass": 0.5, "pose": { "origin": [0.054, 0, 0] }, "inertia": [0.001, 0.001, 0.002],
                   "points": { "O": [0, 0, 0] } } },
    "joints": {
      "sun":     { "type": "revolute", "from": "ground.O", "to": "sun.O", "axis": "z" },
      "ring":    { "type": "revolute", "from": "ground.O", "to": "ring.O", "axis": "z" },
      "carrier": { "type": "revolute", "from": "ground.O", "to": "carrier.O", "axis": "z" },
      "planet":  { "type": "revolute", "from": "carrier.P", "to": "planet.O", "axis": "z" } },
    "couplings": {
      "inner": { "relation": "24*(z.sun - z.carrier) + 30*z.planet" },
      "outer": { "relation": "84*(z.ring - z.carrier) - 30*z.planet" } } })";
  Coupled gear(model);
  const double at_carrier = (24 * 500 - 84 * 40) / 108.0, turning = (24 * 70 - 84 * 3) / 108.0;
  gear.set("sun", 500, 70);
  gear.set("ring", -40, -3);
  gear.set("carrier", at_carrier + 0.01, turning);
  gear.set("planet", 24 * (at_carrier - 500) / 30, 24 * (turning - 70) / 30);
  gear.push("sun", 2);
  gear.push("ring", -1);
  gear.push("carrier", 0.7);
  gear.solve();
  EXPECT_EQ(gear.analysis().degrees_of_freedom, 2);
  const double carrier = (24 * gear.zd("sun") + 84 * gear.zd("ring")) / 108;
  EXPECT_NEAR(gear.zd("carrier") / carrier, 1, 1e-14);
  EXPECT_NEAR(gear.zd("planet") / (24 * (carrier - gear.zd("sun")) / 30), 1, 1e-13);
  // Lagrange's equations with the carrier and the sun as coordinates; the planet turns with the carrier, too.
  const double on_carrier = 0.1 + 0.5 * 0.054 * 0.054;
  const auto rates = [](double c, double s) {  // of ring and planet
    return std::pair((108 * c - 24 * s) / 84, 24 * (c - s) / 30);
  };
  const auto [ring_c, planet_c] = rates(1, 0);
  const auto [ring_s, planet_s] = rates(0, 1);
  const double cc = on_carrier + 0.4 * ring_c * ring_c + 0.002 * std::pow(1 + planet_c, 2);
  const double cs = 0.4 * ring_c * ring_s + 0.002 * (1 + planet_c) * planet_s;
  const double ss = 0.02 + 0.4 * ring_s * ring_s + 0.002 * planet_s * planet_s;
  const double force_c = 0.7 - ring_c, force_s = 2 - ring_s;
  const double determinant = cc * ss - cs * cs;
  EXPECT_NEAR(gear.zdd("carrier"), (ss * force_c - cs * force_s) / determinant, 1e-10);
  EXPECT_NEAR(gear.zdd("sun"), (cc * force_s - cs * force_c) / determinant, 1e-10);
}

// Three speeds: the housing has the mean of the wheels'; a torque on it reaches both wheels in halves.
TEST(Differential, SharesTheTorque) {
  Coupled axle(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": {
      "ground": { "points": { "O": [0, 0, 0] } },
      "housing": { "mass": 5, "inertia": [0.2, 0.3, 0.2], "points": { "O": [0, 0, 0] } },
      "left":    { "mass": 5, "inertia": [0.3, 0.5, 0.3], "points": { "O": [0, 0, 0] } },
      "right":   { "mass": 5, "inertia": [1.0, 2.0, 1.0], "points": { "O": [0, 0, 0] } } },
    "joints": {
      "housing": { "type": "revolute", "from": "ground.O", "to": "housing.O", "axis": "y" },
      "left":    { "type": "revolute", "from": "ground.O", "to": "left.O", "axis": "y" },
      "right":   { "type": "revolute", "from": "ground.O", "to": "right.O", "axis": "y" } },
    "couplings": { "differential": { "relation": "z.left + z.right - 2*z.housing" } },
    "outputs": { "half": { "multiplier": "differential" } } })");
  axle.set("left", 3, 11);
  axle.set("right", -2, 4);
  axle.set("housing", 0.4, 7.5);
  axle.push("housing", 100);
  axle.solve();
  EXPECT_NEAR(axle.zd("left") + axle.zd("right"), 2 * axle.zd("housing"), 1e-13);
  const double half = std::abs(axle.output(0));
  EXPECT_NEAR(axle.zdd("left"), half / 0.5, 1e-11);
  EXPECT_NEAR(axle.zdd("right"), half / 2.0, 1e-11);
  EXPECT_NEAR(0.3 * axle.zdd("housing"), 100 - 2 * half, 1e-10);
}

// A nut of lead p on its screw falls with m g = (m + J k^2) z'', k = 2 pi / p.
TEST(Screw, TurnsWhileItFalls) {
  const double mass = 2, inertia = 0.01, k = 2 * M_PI / 0.05;
  Coupled nut(R"({ "mbgen": 1, "parameters": { "lead": { "value": 0.05, "tunable": true } },
    "bodies": {
      "ground": { "points": { "O": [0, 0, 0] } },
      "nut": { "mass": 2, "inertia": [0.01, 0.01, 0.01], "points": { "O": [0, 0, 0] } } },
    "joints": { "screw": { "type": "cylindrical", "from": "ground.O", "to": "nut.O", "axis": "z" } },
    "couplings": { "thread": { "relation": "2*pi*z.screw_tz - lead*z.screw_rz" } } })");
  nut.solve();
  EXPECT_NEAR(nut.zdd("screw_tz"), -mass * 9.81 / (mass + inertia * k * k), 1e-12);
  EXPECT_NEAR(nut.zdd("screw_rz"), k * nut.zdd("screw_tz"), 1e-10);
}

/// A screw jack under 5000 N, turned at `speed` rad/s: friction of 0.12 on a thread of 6 mm a turn and 14 mm of radius.
Coupled screw_jack(double speed) {
  return Coupled(R"json({ "mbgen": 1, "name": "jack", "gravity": [0, 0, -10],
    "parameters": { "lead": 0.006, "radius": 0.014, "mu": 0.12, "load": 5000, "speed": )json" +
                 std::to_string(speed) + R"json(, "lean": "atan(lead/(2*pi*radius))" },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "screw": { "mass": 3, "inertia": [0.01, 0.01, 3e-4], "points": { "O": [0, 0, 0] } },
      "table": { "mass": "load/10", "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "screw": { "type": "revolute", "from": "ground.O", "to": "screw.O", "axis": "z" },
      "table": { "type": "prismatic", "from": "ground.O", "to": "table.O", "axis": "z" } },
    "couplings": { "thread": { "relation": "z.table - lead/(2*pi)*z.screw" } },
    "joint_forces": { "rubbing": { "joint": "screw",
      "force": "-mu*radius*load*tanh(zd.screw/0.01)/(cos(lean)*(cos(lean) - mu*sin(lean)*tanh(zd.screw/0.01)))" } },
    "motions": { "motor": { "joint": "screw", "angle": "speed*t" } },
    "outputs": { "torque": { "motion": "motor" }, "thrust": { "multiplier": "thread" } } })json");
}

// Statics of a wedge of the angle of the thread and of the angle of friction.
TEST(ScrewJack, HasTheEfficiencyOfAWedge) {
  const double slope = 0.006 / (2 * M_PI * 0.014), lean = std::atan(slope), rubbing = std::atan(0.12);
  Coupled up = screw_jack(2), down = screw_jack(-2);
  up.solve();
  EXPECT_NEAR(up.output(1), -5000, 1e-9);
  EXPECT_NEAR(up.output(0), 5000 * 0.014 * std::tan(lean + rubbing), 1e-11);
  EXPECT_NEAR(5000 * up.zd("table") / (up.output(0) * up.zd("screw")), std::tan(lean) / std::tan(lean + rubbing),
              1e-14);
  down.solve();
  EXPECT_NEAR(down.output(0), 5000 * 0.014 * std::tan(lean - rubbing), 1e-11);
  EXPECT_LT(down.output(0), 0) << "it holds its load";
}

/// A cam of 0.05 kg m2 that a follower of 0.4 kg follows. contact: members of the coupling.
Coupled cam_with(const std::string& contact) {
  return Coupled(R"({ "mbgen": 1,
    "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "guide": [0, 0, 0.3] } },
      "cam":      { "mass": 1, "inertia": [0.05, 0.05, 0.05], "points": { "O": [0, 0, 0] } },
      "follower": { "mass": 0.4, "pose": { "origin": [0, 0, 0.3] }, "inertia": [0.001, 0.001, 0.001],
                    "points": { "O": [0, 0, 0] } } },
    "joints": {
      "cam":      { "type": "revolute", "from": "ground.O", "to": "cam.O", "axis": "y" },
      "follower": { "type": "prismatic", "from": "ground.guide", "to": "follower.O", "axis": "z" } },
    "couplings": { "contact": { )" +
                 contact + R"( } },
    "outputs": { "push": { "multiplier": "contact" } } })");
}

// A cam lifts its follower by h (1 - cos a): (J + m h'^2) a'' = T - m (g + h'' a'^2) h'.
TEST(Cam, LiftsItsFollower) {
  const double inertia = 0.05, mass = 0.4, h = 0.02, torque = 0.3;
  for (const double a : {0.0, 0.4, 1.3, 2.9, 5.0}) {
    Coupled cam = cam_with(R"json("relation": "z.follower - 0.02*(1 - cos(z.cam))")json");
    const double rate = 30, slope = h * std::sin(a), curve = h * std::cos(a);
    cam.set("cam", a, rate);
    cam.push("cam", torque);
    cam.solve();
    EXPECT_NEAR(cam.z("follower"), h * (1 - std::cos(a)), 1e-13);
    EXPECT_NEAR(cam.zd("follower"), slope * rate, 1e-12);
    const double acceleration =
        (torque - mass * (9.81 + curve * rate * rate) * slope) / (inertia + mass * slope * slope);
    EXPECT_NEAR(cam.zdd("cam"), acceleration, 1e-10);
    EXPECT_NEAR(cam.zdd("follower"), slope * acceleration + curve * rate * rate, 1e-10);
  }
}

/// Points [x, f(x)] of a table, with 17 digits.
template <class Function>
std::string points_of(const std::vector<double>& x, const Function& f) {
  std::string text;
  char point[80];
  for (const double at : x) {
    std::snprintf(point, sizeof point, "%s[%.17g, %.17g]", text.empty() ? "" : ", ", at, f(at));
    text += point;
  }
  return "[" + text + "]";
}

/// The same by a curve; curve: members of the table.
Coupled cam_by_table(const std::string& curve) {
  return cam_with(R"("joint": "follower", "follows": "cam", "curve": { )" + curve + " }");
}

/// Lift, slope and curvature of a cam at an angle.
struct Lift {
  double value, slope, curvature;
};

/// The cam turns at 30 rad/s under 0.3 N m. errors: allowed of place, rate and relative of accelerations.
void expect_lift(Coupled& cam, double angle, const Lift& lift, const Lift& errors) {
  const double inertia = 0.05, mass = 0.4, torque = 0.3, rate = 30;
  cam.set("cam", angle, rate);
  cam.push("cam", torque);
  cam.solve();
  EXPECT_NEAR(cam.z("follower"), lift.value, errors.value) << angle;
  EXPECT_NEAR(cam.zd("follower"), lift.slope * rate, errors.slope * rate) << angle;
  const double force = 9.81 + lift.curvature * rate * rate;
  const double acceleration = (torque - mass * force * lift.slope) / (inertia + mass * lift.slope * lift.slope);
  const double rise = lift.slope * acceleration + lift.curvature * rate * rate;
  const double error = errors.curvature * rate * rate;
  EXPECT_NEAR(cam.zdd("cam"), acceleration, 8 * error + 1e-11 * std::abs(acceleration)) << angle;
  EXPECT_NEAR(cam.zdd("follower"), rise, error + 1e-11 * std::abs(rise)) << angle;
  EXPECT_NEAR(cam.output(0), -mass * (9.81 + rise), mass * error + 1e-10) << angle;
}

// A spline through points of a cubic is the cubic, and a straight line beyond its ends.
TEST(CamByTable, SplineOfACubicIsTheCubic) {
  const auto cubic = [](double x) { return 0.01 * x + 0.02 * x * x - 0.004 * x * x * x; };
  const auto slope = [](double x) { return 0.01 + 0.04 * x - 0.012 * x * x; };
  Coupled cam = cam_by_table("\"table\": " + points_of({-1, -0.3, 0.4, 0.9, 2, 2.2, 3}, cubic) +
                             ", \"interpolation\": \"spline\"");
  EXPECT_EQ(cam.analysis().degrees_of_freedom, 1);
  const Lift rounding{1e-13, 1e-13, 1e-13};
  for (const double a : {-0.9, -0.3, 0.0, 0.65, 1.7, 2.95})
    expect_lift(cam, a, {cubic(a), slope(a), 0.04 - 0.024 * a}, rounding);
  for (const double a : {-2.0, 4.0}) {
    const double end = a < 0 ? -1 : 3;
    expect_lift(cam, a, {cubic(end) + slope(end) * (a - end), slope(end), 0}, rounding);
  }
}

// The cam of the expression above, from 36 and from 72 points of a turn, turn after turn: the errors of a spline fall
// with the fourth, third and second power of the distance of its points.
TEST(CamByTable, PeriodicSplineTendsToItsFunction) {
  const double h = 0.02;
  for (const int count : {36, 72}) {
    const double width = 2 * M_PI / count;
    std::vector<double> angles;
    for (int k = 0; k <= count; ++k) angles.push_back(k * width);
    Coupled cam = cam_by_table("\"table\": " + points_of(angles, [&](double a) { return h * (1 - std::cos(a)); }) +
                               ", \"interpolation\": \"spline\", \"periodic\": true");
    const Lift errors{h * std::pow(width, 4) / 300, h * std::pow(width, 3) / 20, h * std::pow(width, 2) / 8};
    for (const double a : {0.01, 0.4, 1.3, 2.9, 5.0, 6.28, 6.29, 40.0, -0.02, -17.0})
      expect_lift(cam, a, {h * (1 - std::cos(a)), h * std::sin(a), h * std::cos(a)}, errors);
    // Nothing dissipates: the energy of a turn and a half, by steps of a third of a degree.
    cam.set("cam", 0.3, 30);
    cam.push("cam", 0);
    cam.solve();
    const double before = cam.outputs().kinetic_energy + cam.outputs().potential_energy;
    const Dynamics dynamics{cam.solver()};
    for (int k = 0; k < 1600; ++k) ASSERT_TRUE(step_rk4(dynamics, cam.state(), 2e-4).ok());
    EXPECT_GT(cam.z("cam"), 3 * M_PI);
    cam.solve();
    EXPECT_NEAR(cam.outputs().kinetic_energy + cam.outputs().potential_energy, before, 1e-9 * before);
  }
}

// Elliptic gears: the angle of one over that of the other, each turn a turn more.
TEST(EllipticGears, TurnOnAndOn) {
  std::vector<double> angles;
  for (int k = 0; k <= 90; ++k) angles.push_back(k * 2 * M_PI / 90);
  const auto driven = [](double a) { return -(a + 0.3 * std::sin(a)); };
  Coupled gears(R"({ "mbgen": 1, "gravity": [0, 0, 0], "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "P": [0.25, 0, 0] } },
      "first":  { "mass": 3, "inertia": [0.2, 0.2, 0.4], "points": { "O": [0, 0, 0] } },
      "second": { "mass": 1, "pose": { "origin": [0.25, 0, 0] }, "inertia": [0.02, 0.02, 0.03],
                  "points": { "O": [0, 0, 0] } } },
    "joints": {
      "first":  { "type": "revolute", "from": "ground.O", "to": "first.O", "axis": "z" },
      "second": { "type": "revolute", "from": "ground.P", "to": "second.O", "axis": "z" } },
    "couplings": { "mesh": { "joint": "second", "follows": "first", "curve": {
      "interpolation": "spline", "periodic": true, "table": )" +
                points_of(angles, driven) + "} } } }");
  for (const double a : {0.5, 6.0, 200.0, -31.0}) {
    gears.set("first", a, 2);
    gears.set("second", driven(a), -2 * (1 + 0.3 * std::cos(a)));
    gears.solve();
    EXPECT_NEAR(gears.z("second"), driven(a), 1e-7);
    EXPECT_NEAR(gears.zd("second"), -2 * (1 + 0.3 * std::cos(a)), 1e-5);
    const double slope = -(1 + 0.3 * std::cos(a)), bend = 0.3 * std::sin(a);
    EXPECT_NEAR(gears.zdd("first"), -0.03 * slope * bend * 4 / (0.4 + 0.03 * slope * slope), 1e-4);
  }
}

// Bevel gears on an arm that turns itself: axes of any directions, and joints of the path that the relation leaves
// free.
TEST(BevelGear, TurnsOnAnArmThatMoves) {
  Coupled gear(R"({ "mbgen": 1,
    "bodies": {
      "ground": { "points": { "O": [0, 0, 0] } },
      "arm":   { "mass": 2, "com": [0.3, 0, 0], "inertia": [0.1, 0.2, 0.3], "points": { "O": [0, 0, 0], "A": [0.5, 0, 0] } },
      "bevel": { "mass": 1, "com": [0.6, 0.1, 0], "inertia": [0.02, 0.03, 0.04], "points": { "A": [0.5, 0, 0] } },
      "crown": { "mass": 1, "inertia": [0.02, 0.05, 0.04], "points": { "O": [0, 0, 0] } } },
    "joints": {
      "crown": { "type": "revolute", "from": "ground.O", "to": "crown.O", "axis": "z" },
      "arm":   { "type": "revolute", "from": "ground.O", "to": "arm.O", "axis": "y" },
      "bevel": { "type": "revolute", "from": "arm.A", "to": "bevel.A", "axis": "x" } },
    "couplings": { "teeth": { "relation": "z.bevel - 3*z.crown" } } })");
  gear.set("arm", 0.3, -2);
  gear.set("crown", 0.2, 5);
  gear.solve();
  EXPECT_EQ(gear.analysis().degrees_of_freedom, 2);
  EXPECT_NEAR(gear.zdd("bevel"), 3 * gear.zdd("crown"), 1e-10);
  // Nothing dissipates: energy after 0.1 s.
  const double before = gear.outputs().kinetic_energy + gear.outputs().potential_energy;
  const Dynamics dynamics{gear.solver()};
  for (int k = 0; k < 1000; ++k) ASSERT_TRUE(step_rk4(dynamics, gear.state(), 1e-4).ok());
  gear.solve();
  EXPECT_NEAR(gear.outputs().kinetic_energy + gear.outputs().potential_energy, before, 1e-9 * (1 + std::abs(before)));
  EXPECT_NEAR(gear.z("bevel"), 3 * gear.z("crown"), 1e-12);
}

}  // namespace
}  // namespace mbgen
