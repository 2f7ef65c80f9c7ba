// Outputs of motions, energies and wheels: rates against differences along a motion, momenta against forces, wheels and
// bodies by hand.

#include <nlohmann/json.hpp>

#include "mbgen/scalar.hpp"
#include "tests/support/motion_outputs_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Coordinates and velocities a time h later or earlier, by the accelerations.
GenericState moved(const GenericSolver& solver, const GenericState& state, double h) {
  GenericDerivative derivative;
  const std::vector<double> no_tau(state.z.size(), 0.0);
  if (!solver.accelerations(state, no_tau, derivative).ok()) throw std::runtime_error("no accelerations");
  GenericState result = state;
  for (std::size_t i = 0; i < state.z.size(); ++i) {
    result.z[i] += h * state.zd[i] + h * h / 2 * derivative.zdd[i];
    result.zd[i] += h * derivative.zdd[i];
  }
  result.t += h;
  if (!solver.project(result).ok()) throw std::runtime_error("not closed");
  return result;
}

/// A vector of three outputs and the one that its rate must be.
struct Rate {
  int of, is;  ///< first output of each
};

/// Relative points and bodies with axes that move, and the same with the next derivative.
std::vector<Rate> add_rates(Model& model, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::size_t size) { return static_cast<int>(random() % size); };
  const auto point = [&] {
    const int body = below(model.bodies.size());
    const auto count = model.bodies[body].points.size();
    return count == 0 ? Attachment{model.joints[0].to} : Attachment{body, below(count)};
  };
  std::vector<Rate> rates;
  for (int k = 0; k < 3; ++k) {
    PointOutput gap{.point = point(), .axes = below(model.bodies.size()), .relative_to = point()};
    gap.observer = gap.axes;
    const int position = add_vector(model, gap);
    gap.what = PointOutput::What::velocity;
    const int velocity = add_vector(model, gap);
    gap.what = PointOutput::What::acceleration;
    rates.push_back({position, velocity});
    rates.push_back({velocity, add_vector(model, gap)});
    RotationOutput turn{.what = RotationOutput::What::angular_velocity,
                        .body = below(model.bodies.size()),
                        .relative_to = below(model.bodies.size()),
                        .axes = gap.axes,
                        .observer = gap.axes};
    const int spin = add_vector(model, turn);
    turn.what = RotationOutput::What::angular_acceleration;
    rates.push_back({spin, add_vector(model, turn)});
  }
  return rates;
}

// Every term of a relative acceleration is in the second difference of the positions.
TEST(MotionOutputs, VelocitiesAndAccelerationsAreRatesInTheAxesOfAnyBody) {
  for (const char* path : {"tests/data/models/wheel_outputs.json", "tests/data/models/skew_tree.json",
                           "models/four_bar.json", "tests/data/models/floating_pair.json"}) {
    SCOPED_TRACE(path);
    Model model = model_at(path);
    model.outputs.clear();
    const std::vector<Rate> rates = add_rates(model, 5);
    const Mechanism m = analysed(std::move(model));
    const GenericSolver solver(m.model, m.topology, m.analysis);
    for (const GenericState& state : random_states(m, 2)) {
      constexpr double kStep = 1e-5;
      const std::vector<double> no_tau(state.z.size(), 0.0), now = outputs_at(solver, state, no_tau);
      const std::vector<double> before = outputs_at(solver, moved(solver, state, -kStep), no_tau);
      const std::vector<double> after = outputs_at(solver, moved(solver, state, kStep), no_tau);
      for (const Rate& rate : rates)
        for (int axis = 0; axis < 3; ++axis) {
          const double difference = (after[rate.of + axis] - before[rate.of + axis]) / (2 * kStep);
          EXPECT_NEAR(now[rate.is + axis], difference, 1e-5 * (1 + std::abs(difference)))
              << m.model.outputs[rate.is].name << " axis " << axis;
        }
    }
  }
}

/// Outputs of a model as text, by name, at its start.
std::map<std::string, double> values_of(const std::string& text) {
  const Mechanism m = mechanism_of(text);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  for (const InitialValue& value : m.model.initial.positions)
    state.z[tree_coordinate(m.topology, value.coordinate)] = value.value;
  for (const InitialValue& value : m.model.initial.velocities)
    state.zd[tree_coordinate(m.topology, value.coordinate)] = value.value;
  EXPECT_TRUE(solver.project(state).ok());
  const std::vector<double> y = outputs_at(solver, state, std::vector<double>(state.z.size(), 0.0));
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < y.size(); ++i) values[m.model.outputs[i].name] = y[i];
  return values;
}

