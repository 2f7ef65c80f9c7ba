// Forces of actuators for given accelerations, against shared/reference/inverse_dynamics.json (numpy, null spaces by
// SVD; see its how_computed), MotionGenesis, and the judges.

#include <map>

#include "runtime/judges/cartesian.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen::testing {
namespace {

using InverseJson = nlohmann::json;

const InverseJson& inverse_reference() {
  static const auto file = InverseJson::parse(std::ifstream(source_path("tests/data/reference/inverse_dynamics.json")));
  return file;
}

CoordinateReference coordinate_named(const Model& model, const std::string& name) {
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    for (std::size_t c = 0; c < model.joints[j].freedoms.size(); ++c)
      if (model.joints[j].freedoms[c].name == name) return {static_cast<int>(j), static_cast<int>(c)};
  throw std::runtime_error("no coordinate " + name);
}

/// Adds an actuator on a coordinate, with an input.
void actuate(Model& model, const std::string& coordinate) {
  Actuator actuator;
  actuator.name = "motor_" + coordinate;
  actuator.joint = coordinate_named(model, coordinate);
  actuator.input = static_cast<int>(model.inputs.size());
  model.inputs.push_back({actuator.name, {}, "", 0, -1, {}});
  model.actuators.push_back(actuator);
}

Model plain_model(const std::string& path) {
  Result<Model> model = read_model_file(source_path(path));
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return *model;
}

Mechanism actuated(const std::string& path, const std::vector<std::string>& coordinates) {
  Model model = plain_model(path);
  for (const std::string& name : coordinates) actuate(model, name);
  return analysed(model);
}

std::vector<double> forces_at(const Mechanism& m, const GenericState& state, const std::vector<double>& zdd) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericDerivative derivative{zdd, {}};
  std::vector<double> force;
  const Status status = solver.inverse_dynamics(state, std::vector<double>(zdd.size(), 0.0), derivative, force);
  EXPECT_TRUE(status.ok()) << text(status.code) << " " << status.index;
  return force;
}

struct Vehicle {
  const char *name, *model, *states;
};

constexpr Vehicle kVehicles[] = {{"coach", "models/coach_mechanism.json", "tests/data/reference/coach_states.json"},
                                 {"truck", "models/truck_mechanism.json", "tests/data/reference/truck_states.json"}};

/// Forces for the accelerations of a state of the reference, and for others. given: the others, in the file's order.
void expect_reference(const Vehicle& vehicle, const Mechanism& m, const Mechanism& light, const InverseJson& one,
                      const std::vector<double>& given) {
  ASSERT_TRUE(has_inverse_dynamics(m.model, m.topology, m.analysis));
  const auto file = InverseJson::parse(std::ifstream(source_path(vehicle.states)));
  const ReferenceState state = reference_states(m.topology, vehicle.states)[one["state"].get<std::size_t>()];
  const std::vector<double> of_state = one["for_zdd_of_the_states"]["tau"];
  EXPECT_LT(relative_error(forces_at(m, state.state, state.zdd), of_state), 1e-9);
  EXPECT_LT(relative_error(forces_at(light, state.state, state.zdd_massless_rods), of_state), 1e-9);
  const InverseJson& other = one["for_other_accelerations"];
  std::vector<double> zdd(given.size());
  for (std::size_t i = 0; i < given.size(); ++i)
    zdd[find_coordinate(m.topology, file["joint_order"][i].get<std::string>())] = given[i];
  EXPECT_LT(relative_error(forces_at(m, state.state, zdd), other["tau"]), 1e-9);
  EXPECT_LT(relative_error(forces_at(light, state.state, zdd), other["tau_massless_rods"]), 1e-9);
}

