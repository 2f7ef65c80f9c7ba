// Enveloping contacts of tyres: against the contact in one point where they must be it, against the closed form of cams
// on a step, and obstacles that are crossed without a jump of force.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/support/dynamics.hpp"
#include "tests/support/quarter_car.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen::enveloping {
namespace {

using namespace mbgen::testing;

constexpr double kRadius = 0.3, kStiffness = 1e5;

std::string with_features(const std::string& features) { return R"({ "features": {)" + features + " } }"; }
const std::string kPlank = R"("plank": { "type": "plank", "from": 1, "length": 0.8, "height": 0.15, "ramp": 0 })";

/// A wheel of mass 1 without weight: its accelerations are the forces of its tyre, without friction.
class Feeler : public MechanismInState {
 public:
  /// envelope: a member of the tyre, or nothing.
  explicit Feeler(const std::string& road, const std::string& envelope = R"("enveloping": {},)", double damping = 0)
      : MechanismInState(analysed(model_of(fmt::format(
            R"({{ "mbgen": 1, "name": "feeler", "gravity": [0, 0, 0], "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
        "hub": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "O": [0, 0, 0] }} }} }},
        "joints": {{ "hub": {{ "type": "free", "from": "ground.O", "to": "hub.O" }} }}, {},
        "roads": {{ "road": {} }}, "tyres": {{ "tyre": {{ "centre": "hub.O", "data": "rubber", "stiffness": {}, {}
        "damping": {}, "friction": 0, "rolling_resistance": 0 }} }} }})",
            kRubber, road, kStiffness, envelope, damping)))) {}

  /// Along x, y and z; heading to the left and camber in rad.
  std::array<double, 3> force_at(double x, double y, double z, double heading = 0, double camber = 0) {
    set("hub_tx", x, 3);
    set("hub_ty", y, 0.5);
    set("hub_tz", z, -0.1);
    set("hub_rz", heading, 0);
    set("hub_rx", camber, 0);
    EXPECT_TRUE(solver_.solve_motion(state_, derivative_).ok());
    return {zdd("hub_tx"), zdd("hub_ty"), zdd("hub_tz")};
  }
};

TEST(Envelope, IsTheContactInOnePointOnPlanes) {
  for (const char* road : {"{}", R"({ "height": "0.3*x" })", R"({ "height": "0.3*x - 0.2*y + 0.01" })",
                           R"({ "origin": [1, 2, 0.03], "heading": 0.8, "height": "-0.1*x + 0.25*y" })"}) {
    Feeler point(road, "", 300), enveloping(road, R"("enveloping": { "order": 1.5, "length": 1.2, "steps": 2 },)", 300);
    for (const double heading : {0.0, 0.9, -2.5})
      for (const double camber : {0.0, 0.2}) {
        const auto expected = point.force_at(0.7, 0.4, 0.35, heading, camber);
        const auto force = enveloping.force_at(0.7, 0.4, 0.35, heading, camber);
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR(force[i], expected[i], 1e-12 * kRadius * kStiffness) << road << heading << camber;
      }
  }
}

// The curve that the middle of an ellipse goes along over the edge of a step is a quarter of this ellipse. Two such
// cams make the plane: it is as high as they are on average, and as steep as they are apart.
TEST(Envelope, RollsOverAStepAsItsCamsDo) {
  constexpr double kStep = 0.1, kBase = 0.12, kLength = 0.36, kHeight = 0.33;
  Feeler wheel(with_features(R"("up": { "type": "plank", "from": 1, "length": 50, "height": 0.1, "ramp": 0 })"),
               R"("enveloping": { "base": 0.4, "length": 1.2, "height": 1.1, "order": 2 },)");
  const auto cam = [&](double x) {
    const double before = std::max(1 - x, 0.0) / kLength;
    return before >= 1 ? 0 : std::max(kStep - kHeight * (1 - std::sqrt(1 - before * before)), 0.0);
  };
  int on_edge = 0;
  for (double x = 0.5; x < 1.2; x += 0.0137) {
    const double rear = cam(x - kBase / 2), front = cam(x + kBase / 2), slope = (front - rear) / kBase;
    on_edge += rear > 0 && front < kStep;
    const double load = kStiffness * (kRadius - (0.28 - (front + rear) / 2) / std::hypot(1, slope));
    const auto force = wheel.force_at(x, 0, 0.28);
    // The edge is looked at 1 nm inside of the step.
    EXPECT_NEAR(force[0], -load * slope / std::hypot(1, slope), 3e-9 * kStiffness * 10) << x;
    EXPECT_NEAR(force[2], load / std::hypot(1, slope), 3e-9 * kStiffness * 10) << x;
  }
  EXPECT_GT(on_edge, 3);
}