/// A pendulum of 2 kg, centre 0.5 m below its pin, inertia 0.1 kg m^2, turned by 0.6 rad at 3 rad/s.
constexpr const char* kSwing = R"({ "mbgen": 1, "bodies": {
      "ground": { "points": { "pin": [0, 0, 1], "mark": [1, 0, 1] } },
      "arm": { "pose": { "origin": [0, 0, 1] }, "mass": 2, "com": [0, 0, -0.5], "inertia": [0.1, 0.1, 0.01],
               "points": { "pin": [0, 0, 0], "tip": [0, 0, -1] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.pin", "to": "arm.pin", "axis": "y" } },
    "initial": { "positions": { "pin": 0.6 }, "velocities": { "pin": 3 } },
    "outputs": {
      "kinetic": { "body": "arm", "quantity": "kinetic_energy" },
      "all_kinetic": { "bodies": "all" },
      "potential": { "bodies": "all", "quantity": "potential_energy" },
      "momentum": { "body": "arm", "quantity": "momentum", "axis": "x" },
      "own_momentum": { "body": "arm", "quantity": "momentum", "axis": "x", "frame": "body" },
      "about_pin": { "bodies": "all", "quantity": "angular_momentum", "axis": "y", "about": "ground.pin" },
      "about_centre": { "body": "arm", "quantity": "angular_momentum", "axis": "y" },
      "about_tip": { "bodies": "all", "quantity": "angular_momentum", "axis": "y", "about": "arm.tip" },
      "turn": { "body": "arm", "sequence": "xyz", "turn": "second" },
      "vector": { "body": "arm", "quantity": "rotation_vector", "axis": "y" },
      "scalar": { "body": "arm", "quantity": "quaternion", "axis": "w" },
      "part": { "body": "arm", "quantity": "quaternion", "axis": "y" },
      "back": { "body": "ground", "relative_to": "arm", "quantity": "rotation_vector", "axis": "y" },
      "spin": { "body": "arm", "quantity": "angular_velocity", "axis": "y" },
      "gain": { "body": "arm", "quantity": "angular_acceleration", "axis": "y" },
      "along": { "point": "arm.tip", "quantity": "velocity", "axis": "x", "axes_of": "arm" },
      "seen": { "point": "arm.tip", "relative_to": "ground.mark", "quantity": "velocity", "axis": "x", "axes_of": "arm",
                "observer": "ground" },
      "rests": { "point": "arm.tip", "relative_to": "ground.pin", "quantity": "velocity", "axis": "x", "frame": "body" },
      "far": { "points": ["arm.tip", "ground.mark"] },
      "corner": { "points": ["arm.tip", "ground.pin", "ground.mark"] } } })";

TEST(MotionOutputs, OfAPendulumByHand) {
  std::map<std::string, double> y = values_of(kSwing);
  const double angle = 0.6, rate = 3, inertia = 0.1 + 2 * 0.25;
  const double gain = -2 * 9.81 * 0.5 * std::sin(angle) / inertia;
  EXPECT_NEAR(y["kinetic"], 0.5 * inertia * rate * rate, 1e-12);
  EXPECT_NEAR(y["all_kinetic"], y["kinetic"], 1e-12);
  EXPECT_NEAR(y["potential"], 2 * 9.81 * (1 - 0.5 * std::cos(angle)), 1e-12);
  EXPECT_NEAR(y["momentum"], -2 * 0.5 * rate * std::cos(angle), 1e-12);
  EXPECT_NEAR(y["own_momentum"], -2 * 0.5 * rate, 1e-12);
  EXPECT_NEAR(y["about_pin"], inertia * rate, 1e-12);
  EXPECT_NEAR(y["about_centre"], 0.1 * rate, 1e-12);
  EXPECT_NEAR(y["about_tip"], 0.1 * rate - 2 * 0.5 * 0.5 * rate, 1e-12);
  EXPECT_NEAR(y["turn"], angle, 1e-15);
  EXPECT_NEAR(y["vector"], angle, 1e-15);
  EXPECT_NEAR(y["scalar"], std::cos(angle / 2), 1e-15);
  EXPECT_NEAR(y["part"], std::sin(angle / 2), 1e-15);
  EXPECT_NEAR(y["back"], -angle, 1e-15);
  EXPECT_NEAR(y["spin"], rate, 1e-15);
  EXPECT_NEAR(y["gain"], gain, 1e-12);
  EXPECT_NEAR(y["along"], -rate, 1e-12);
  EXPECT_NEAR(y["seen"], -rate, 1e-12);
  EXPECT_NEAR(y["rests"], 0, 1e-12);
  EXPECT_NEAR(y["far"], std::hypot(1 + std::sin(angle), std::cos(angle)), 1e-12);
  EXPECT_NEAR(y["corner"], std::numbers::pi / 2 + angle, 1e-12);
}