TEST(InverseDynamics, OfVehiclesAsTheReference) {
  for (const Vehicle& vehicle : kVehicles) {
    std::map<std::string, std::pair<Mechanism, Mechanism>> of_set;
    std::vector<double> given;
    for (const InverseJson& one : inverse_reference()[vehicle.name]["cases"]) {
      const std::string set = one["set"];
      SCOPED_TRACE(std::string(vehicle.name) + " " + set);
      if (!of_set.contains(set)) {
        const Mechanism m = actuated(vehicle.model, one["actuators"]);
        Model light = m.model;
        without_rod_masses(light);
        of_set.emplace(set, std::pair(m, analysed(light)));
      }
      // "as in the case before"
      if (const InverseJson& zdd = one["for_other_accelerations"]["zdd"]; zdd.is_array())
        given = zdd.get<std::vector<double>>();
      const auto& [m, light] = of_set.at(set);
      expect_reference(vehicle, m, light, one, given);
    }
  }
}

/// Closed state of a mechanism of one freedom, its accelerations, at position, rate and acceleration of a coordinate.
struct DrivenState {
  GenericState state;
  std::vector<double> zdd;
};

DrivenState driven_by(const Mechanism& m, const std::string& name, double position, double rate, double acceleration) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const int at = find_coordinate(m.topology, name);
  DrivenState result{reference_state(m), std::vector<double>(static_cast<std::size_t>(m.topology.size()), 0.0)};
  for (int step = 1; step <= 64; ++step)
    EXPECT_TRUE(solver.assemble(result.state, {{at, position * step / 64, 1, true}}).ok());
  EXPECT_TRUE(solver.assemble_velocities(result.state, {{at, rate, 1, true}}).ok());
  const auto with = [&](double independent) {
    GenericDerivative derivative{result.zdd, {}};
    for (const int i : free_coordinates(m.topology, m.analysis)) derivative.zdd[i] = independent;
    std::vector<double> force;
    EXPECT_TRUE(solver.inverse_dynamics(result.state, result.zdd, derivative, force).ok());
    return derivative.zdd;
  };
  const std::vector<double> zero = with(0), one = with(1);
  result.zdd = with((acceleration - zero[at]) / (one[at] - zero[at]));
  return result;
}

TEST(InverseDynamics, OfAFourBarAtEachOfItsJointsAndAlongALine) {
  for (const char* joint : {"crank_pin", "coupler_pin", "rocker_pin"}) {
    const Mechanism m = actuated("models/four_bar.json", {joint});
    for (const InverseJson& one : inverse_reference()["four_bar"]["cases"]) {
      const DrivenState at = driven_by(m, "crank_pin", one["crank_pin"], one["zd"], one["zdd"]);
      for (const char* coordinate : {"coupler_pin", "rocker_pin"})
        ASSERT_NEAR(at.state.z[find_coordinate(m.topology, coordinate)], one[coordinate], 1e-10);
      const double expected = one["torque_at_" + std::string(joint)];
      EXPECT_NEAR(forces_at(m, at.state, at.zdd)[0], expected, 1e-9 * std::abs(expected)) << joint;
    }
  }
  Model model = plain_model("models/four_bar.json");
  Actuator line;
  line.name = "ram";
  line.from = model.springs[0].from;
  line.to = model.springs[0].to;
  model.actuators = {line};
  const Mechanism m = analysed(model);
  for (const InverseJson& one : inverse_reference()["four_bar"]["cases"]) {
    const DrivenState at = driven_by(m, "crank_pin", one["crank_pin"], one["zd"], one["zdd"]);
    const double expected = one["force_pushing_apart_along_the_spring_line"];
    EXPECT_NEAR(forces_at(m, at.state, at.zdd)[0], expected, 1e-9 * std::abs(expected));
  }
}

TEST(InverseDynamics, OfASliderCrankInClosedForm) {
  for (const char* joint : {"crank", "piston"}) {
    Model model = plain_model("models/slider_crank.json");
    model.joint_forces.clear();
    model.frictions.clear();
    actuate(model, joint);
    const Mechanism m = analysed(model);
    for (const InverseJson& one : inverse_reference()["slider_crank"]["cases"]) {
      const DrivenState at = driven_by(m, "crank", one["crank"], one["zd"], one["zdd"]);
      const std::string key = joint == std::string("crank") ? "torque_at_crank" : "force_at_piston";
      const double expected = one[key];
      EXPECT_NEAR(forces_at(m, at.state, at.zdd)[0], expected, 1e-9 * std::abs(expected)) << key;
    }
  }
}