TEST(Envelope, TendsToTheContactInOnePointOnLongWaves) {
  double last = 0;
  for (const double length : {8.0, 16.0, 32.0}) {
    const std::string road = with_features(
        fmt::format(R"("waves": {{ "type": "sine", "height": {}, "wave_length": {} }})", 0.005 * length, length));
    Feeler point(road, ""), enveloping(road);
    double largest = 0;
    for (double x = 0; x < length; x += length / 50) {
      const double z = 0.28 + 0.005 * length * std::sin(2 * std::numbers::pi * x / length);
      largest = std::max(largest, std::abs(point.force_at(x, 0, z)[2] - enveloping.force_at(x, 0, z)[2]));
    }
    if (last > 0) {
      EXPECT_LT(largest, 0.6 * last) << length;
    }
    last = largest;
  }
  EXPECT_LT(last, 0.01 * 2000) << "of the load";
}

/// The largest jump of a vector between two places, by intervals that are halved until only jumps are left.
double largest_jump(const std::function<std::array<double, 3>(double)>& f, double from, double to) {
  constexpr int kIntervals = 300, kHalvings = 26;
  const auto apart = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  double largest = 0;
  for (int i = 0; i < kIntervals; ++i) {
    double a = from + (to - from) * i / kIntervals, b = from + (to - from) * (i + 1) / kIntervals;
    auto at_a = f(a), at_b = f(b);
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (a + b) / 2;
      const auto at_middle = f(middle);
      if (apart(at_a, at_middle) > apart(at_middle, at_b)) {
        b = middle, at_b = at_middle;
      } else {
        a = middle, at_a = at_middle;
      }
    }
    largest = std::max(largest, apart(at_a, at_b));
  }
  return largest;
}

// Half a wheel's radius high, with steps; in the stairs two planks meet.
TEST(Envelope, ForceDoesNotJump) {
  constexpr double kNothing = 1e-8 * kStiffness;  // N: 10 nm, of the 1 nm by which an edge is looked at inside
  const std::string hole = R"("hole": { "type": "pothole", "from": 1, "length": 0.3, "height": 0.1, "ramp": 0 })";
  const std::string stairs = kPlank + R"(, "next": { "type": "plank", "from": 1.8, "length": 0.4, "height": 0.08,
    "ramp": 0 }, "kerb": { "type": "plank", "from": 1.1, "length": 0.2, "height": 0.02, "ramp": 0.002 })";
  const std::string pit = R"("pit": { "type": "plank", "from": 1, "length": 0.5, "height": -0.1, "ramp": 0 })";
  for (const std::string& features : {kPlank, hole, pit, stairs})
    for (const double heading : {0.0, 0.6, 3.0}) {
      Feeler wheel(with_features(features));
      const auto force = [&](double x) { return wheel.force_at(x, 0.1, 0.3, heading); };
      EXPECT_LT(largest_jump(force, 0.4, 2.7), kNothing) << features << heading;
    }
  Feeler point(with_features(kPlank), "");
  EXPECT_GT(largest_jump([&](double x) { return point.force_at(x, 0, 0.3); }, 0.4, 2.7), 0.1 * kStiffness);
  const std::string sides =
      R"("side": { "type": "plank", "length": 4, "height": 0.1, "ramp": 0, "right": 0, "left": 1 })";
  Feeler beside(with_features(sides));
  EXPECT_LT(largest_jump([&](double y) { return beside.force_at(2, y, 0.3, 0.3); }, -0.3, 1.3), kNothing);
}