/// A wheel on a car that is turned and rolled, on a knuckle turned about z by `toe` and then about x by `lean`.
std::string wheel_model(double y, double toe, double lean) {
  const auto number = [](double value) { return std::to_string(value); };
  return R"({ "mbgen": 1, "bodies": {
      "ground": { "points": { "o": [0, 0, 0] } },
      "car": { "mass": 1, "inertia": [1, 1, 1],
               "points": { "o": [0, 0, 0], "hub": [0, )" +
         number(y) + R"(, 0.4] } },
      "knuckle": { "points": { "hub": [0, )" +
         number(y) + R"(, 0.4], "low": [0.02, )" + number(0.9 * y) + R"(, 0.2], "high": [-0.03, )" + number(0.8 * y) +
         R"(, 0.7] } },
      "wheel": { "pose": { "origin": [0, )" +
         number(y) + R"(, 0.4], "rotation": [{ "axis": "z", "angle": )" + number(toe) +
         R"( }, { "axis": "x", "angle": )" + number(lean) + R"( }] },
                 "mass": 1, "inertia": [1, 2, 1], "points": { "hub": [0, 0, 0] } } },
    "joints": {
      "yaw": { "type": "revolute", "from": "ground.o", "to": "car.o", "axis": "z" },
      "knuckle": { "type": "fixed", "from": "car.hub", "to": "knuckle.hub" },
      "wheel": { "type": "revolute", "from": "knuckle.hub", "to": "wheel.hub", "axis": [)" +
         number(-std::sin(toe) * std::cos(lean)) + ", " + number(std::cos(toe) * std::cos(lean)) + ", " +
         number(std::sin(lean)) + R"(] } },
    "tyre_data": { "hard": { "model": "pac2002", "coefficients": { "FNOMIN": 4000, "UNLOADED_RADIUS": 0.4,
      "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 } } },
    "tyres": { "tyre": { "centre": "wheel.hub", "data": "hard", "stiffness": 1e5 } },
    "initial": { "positions": { "yaw": 0.5, "wheel": 1.3 } },
    "outputs": {
      "toe": { "tyre": "tyre", "quantity": "toe", "relative_to": "car" },
      "camber": { "tyre": "tyre", "quantity": "camber", "relative_to": "car" },
      "steer": { "tyre": "tyre", "quantity": "steer_angle", "relative_to": "car" },
      "heading": { "tyre": "tyre", "quantity": "steer_angle" },
      "caster": { "tyre": "tyre", "quantity": "caster", "relative_to": "car", "steering_axis": ["knuckle.low", "knuckle.high"] },
      "kingpin": { "tyre": "tyre", "quantity": "kingpin_inclination", "relative_to": "car",
                   "steering_axis": ["knuckle.low", "knuckle.high"] },
      "joint_toe": { "joint": "wheel", "quantity": "toe", "relative_to": "car" },
      "joint_camber": { "joint": "wheel", "quantity": "camber", "relative_to": "car" },
      "joint_steer": { "joint": "wheel", "quantity": "steer_angle", "relative_to": "car" },
      "joint_heading": { "joint": "wheel", "quantity": "steer_angle" },
      "joint_caster": { "joint": "wheel", "quantity": "caster", "relative_to": "car",
                        "steering_axis": ["knuckle.low", "knuckle.high"] },
      "joint_kingpin": { "joint": "wheel", "quantity": "kingpin_inclination", "relative_to": "car",
                         "steering_axis": ["knuckle.low", "knuckle.high"] },
      "twice": { "expression": "2*out.joint_toe" } } })";
}

/// The text with other words in place of some.
std::string with_words(std::string text, const std::string& words, const std::string& others) {
  text.replace(text.find(words), words.size(), others);
  return text;
}

TEST(MotionOutputs, AnglesOfAWheelByHand) {
  for (const double side : {1.0, -1.0}) {
    const double turned = 0.05, lean = -0.03;
    std::map<std::string, double> y = values_of(wheel_model(0.8 * side, turned, lean));
    constexpr double kTyped = 2e-6;  // numbers of the model have six decimals
    EXPECT_NEAR(y["steer"], turned, kTyped);
    EXPECT_NEAR(y["heading"], turned + 0.5, kTyped);
    EXPECT_NEAR(y["toe"], -side * turned, kTyped);
    EXPECT_NEAR(y["camber"], -side * lean, kTyped) << "a left wheel turned by -0.03 about x leans to the left";
    EXPECT_NEAR(y["caster"], std::atan(0.05 / 0.5), kTyped);
    EXPECT_NEAR(y["kingpin"], std::atan(0.08 / 0.5), kTyped);
  }
}

// The wheel of a joint has the angles of the tyre's wheel, also where the joint goes from the wheel to its carrier,
// where its axis points to the right, and without a tyre.
TEST(MotionOutputs, AnglesOfAWheelByItsJoint) {
  const auto expect_same = [](const std::string& text) {
    std::map<std::string, double> y = values_of(text);
    for (const std::string name : {"toe", "camber", "steer", "heading", "caster", "kingpin"})
      EXPECT_NEAR(y["joint_" + name], y[name], 1e-14) << name;
    EXPECT_EQ(y["twice"], 2 * y["joint_toe"]);
    EXPECT_GT(std::abs(y["joint_toe"]), 0.04);
  };
  for (const double side : {1.0, -1.0}) {
    const std::string text = wheel_model(0.8 * side, 0.05, -0.03);
    expect_same(text);
    expect_same(
        with_words(text, R"("from": "knuckle.hub", "to": "wheel.hub")", R"("from": "wheel.hub", "to": "knuckle.hub")"));
    const std::size_t axis = text.find("\"axis\": [", text.find("\"wheel\": { \"type\"")) + 8;
    const std::string written = text.substr(axis, text.find(']', axis) + 1 - axis);
    const auto negated = nlohmann::json::parse(written).get<std::vector<double>>();
    const std::string turned = nlohmann::json({-negated[0], -negated[1], -negated[2]}).dump();
    std::map<std::string, double> right = values_of(with_words(
        with_words(text, "\"axis\": " + written, "\"axis\": " + turned), "\"wheel\": 1.3", "\"wheel\": -1.3"));
    std::map<std::string, double> left = values_of(text);
    for (const std::string name : {"toe", "camber", "steer", "heading"})
      EXPECT_NEAR(right["joint_" + name], left["joint_" + name], 1e-14) << name;
  }
}

/// Outputs of all bodies and rods: momentum, then angular momentum about the centre of mass, then energies.
Mechanism with_sums(const std::string& path) {
  using What = MomentumOutput::What;
  Model model = model_at(path);
  model.outputs.clear();
  add_vector(model, MomentumOutput{.what = What::momentum});
  add_vector(model, MomentumOutput{.what = What::angular_momentum});
  model.outputs.push_back({"kinetic", {}, "J", MomentumOutput{.what = What::kinetic_energy}});
  model.outputs.push_back({"potential", {}, "J", MomentumOutput{.what = What::potential_energy}});
  return analysed(std::move(model));
}

// Nothing but gravity acts from outside: the momentum gains m g, the angular momentum about the centre of mass stays.
TEST(MotionOutputs, MomentaOfWhatFloatsFollowFromGravity) {
  for (const char* path : {"tests/data/models/floating_linkage.json", "tests/data/models/floating_pair.json"}) {
    SCOPED_TRACE(path);
    const Mechanism m = with_sums(path);
    const GenericSolver solver(m.model, m.topology, m.analysis);
    double mass = 0;
    for (const Body& body : m.model.bodies) mass += body.mass.value;
    for (const Rod& rod : m.model.rods) mass += rod.mass.value;
    for (const GenericState& state : random_states(m, 2)) {
      constexpr double kStep = 1e-5;
      const std::vector<double> no_tau(state.z.size(), 0.0);
      const std::vector<double> before = outputs_at(solver, moved(solver, state, -kStep), no_tau);
      const std::vector<double> after = outputs_at(solver, moved(solver, state, kStep), no_tau);
      for (int i = 0; i < 6; ++i) {
        const double expected = i < 3 ? mass * m.model.gravity[i].value : 0;
        EXPECT_NEAR((after[i] - before[i]) / (2 * kStep), expected, 1e-6 * (1 + std::abs(expected))) << i;
      }
    }
  }
}

TEST(MotionOutputs, EnergiesOfAllAreThoseOfTheEnergyBalance) {
  for (const std::string& path : all_models()) {
    SCOPED_TRACE(path);
    const Mechanism m = with_sums(path);
    const GenericSolver solver(m.model, m.topology, m.analysis);
    double difference = 0;
    bool is_first = true;
    for (const GenericState& state : random_states(m, 3)) {
      GenericDerivative derivative;
      const std::vector<double> no_tau(state.z.size(), 0.0);
      ASSERT_TRUE(solver.accelerations(state, no_tau, derivative).ok());
      const GenericOutputs outputs = solver.outputs(state, no_tau, derivative);
      EXPECT_NEAR(outputs.y[6], outputs.kinetic_energy, 1e-11 * (1 + outputs.kinetic_energy));
      // The energy of bodies fixed to ground has no part in the balance, and is constant.
      const double constant = outputs.y[7] - outputs.potential_energy;
      if (is_first) difference = constant;
      EXPECT_NEAR(constant, difference, 1e-11 * (1 + std::abs(outputs.y[7])));
      is_first = false;
    }
  }
}

}  // namespace
}  // namespace mbgen