TEST(InverseDynamics, OfTheKukaArmAsMotionGenesis) {
  const auto reference = InverseJson::parse(std::ifstream(source_path("tests/data/reference/kuka_iiwa.json")));
  Model model = plain_model("models/published/kuka_iiwa.json");
  model.motions.clear();
  const Result<Topology> tree = build_topology(model);
  std::vector<std::string> names;
  for (const TreeBody& body : tree->bodies) names.push_back(body.coordinate);
  for (const std::string& name : names) actuate(model, name);
  for (const InverseJson& one : reference["cases"]) {
    model.gravity[2] = -one["g"].get<double>();
    const Mechanism m = analysed(model);
    const GenericState state{one["q"], one["qd"], {}, 0};
    const std::vector<double> expected = one["tau"], found = forces_at(m, state, one["qdd"]);
    double size = 1;
    for (const double tau : expected) size = std::max(size, std::abs(tau));
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12 * size);
  }
}

/// A boom of 10 kg that a cylinder holds up: 1 m to its centre of mass, half a metre to the eye above the foot.
std::string boom_with(const std::string& parts) {
  return R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "bodies": {
      "ground": { "points": { "pin": [0, 0, 0], "foot": [0.5, 0, -0.5] } },
      "boom": { "mass": 10, "com": [1, 0, 0], "inertia": [1, 2, 2],
                "points": { "pin": [0, 0, 0], "eye": [0.5, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.pin", "to": "boom.pin", "axis": "-y" } }, )" +
         parts + " }";
}

TEST(InverseDynamics, OfCylindersAlongRodsSpringsAndBetweenPoints) {
  const double weight = 10 * 9.81 / 0.5, inertia = (10 * 1 + 2) / 0.5;
  const std::string ends = R"("from": "ground.foot", "to": "boom.eye")";
  const std::pair<std::string, double> ways[] = {
      {R"("actuators": { "ram": { )" + ends + " } }", 1},
      {R"("actuators": { "ram": { )" + ends + R"(, "gear": 200 } })", 200},
      {R"("rods": { "ram": { )" + ends + R"( } }, "actuators": { "push": { "rod": "ram" } })", 1},
      {R"("springs": { "gas": { )" + ends + R"(, "preload": -50 } }, "actuators": { "ram": { "spring": "gas" } })", 1}};
  for (const auto& [parts, gear] : ways) {
    const Mechanism m = mechanism_of(boom_with(parts));
    const int pin = find_coordinate(m.topology, "pin");
    std::vector<double> zdd(static_cast<std::size_t>(m.topology.size()), 0.0);
    // Of the rod, the angle or the length may be independent: at rest the length has half its acceleration.
    for (int i = 0; i < m.topology.size(); ++i) zdd[i] = i == pin ? 4 : 2;
    if (m.topology.size() > 2) zdd[find_coordinate(m.topology, "ram_length")] = 2;
    const double others = m.model.springs.empty() ? 0 : 50;
    const double force = forces_at(m, reference_state(m), zdd)[0];
    EXPECT_NEAR(force, (weight + inertia * 4 - others) / gear, 1e-9 * weight) << parts;
  }
}

/// More actuators than directions: three motors and a line on a four-bar.
Model redundant_four_bar() {
  Model model = plain_model("models/four_bar.json");
  for (const char* joint : {"crank_pin", "coupler_pin", "rocker_pin"}) actuate(model, joint);
  Actuator line;
  line.name = "ram";
  line.from = model.springs[0].from;
  line.to = model.springs[0].to;
  line.gear = 3.0;
  line.input = static_cast<int>(model.inputs.size());
  model.inputs.push_back({line.name, {}, "", 0, -1, {}});
  model.actuators.push_back(line);
  model.actuators[1].weight = 5;
  return model;
}

void expect_as_the_judge(const Mechanism& m, const GenericState& state, const std::vector<double>& zdd) {
  const CartesianSolver judge(m.model, m.topology, CartesianMethod::null_space, Stabilisation::projection);
  GenericDerivative derivative{zdd, {}};
  std::vector<double> expected;
  const std::vector<double> none(zdd.size(), 0.0);
  ASSERT_TRUE(judge.inverse_dynamics(state, none, free_coordinates(m.topology, m.analysis), derivative, expected).ok());
  EXPECT_LT(relative_error(forces_at(m, state, zdd), expected), 1e-9);
}

TEST(InverseDynamics, OfMoreActuatorsThanDirectionsIsLeast) {
  const Mechanism m = analysed(redundant_four_bar());
  for (const InverseJson& one : inverse_reference()["four_bar"]["cases"]) {
    const DrivenState at = driven_by(m, "crank_pin", one["crank_pin"], one["zd"], one["zdd"]);
    expect_as_the_judge(m, at.state, at.zdd);
    // u_i weight_i is along the powers of the actuators per unit force.
    const std::vector<double> force = forces_at(m, at.state, at.zdd);
    const auto rate = [&](const char* name) { return at.state.zd[find_coordinate(m.topology, name)]; };
    EXPECT_NEAR(force[0] / rate("crank_pin"), 5 * force[1] / rate("coupler_pin"), 1e-9 * std::abs(force[0]));
    EXPECT_NEAR(force[0] / rate("crank_pin"), force[2] / rate("rocker_pin"), 1e-9 * std::abs(force[0]));
  }
}

TEST(InverseDynamics, OfTheCoachAsTheJudges) {
  const Mechanism m = actuated("models/coach_mechanism.json",
                               inverse_reference()["coach"]["cases"][1]["actuators"].get<std::vector<std::string>>());
  const ReferenceState state = reference_states(m.topology, kVehicles[0].states)[0];
  expect_as_the_judge(m, state.state, state.zdd);
}

/// Random accelerations of a few units.
std::vector<double> random_accelerations(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> zdd;
  for (int i = 0; i < count; ++i) zdd.push_back(3 * unit(random));
  return zdd;
}

TEST(InverseDynamics, IsUndoneByTheAccelerationsAndGivesThePowerOfTheEnergy) {
  for (const char* path : {"tests/data/models/double_loop.json", "tests/data/models/floating_linkage.json",
                           "tests/data/models/nested_blocks.json"}) {
    SCOPED_TRACE(path);
    const Mechanism plain = load(path);
    std::vector<std::string> names;
    for (const int i : free_coordinates(plain.topology, plain.analysis))
      names.push_back(plain.topology.bodies[i].coordinate);
    const Mechanism m = actuated(path, names);
    GenericSolver solver(m.model, m.topology, m.analysis);
    const std::vector<double> none(static_cast<std::size_t>(m.topology.size()), 0.0);
    for (const GenericState& state : random_states(m, 3)) {
      GenericDerivative derivative{random_accelerations(m.topology.size()), std::vector<double>(state.x.size())};
      std::vector<double> force, inputs;
      ASSERT_TRUE(solver.inverse_dynamics(state, none, derivative, force).ok());
      for (const Input& input : m.model.inputs) inputs.push_back(input.default_value);
      for (std::size_t i = 0; i < force.size(); ++i) inputs[m.model.actuators[i].input] = force[i];
      solver.set_inputs(inputs);
      GenericDerivative found;
      ASSERT_TRUE(solver.accelerations(state, none, found).ok());
      EXPECT_LT(relative_error(found.zdd, derivative.zdd), 1e-10);
      double power = 0;
      for (std::size_t i = 0; i < force.size(); ++i)
        power += force[i] * state.zd[find_coordinate(m.topology, names[i])];
      const double applied = solver.outputs(state, none, found).applied_power;
      solver.set_inputs(std::vector<double>(inputs.size(), 0.0));
      const double others = solver.outputs(state, none, found).applied_power;
      EXPECT_NEAR(power, applied - others, 1e-9 * (std::abs(power) + std::abs(others) + 1));
      solver.set_inputs(inputs);
      // The rate of the energy is the power of all forces that are applied, actuators among them.
      constexpr double kStep = 1e-4;
      const auto energy = [&](double t) {
        GenericState later = state;
        for (std::size_t i = 0; i < later.z.size(); ++i) {
          later.z[i] += t * (state.zd[i] + t / 2 * derivative.zdd[i]);
          later.zd[i] += t * derivative.zdd[i];
        }
        const GenericOutputs values = solver.outputs(later, none, found);
        return values.kinetic_energy + values.potential_energy;
      };
      const double rate = (energy(kStep) - energy(-kStep)) / (2 * kStep);
      EXPECT_NEAR(rate, applied, 1e-5 * (std::abs(applied) + std::abs(energy(0)) + 1));
    }
    ::testing::Test::RecordProperty("model", path);
  }
}

TEST(InverseDynamics, NamesWhatNoActuatorMoves) {
  const Mechanism m = actuated("tests/data/models/stewart.json", {});
  EXPECT_FALSE(has_inverse_dynamics(m.model, m.topology, m.analysis));
  Mechanism less = actuated("models/coach_mechanism.json", {"chassis_tx", "chassis_rx", "wheel_rear_left"});
  EXPECT_FALSE(has_inverse_dynamics(less.model, less.topology, less.analysis));
  EXPECT_EQ(less.analysis.unactuated.size(), 12u);
  const Diagnostics problems = unactuated_directions(less.model, less.topology, less.analysis);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("chassis_ty"), std::string::npos) << problems[0].message;
  // Two actuators on one direction leave the other one, however many they are.
  Model cart = plain_model("tests/data/models/driven_cart.json");
  cart.motions.clear();
  actuate(cart, "cart");
  actuate(cart, "cart");
  const Mechanism twice = analysed(cart);
  ASSERT_EQ(twice.analysis.unactuated.size(), 1u);
  EXPECT_EQ(twice.topology.bodies[twice.analysis.unactuated[0]].coordinate, "swing");
}

TEST(InverseDynamics, StopsNearASingularPosition) {
  // The crank turns round, the rocker swings: where it turns back, no torque on it moves the crank.
  const Mechanism m = actuated("models/four_bar.json", {"rocker_pin"});
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const int crank = find_coordinate(m.topology, "crank_pin"), rocker = find_coordinate(m.topology, "rocker_pin");
  const int independent = free_coordinates(m.topology, m.analysis).at(0);
  EXPECT_EQ(actuated_directions(m.model, m.topology, m.analysis),
            std::vector<std::string>{"motor_rocker_pin on " + m.topology.bodies[independent].coordinate});
  GenericState state = reference_state(m);
  const std::vector<double> none(state.z.size(), 0.0);
  int stops = 0;
  constexpr int kTurn = 2000;
  for (int i = 0; i < kTurn; ++i) {
    ASSERT_TRUE(solver.assemble(state, {{crank, 2 * M_PI * i / kTurn, 1, true}}).ok());
    GenericState moving = state;
    ASSERT_TRUE(solver.assemble_velocities(moving, {{crank, 1, 1, true}}).ok());
    GenericDerivative derivative{none, {}};
    std::vector<double> force{12345};
    const Status status = solver.inverse_dynamics(state, none, derivative, force);
    const double ratio = std::abs(moving.zd[rocker] / moving.zd[independent]);
    if (status.ok()) {
      EXPECT_GT(ratio, 0.001) << i;
    } else {
      EXPECT_EQ(status.code, Code::actuators_singular);
      EXPECT_EQ(status.index, 0);
      EXPECT_EQ(force[0], 12345);
      EXPECT_LT(ratio, 0.01) << i;
      ++stops;
    }
  }
  EXPECT_GE(stops, 2);
  EXPECT_LE(stops, 40);
}

}  // namespace
}  // namespace mbgen::testing
