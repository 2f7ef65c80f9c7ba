// Corners of mbgen new against the velocities of their geometry, worked out by hand: a knuckle on five constraints has
// one screw, and all gradients at the start follow from it.

#include <Eigen/Dense>
#include <utility>
#include <vector>

#include "tests/kc/kc_support.hpp"

namespace mbgen::kc_test {
namespace {

using Eigen::Vector3d;

/// A point of the knuckle that cannot move in a direction.
struct Held {
  Vector3d point, direction;
};

/// A stand of models/starters/vehicles at its reference configuration.
Model at_reference(const std::string& kind) {
  const std::string text = R"({ "mbgen": 1, "name": "stand", "include": [{ "file": ")" +
                           source_path("models/starters/vehicles/" + kind + ".json") +
                           R"(", "remove": ["/initial"] }] })";
  return expect(read_model(text, "stand.json"));
}

Vector3d hardpoint(const Model& model, const std::string& name) {
  for (const Point& point : model.hardpoints)
    if (point.name == name) return {point.position[0].value, point.position[1].value, point.position[2].value};
  throw std::out_of_range("no hardpoint " + name);
}

double parameter_of(const Model& model, const std::string& name) {
  for (const Parameter& one : model.parameters)
    if (one.name == name) return one.value;
  throw std::out_of_range("no parameter " + name);
}

/// Velocities of the knuckle per travel of the wheel's centre.
struct Screw {
  Vector3d hub, velocity, turn;
  Vector3d at(const Vector3d& point) const { return velocity + turn.cross(point - hub); }
};

Screw screw_of(const Vector3d& hub, const std::vector<Held>& held) {
  Eigen::Matrix<double, 6, 6> rows = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < 5; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rows.block<1, 3>(row, 0) = held[i].direction.transpose();
    rows.block<1, 3>(row, 3) = (held[i].point - hub).cross(held[i].direction).transpose();
  }
  rows(5, 2) = 1;
  const Eigen::Matrix<double, 6, 1> twist = rows.fullPivLu().solve(Eigen::Matrix<double, 6, 1>::Unit(5));
  return {hub, twist.head<3>(), twist.tail<3>()};
}

/// Compares gradients, roll centre and pitch support of the left wheel. support: name of the figure, and its factor.
void expect_figures(const KcReport& report, const Model& model, const Screw& screw, double radius,
                    const std::pair<std::string, double>& support) {
  const double toe = parameter_of(model, "toe"), camber = parameter_of(model, "camber");
  const Vector3d a(std::sin(toe) * std::cos(camber), std::cos(toe) * std::cos(camber), -std::sin(camber));
  const Vector3d rate = screw.turn.cross(a), up(0, 0, 1);
  const double level = std::hypot(a.x(), a.y());
  EXPECT_NEAR(figure(report, "toe"), toe, 1e-12);
  EXPECT_NEAR(figure(report, "camber"), camber, 1e-12);
  EXPECT_NEAR(figure(report, "toe_gradient"), (rate.x() * a.y() - a.x() * rate.y()) / (level * level), 1e-9);
  const double level_rate = (a.x() * rate.x() + a.y() * rate.y()) / level;
  EXPECT_NEAR(figure(report, "camber_gradient"), a.z() * level_rate - rate.z() * level, 1e-9);
  // The contact centre lies below the wheel's centre, in the plane of the wheel.
  const Vector3d f = a.cross(up).normalized();
  const Vector3d f_rate = rate.cross(up) / level - f * (f.dot(rate.cross(up)) / level);
  const Vector3d contact = screw.hub - radius * f.cross(a);
  const Vector3d moves = screw.velocity - radius * (f_rate.cross(a) + f.cross(rate));
  EXPECT_NEAR(figure(report, "roll_centre_height"), contact.y() * moves.y() / moves.z(), 1e-9);
  const Vector3d locked = screw.at(contact);
  EXPECT_NEAR(figure(report, support.first), support.second * locked.x() / locked.z(), 1e-9);
}