// Edges of planks and potholes along the wheel, which moves sideways over them or turns on them.
TEST(Envelope, ForceDoesNotJumpAtEdgesAlongTheWheel) {
  constexpr double kNothing = 1e-8 * kStiffness;  // N
  constexpr double kAcross = std::numbers::pi / 2;
  const std::string hole = R"("hole": { "type": "pothole", "from": 1, "length": 0.3, "height": 0.1, "ramp": 0 })";
  const std::string rail = R"("rail": { "type": "plank", "from": 1, "length": 0.05, "height": 0.1, "ramp": 0 })";
  const std::string pit = R"("pit": { "type": "plank", "from": 1, "length": 0.5, "height": -0.1, "ramp": 0 })";
  for (const std::string& features : {kPlank, hole, rail, pit}) {
    Feeler wheel(with_features(features));
    for (const double heading : {kAcross, -kAcross, kAcross - 1e-7, 1.5, 0.01})
      EXPECT_LT(largest_jump([&](double x) { return wheel.force_at(x, 0.1, 0.3, heading); }, 0.4, 2.3), kNothing)
          << features << heading;
    for (const double x : {0.98, 1.0, 1.02})
      EXPECT_LT(largest_jump([&](double turn) { return wheel.force_at(x, 0.1, 0.3, turn); }, -0.4, 3.5), kNothing)
          << features << x;
  }
}

// On a rail along it the wheel's halves lie on it by how much of them covers it: strips are 0.3 radii wide.
TEST(Envelope, StandsOnARailByTheShareOfItsWidth) {
  constexpr double kStrip = 0.3 * kRadius, kWide = 0.04, kHigh = 0.02;
  Feeler wheel(with_features(
      fmt::format(R"("rail": {{ "type": "plank", "from": 1, "length": {}, "height": {}, "ramp": 0 }})", kWide, kHigh)));
  const auto overlap = [&](double from, double to) {
    return std::max(std::min(to, 1 + kWide) - std::max(from, 1.0), 0.0) / kStrip;
  };
  for (const double x : {0.9, 0.95, 0.99, 1.02, 1.06, 1.1}) {
    // Heading along y its left is along -x.
    const double left = kHigh * overlap(x - kStrip, x), right = kHigh * overlap(x, x + kStrip);
    const double slope = (right - left) / kStrip, height = (right + left) / 2, steepness = std::hypot(1, slope);
    const double tilt = slope / steepness;  // of the plane against the wheel's axis
    const double load = kStiffness * (kRadius - (0.28 - height) / steepness / std::sqrt(1 - tilt * tilt));
    const auto force = wheel.force_at(x, 0, 0.28, std::numbers::pi / 2);
    EXPECT_NEAR(force[2], load / steepness, 1e-6 * load) << x;
    EXPECT_NEAR(force[0], -load * tilt, 1e-6 * load) << x;
  }
}

// --- a quarter car over a plank of half a wheel's radius ---

/// Largest load, and largest difference of loads of steps that follow each other, while the car crosses the plank.
std::array<double, 2> crossing(double step) {
  MechanismInState car = quarter_car(with_features(kPlank), 1, R"(, "enveloping": {})");
  const Dynamics dynamics{car.solver()};
  EXPECT_TRUE(car.solver().project_motion(car.state()).ok());
  double largest = 0, difference = 0, last = 0;
  for (int k = 1; k * step < 2.5; ++k) {
    EXPECT_TRUE(step_rk4(dynamics, car.state(), step).ok());
    const double load = outputs_at(car.solver(), car.state(), std::vector<double>(3, 0.0))[0];
    if (k > 1) difference = std::max(difference, std::abs(load - last));
    largest = std::max(largest, load);
    last = load;
  }
  return {largest, difference};
}

TEST(Envelope, CrossesAPlankWithoutAJumpOfForce) {
  const auto [load, coarse] = crossing(1e-3);
  const auto [same_load, fine] = crossing(5e-4);
  EXPECT_GT(load, 5000);
  EXPECT_NEAR(load, same_load, 0.01 * load);
  EXPECT_NEAR(coarse / fine, 2, 0.15) << coarse << " " << fine;
  EXPECT_LT(fine, 0.05 * load);
}

}  // namespace
}  // namespace mbgen::enveloping