/// Compression of a spring from a fixed point to one of the knuckle, per travel.
double ratio(const Screw& screw, const Vector3d& fixed, const Vector3d& moving) {
  return -screw.at(moving).dot((moving - fixed).normalized());
}

TEST(Starters, McPhersonHasTheScrewOfItsGeometry) {
  const Model model = at_reference("mcpherson");
  const auto at = [&](const char* name) { return hardpoint(model, name); };
  const Vector3d along = at("arm_front") - at("arm_rear"), strut = at("strut_top") - at("strut_low");
  const Vector3d across = strut.cross(Vector3d::UnitX());
  const Screw screw =
      screw_of(at("hub"), {{at("ball"), along},
                           {at("ball"), at("ball") - at("arm_rear") -
                                            along * ((at("ball") - at("arm_rear")).dot(along) / along.squaredNorm())},
                           {at("strut_top"), across},
                           {at("strut_top"), strut.cross(across)},
                           {at("tie_outer"), at("tie_outer") - at("tie_inner")}});
  const KcReport report = report_of(model, {.points = 3});
  expect_figures(report, model, screw, 0.2985, {"anti_dive", 0.7 * 2.7 / 0.55});
  EXPECT_NEAR(figure(report, "ratio_spring"), ratio(screw, at("strut_top"), at("strut_low")), 1e-9);
  // Roll centre, camber gain and bump steer are those of passenger cars.
  EXPECT_GT(figure(report, "roll_centre_height"), 0.03);
  EXPECT_LT(figure(report, "roll_centre_height"), 0.1);
  EXPECT_LT(figure(report, "camber_gradient"), 0);
  EXPECT_LT(figure(report, "toe_gradient"), 0);
}

// In the plane across the car the wheel turns about the pole: where the arm's line meets the perpendicular to the strut
// in its top mount. The roll centre lies on the line from contact to pole, as drawn by hand: Reimpell, 3.4.
TEST(Starters, McPhersonsRollCentreIsThatOfTheDrawing) {
  const Model model = at_reference("mcpherson");
  const auto at = [&](const char* name) { return hardpoint(model, name); };
  const Vector3d inner =
      at("arm_rear") + (at("arm_front") - at("arm_rear")) *
                           ((at("ball").x() - at("arm_rear").x()) / (at("arm_front").x() - at("arm_rear").x()));
  const double arm = (at("ball").z() - inner.z()) / (at("ball").y() - inner.y());
  const double strut = -(at("strut_top").y() - at("strut_low").y()) / (at("strut_top").z() - at("strut_low").z());
  const double y =
      (at("strut_top").z() - strut * at("strut_top").y() - at("ball").z() + arm * at("ball").y()) / (arm - strut);
  const double z = at("ball").z() + arm * (y - at("ball").y());
  const double track = at("hub").y();
  const KcReport report = report_of(model, {.points = 3});
  EXPECT_NEAR(figure(report, "roll_centre_height"), track * z / (track - y),
              0.01);  // the drawing leaves out caster and bump steer
}

TEST(Starters, MultilinkHasTheScrewOfItsFiveLinks) {
  const Model model = at_reference("multilink");
  std::vector<Held> held;
  for (const char* link : {"upper_front", "upper_rear", "trailing", "lower", "toe"}) {
    const Vector3d in = hardpoint(model, std::string(link) + "_in"), out = hardpoint(model, std::string(link) + "_out");
    held.push_back({out, out - in});
  }
  const Screw screw = screw_of(hardpoint(model, "hub"), held);
  const KcReport report = report_of(model, {.points = 3});
  expect_figures(report, model, screw, 0.3018, {"anti_lift", -0.3 * 2.7 / 0.55});
  EXPECT_NEAR(figure(report, "ratio_spring"),
              ratio(screw, hardpoint(model, "spring_top"), hardpoint(model, "spring_seat")), 1e-9);
  EXPECT_NEAR(figure(report, "ratio_damper"),
              ratio(screw, hardpoint(model, "damper_top"), hardpoint(model, "damper_low")), 1e-9);
  EXPECT_GT(figure(report, "toe_gradient"), 0);  // toe-in of the rear wheels in bump
  EXPECT_LT(figure(report, "camber_gradient"), 0);
}

// The leaves hold the axle sideways at the height of their seats, and carry it by their rate.
TEST(Starters, SolidAxleRollsAboutTheHeightOfItsLeaves) {
  const Model model = at_reference("solid_axle");
  const KcReport report = report_of(model, {.points = 3});
  EXPECT_NEAR(figure(report, "roll_centre_height"), 0.62, 1e-5);
  EXPECT_NEAR(figure(report, "wheel_rate"), 600e3, 600);
}

// With hard bushings both arms turn about the line through them when the wheels move alike; against each other an arm
// turns about the line from its bushing to the shear centre in the middle of the beam, and the beam twists by twice its
// part about y.
TEST(Starters, TwistBeamRollsAboutItsShearCentre) {
  const auto side = [](const std::string& name, const std::string& mirror) {
    return "\"/instances/" + name + R"(": { "file": ")" + source_path("models/starters/vehicles/twist_beam_side.json") +
           R"(", "suffix": "_)" + name +
           R"(", "connect": { "chassis": "ground" }, "parameters": { "radial": 1e11, "axial": 1e11 })" + mirror + " }";
  };
  const std::string text = R"({ "mbgen": 1, "name": "stand", "include": [{ "file": ")" +
                           source_path("models/starters/vehicles/twist_beam.json") +
                           R"(", "remove": ["/initial"], "replace": { )" + side("left", "") + ", " +
                           side("right", R"(, "mirror": "xz", "coordinates": "parallel")") + " } }] }";
  const Model model = expect(read_model(text, "stand.json"));
  const Vector3d hub = hardpoint(model, "hub_left"), bush = hardpoint(model, "bush_left");
  const Vector3d middle = (hardpoint(model, "shear_left") + hardpoint(model, "shear_right")) / 2;
  const auto turning = [&](const Vector3d& axis) {
    const Vector3d turn = axis / axis.cross(hub - bush).z();
    return Screw{hub, turn.cross(hub - bush), turn};
  };
  const Screw alike = turning(Vector3d::UnitY()), against = turning(bush - middle);
  const KcReport report = report_of(model, {.points = 3});
  const double toe = 0.15 * M_PI / 180, camber = -1.3 * M_PI / 180, radius = 0.3018;
  const Vector3d a(std::sin(toe) * std::cos(camber), std::cos(toe) * std::cos(camber), -std::sin(camber));
  const double level = std::hypot(a.x(), a.y());
  const Vector3d rate = alike.turn.cross(a);
  EXPECT_NEAR(figure(report, "toe"), toe, 1e-9);
  EXPECT_NEAR(figure(report, "camber"), camber, 1e-9);
  EXPECT_NEAR(figure(report, "toe_gradient"), (rate.x() * a.y() - a.x() * rate.y()) / (level * level), 1e-6);
  EXPECT_NEAR(figure(report, "camber_gradient"),
              a.z() * (a.x() * rate.x() + a.y() * rate.y()) / level - rate.z() * level, 1e-6);
  // Opposite travel: twist of the beam, springs, and the contact centre's way.
  EXPECT_NEAR(std::abs(figure(report, "ratio_roll_torsion")), std::abs(2 * against.turn.y()), 1e-5);
  EXPECT_NEAR(figure(report, "ratio_roll_spring_left"),
              ratio(against, hardpoint(model, "spring_top_left"), hardpoint(model, "spring_seat_left")), 1e-6);
  const Vector3d turns = against.turn.cross(a), up(0, 0, 1), f = a.cross(up).normalized();
  const Vector3d f_rate = turns.cross(up) / level - f * (f.dot(turns.cross(up)) / level);
  const Vector3d moves = against.velocity - radius * (f_rate.cross(a) + f.cross(turns));
  const double y = (hub - radius * f.cross(a)).y();
  EXPECT_NEAR(figure(report, "roll_centre_height"), y * moves.y() / moves.z(), 1e-6);
}

}  // namespace
}  // namespace mbgen::kc_test
