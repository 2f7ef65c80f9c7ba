// `mbgen evaluate --inverse`: forces of the actuators by every engine.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const Json& reference_of_inverse() {
  static const auto file = Json::parse(std::ifstream(kSource + "/tests/data/reference/inverse_dynamics.json"));
  return file;
}

class Inverse : public CommandLine {
 protected:
  Json forces(const std::string& model, const std::string& options) const {
    return json_of("evaluate '" + model + "' --inverse --states states.json " + options);
  }

  /// Writes the mechanism of a vehicle with one of the sets of actuators of the reference, without the mass of rods,
  /// and the states and accelerations of the set's cases. Result: the forces expected, per state.
  std::vector<std::vector<double>> write_vehicle(const std::string& vehicle, const std::string& set) const {
    Json model = {{"mbgen", 1}, {"name", vehicle + "_" + set}};
    model["include"] = {kSource + "/models/" + vehicle + "_mechanism.json"};
    const auto file = Json::parse(std::ifstream(kSource + "/tests/data/reference/" + vehicle + "_states.json"));
    Json states = {{"joint_order", file["joint_order"]}};
    std::vector<std::vector<double>> expected;
    Json given;
    for (const Json& one : reference_of_inverse()[vehicle]["cases"]) {
      const Json& other = one["for_other_accelerations"];
      if (other["zdd"].is_array()) given = other["zdd"];  // else "as in the case before"
      if (one["set"] != set) continue;
      for (const std::string name : one["actuators"]) model["actuators"]["m_" + name] = {{"joint", name}};
      const Json& at = file["states"][one["state"].get<std::size_t>()];
      states["states"].push_back({{"z", at["z"]}, {"zd", at["zd"]}, {"zdd", given}});
      expected.push_back(other["tau"]);
      order_ = one["actuators"].get<std::vector<std::string>>();
    }
    write("vehicle.json", model.dump());
    write("states.json", states.dump());
    return expected;
  }

  void expect_vehicle(const std::string& vehicle, const std::string& set, const std::string& options) const {
    const std::vector<std::vector<double>> expected = write_vehicle(vehicle, set);
    const Json answer = forces("vehicle.json", options);
    for (std::size_t s = 0; s < expected.size(); ++s) {
      ASSERT_EQ(answer["states"][s]["status"], "ok") << vehicle << set << options;
      double error = 0, largest = 0;
      for (std::size_t i = 0; i < order_.size(); ++i) {
        const double force = answer["states"][s]["actuators"]["m_" + order_[i]];
        error = std::max(error, std::abs(force - expected[s][i]));
        largest = std::max(largest, std::abs(expected[s][i]));
      }
      EXPECT_LT(error / largest, 1e-9) << vehicle << set << options;
      EXPECT_LT(answer["states"][s]["acceleration_residual"].get<double>(), 1e-8);
    }
  }

  /// Compiles the solver of NAME.json with a program, which ends with 0 where all holds.
  void expect_program(const std::string& name, const char* program) const {
    ASSERT_EQ(mbgen("generate " + name + ".json --out made").exit_code, 0);
    write("main.cpp", program);
    const Outcome compiled = shell("c++ -std=c++17 -O1 -Imade main.cpp made/" + name + ".cpp -o main");
    ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
    const Outcome run = shell("./main");
    EXPECT_EQ(run.exit_code, 0) << run.out;
  }

 private:
  mutable std::vector<std::string> order_;
};

TEST_F(Inverse, OfAnAnkleByEveryEngine) {
  const std::string ankle = kSource + "/models/robots/parallel_ankle.json";
  write("states.json", R"({ "joint_order": ["motor_a", "motor_b", "ankle_ry", "ankle_rx"], "states": [
    { "z": [0, 0, 0.1, 0], "zd": [0, 0, 3, 0], "zdd": { "ankle_ry": 20, "ankle_rx": 0 } },
    { "z": [0, 0, -0.3, 0.2], "zd": [0, 0, 1, -4], "zdd": { "motor_a": 50, "motor_b": -30 } }
  ] })");
  // Every engine closes loops in its own way: all take the states of one.
  const Json closed = forces(ankle, "--project --engine generic");
  auto states = Json::parse(read("states.json"));
  for (std::size_t s = 0; s < 2; ++s)
    for (const char* key : {"z", "zd"}) states["states"][s][key] = closed["states"][s][key];
  write("states.json", states.dump());
  const Json expected = forces(ankle, "--engine null-space");
  for (const char* options : {"--engine generic", "--engine augmented", "", "--batch 4"}) {
    const Json found = forces(ankle, options);
    for (std::size_t s = 0; s < 2; ++s) {
      ASSERT_EQ(found["states"][s]["status"], "ok");
      for (const char* name : {"ankle_a", "ankle_b"}) {
        const double force = expected["states"][s]["actuators"][name];
        EXPECT_NEAR(found["states"][s]["actuators"][name], force, 1e-9 * std::abs(force)) << options;
      }
    }
  }
}

TEST_F(Inverse, OfVehiclesInAGeneratedSolver) { expect_vehicle("coach", "alternative", ""); }

TEST_F(Inverse, TellsWhatIsMissing) {
  write("four_bar.json", kFourBar);
  write("states.json", R"({ "states": [{ "z": [0.6, 0, 0], "zdd": {} }] })");
  const auto refused = [&](const std::string& model, const std::string& text) {
    const Outcome run = mbgen("evaluate " + model + " --inverse --engine generic --states states.json");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
  };
  refused("four_bar.json", "the model has no actuators");
  std::string text = kFourBar;
  text.insert(text.find("\"initial\""), "\"actuators\": { \"drive\": { \"joint\": \"rocker_pin\" } },\n  ");
  write("driven.json", text);
  refused("driven.json", "the given accelerations leave others open");
  text.insert(text.find("\"tip\""),
              "\"wheel\": { \"type\": \"revolute\", \"from\": \"crank.B\", \"to\": \"wheel.B\" },\n  ");
  text.insert(text.find("\"coupler\""),
              "\"wheel\": { \"mass\": 1, \"com\": [0.1, 0, 0.05], \"inertia\": [1, 1, 1], \"points\": { \"B\": [0.1, "
              "0, 0.05] } },\n  ");
  text.replace(text.find("\"wheel.B\" }"), 11, "\"wheel.B\", \"axis\": \"y\" }");
  write("wheel.json", text);
  refused("wheel.json", "actuators do not move every free direction: wheel is left");
  EXPECT_NE(mbgen("check wheel.json").err.find("inverse dynamics has no solution"), std::string::npos);
}

/// Runs an ankle through its workspace; exit status 0 where all holds.
constexpr const char* kAnkle = R"(#include <cmath>
#include <cstdio>

#include "parallel_ankle.hpp"
using namespace parallel_ankle;

/// Crank angle by the intersection of the pin's circle with the sphere about the heel, near `last`.
static double crank(double y, double pitch, double roll, double last) {
  const double r = 0.045, h = 0.22, heel[3] = {-0.055, y, 0.01};
  // The heel turned by roll about x, then by pitch about y.
  const double ry = std::cos(roll) * heel[1] - std::sin(roll) * heel[2];
  const double rz = std::sin(roll) * heel[1] + std::cos(roll) * heel[2];
  const double px = std::cos(pitch) * heel[0] + std::sin(pitch) * rz;
  const double pz = -std::sin(pitch) * heel[0] + std::cos(pitch) * rz;
  const double length2 = (r - 0.055) * (r - 0.055) + (h - 0.01) * (h - 0.01);
  const double a = 2 * r * px, b = 2 * r * (h - pz);
  const double c = length2 - (r * r + px * px + (h - pz) * (h - pz) + (y - ry) * (y - ry));
  const double at = std::atan2(b, a), off = std::acos(c / std::hypot(a, b));
  double best = 10;
  for (int turn = -1; turn <= 1; ++turn)
    for (const double q : {at + off, at - off})
      if (std::abs(q + turn * 2 * M_PI - last) < std::abs(best - last)) best = q + turn * 2 * M_PI;
  return best;
}

int main() {
  const Inputs inputs;
  const Parameters parameters;
  State state{};
  if (!assemble(parameters, inputs, state).ok()) return 2;
  double worst = 0, q[kActuators] = {};
  // A spiral through the workspace: half a radian of pitch, a quarter of roll.
  for (int i = 0; i <= 4000; ++i) {
    const double share = i / 4000.0, pitch = 0.5 * share * std::sin(0.02 * i), roll = 0.25 * share * std::cos(0.02 * i);
    q[0] = crank(0.045, pitch, roll, q[0]);
    q[1] = crank(-0.045, pitch, roll, q[1]);
    const double still[kActuators] = {};
    if (!complete_joints(parameters, inputs, q, still, state).ok()) return 3;
    worst = std::fmax(worst, std::abs(state.z[Coordinate::ankle_ry] - pitch));
    worst = std::fmax(worst, std::abs(state.z[Coordinate::ankle_rx] - roll));
  }
  if (!(worst < 1e-12)) return 4;
  // Rates and accelerations at the end, by differences of positions.
  const double speed[kActuators] = {2, -3}, acceleration[kActuators] = {5, 7};
  const double h = 1e-4;
  State moved[3];
  for (int k = 0; k < 3; ++k) {
    const double t = (k - 1) * h;
    double at[kActuators], rate[kActuators];
    for (int i = 0; i < kActuators; ++i) {
      at[i] = q[i] + t * (speed[i] + t / 2 * acceleration[i]);
      rate[i] = speed[i] + t * acceleration[i];
    }
    moved[k] = state;
    if (!complete_joints(parameters, inputs, at, rate, moved[k]).ok()) return 5;
  }
  Derivative derivative{};
  if (!complete_accelerations(parameters, inputs, moved[1], acceleration, derivative).ok()) return 6;
  double jacobian[kCoordinates][kActuators];
  if (!actuator_jacobian(parameters, inputs, moved[1], jacobian).ok()) return 7;
  for (int c = 0; c < kCoordinates; ++c) {
    const double rate = (moved[2].z[c] - moved[0].z[c]) / (2 * h), zd = moved[1].zd[c];
    const double change = (moved[2].zd[c] - moved[0].zd[c]) / (2 * h), zdd = derivative.zdd[c];
    const double by_jacobian = jacobian[c][0] * speed[0] + jacobian[c][1] * speed[1];
    if (!(std::abs(rate - zd) < 1e-6 && std::abs(change - zdd) < 1e-5 && std::abs(by_jacobian - zd) < 1e-12)) {
      std::printf("coordinate %d: %g %g, %g %g, %g\n", c, rate, zd, change, zdd, by_jacobian);
      return 8;
    }
  }
  // Forces do the same work at the motors as at the independent coordinates, and come back.
  const double force[kActuators] = {3, -4};
  double tau[kCoordinates], back[kActuators], power = 0;
  if (!forces_at_independent(parameters, inputs, moved[1], force, tau).ok() ||
      !forces_at_actuators(parameters, inputs, moved[1], tau, back).ok())
    return 11;
  for (int c = 0; c < kCoordinates; ++c) power += tau[c] * moved[1].zd[c];
  if (!(std::abs(power - (3 * 2 + 4 * 3)) < 1e-12 && std::hypot(back[0] - 3, back[1] + 4) < 1e-12)) return 13;
  // Beyond its reach the ankle does not close; its pose stays.
  const double far[kActuators] = {3, 3}, still[kActuators] = {};
  const State before = state;
  if (complete_joints(parameters, inputs, far, still, state).ok()) return 9;
  for (int c = 0; c < kCoordinates; ++c)
    if (state.z[c] != before.z[c]) return 10;
  return 0;
}
)";

TEST_F(Inverse, PosesOfAnAnkleFollowFromItsMotors) {
  std::ifstream file(kSource + "/models/robots/parallel_ankle.json");
  std::string model((std::istreambuf_iterator<char>(file)), {});
  const std::string step = "\"step\": 1e-3";
  model.replace(model.find(step), step.size(), step + ", \"closure_tolerance\": 1e-15");
  write("parallel_ankle.json", model);
  expect_program("parallel_ankle", kAnkle);
}

// The line of the cylinder always meets the axis of q1, whose rounding is no lever.
TEST_F(Inverse, ACylinderThroughAnAxisDoesNotMoveIt) {
  write("arm.json", R"({ "mbgen": 1, "name": "arm",
    "bodies": { "ground": { "points": { "O": [0.31, 0.17, 0.53] } },
      "a": { "mass": 2, "com": [0.7, 0.17, 0.5], "inertia": [0.1, 0.1, 0.1],
             "points": { "O": [0.31, 0.17, 0.53], "A": [1.1, 0.17, 0.4] } },
      "b": { "mass": 1, "com": [1.4, 0.17, 0.2], "inertia": [0.05, 0.05, 0.05],
             "points": { "A": [1.1, 0.17, 0.4], "T": [1.7, 0.17, 0.1] } } },
    "joints": { "q1": { "type": "revolute", "from": "ground.O", "to": "a.O", "axis": "y" },
                "q2": { "type": "revolute", "from": "a.A", "to": "b.A", "axis": "y" } },
    "actuators": { "m": { "from": "ground.O", "to": "b.T" }, "m2": { "joint": "q2" } } })");
  EXPECT_NE(mbgen("check arm.json").err.find("actuators do not move every free direction: q1 is left"),
            std::string::npos);
}

// The moments of weight about the foot of the boom, and about its tip, by the lever of each cylinder.
TEST_F(Inverse, AnExcavatorHoldsItsWeight) {
  write("states.json", R"({ "joint_order": ["boom", "stick", "rocker", "bucket"], "states": [
    { "z": [0, 0, 0, 0], "zd": [0, 0, 0, 0], "zdd": { "boom": 0, "stick": 0, "bucket": 0 } }] })");
  const Json state = forces(kSource + "/models/robots/excavator.json", "--engine generic")["states"][0];
  ASSERT_EQ(state["status"], "ok");
  struct Place {
    double x, z;
  };
  const auto lever = [](Place from, Place to, Place pivot) {
    const double x = to.x - from.x, z = to.z - from.z;
    return (x * (to.z - pivot.z) - z * (to.x - pivot.x)) / std::hypot(x, z);
  };
  const double beyond_tip[4][2] = {{780, 5.5}, {45, 6}, {720, 5.9}, {40, 6.25}};  // kg, m
  double about_foot = 1650 * 2.55, about_tip = 0;
  for (const auto& [mass, x] : beyond_tip) {
    about_foot += mass * x;
    about_tip += mass * (x - 5.2);
  }
  const double boom = -9.81 * about_foot / lever({0.45, 1.35}, {2.4, 3.1}, {0, 1.8});
  const double stick = -9.81 * about_tip / lever({2.7, 4.1}, {4.9, 4.2}, {5.2, 3.5});
  EXPECT_NEAR(state["actuators"]["boom_cylinder"].get<double>() / boom, 1, 1e-12);
  EXPECT_NEAR(state["actuators"]["stick_cylinder"].get<double>() / stick, 1, 1e-12);
}

/// Runs a delta through its workspace; exit status 0 where all holds.
constexpr const char* kDelta = R"(#include <cmath>
#include <cstdio>

#include "delta_path.hpp"
using namespace delta_path;

struct Vector { double x, y, z; };
static Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
static double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The lower point at the forearm's length from three centres.
static Vector tool_of(const double (&q)[3]) {
  const double pi = std::acos(-1.0), arm = 0.112, forearm = 0.232;
  const double offset = (0.4573 - 0.115) / (2 * std::sqrt(3.0));
  Vector centre[3];
  for (int i = 0; i < 3; ++i) {
    const double down = pi / 6 + q[i], radius = offset + arm * std::cos(down), turn = 2 * pi / 3 * i;
    centre[i] = {radius * std::cos(turn), radius * std::sin(turn), -arm * std::sin(down)};
  }
  const Vector a = centre[1] - centre[0], b = centre[2] - centre[0], normal = cross(a, b);
  const Vector to_middle =
      1 / (2 * dot(normal, normal)) * (dot(a, a) * cross(b, normal) + dot(b, b) * cross(normal, a));
  const double above = std::sqrt((forearm * forearm - dot(to_middle, to_middle)) / dot(normal, normal));
  return centre[0] + to_middle - above * normal;
}

int main() {
  const Parameters parameters;
  const Inputs inputs;
  State state = initial_state();
  const Vector start = tool_of({0, 0, 0});
  double worst = 0;
  int poses = 0;
  for (int k = 0; k <= 20000; ++k) {
    const double t = 1e-3 * k;
    const double q[3] = {0.5 * std::sin(t), 0.45 * std::sin(1.7 * t), 0.4 * std::sin(2.3 * t)}, still[3] = {};
    if (!complete_joints(parameters, inputs, q, still, state).ok()) return 3;
    const Vector tool = tool_of(q) - start;
    worst = std::fmax(worst, std::abs(state.z[Coordinate::tool_tx] - tool.x));
    worst = std::fmax(worst, std::abs(state.z[Coordinate::tool_ty] - tool.y));
    worst = std::fmax(worst, std::abs(state.z[Coordinate::tool_tz] - tool.z));
    ++poses;
  }
  std::printf("%d poses, tool %.3g m\n", poses, worst);
  return worst < 1e-12 ? 0 : 4;
}
)";

class WholeInverse : public Inverse {};

/// Long: its solver takes some seconds to compile.
TEST_F(WholeInverse, PosesOfADeltaFollowFromItsMotors) {
  write("delta_path.json", R"({ "mbgen": 1, "name": "delta_path", "include": [")" + kSource +
                               R"(/models/robots/delta_path.json"], "solver": { "closure_tolerance": 1e-15 } })");
  expect_program("delta_path", kDelta);
}

/// Long: eight solvers.
TEST_F(WholeInverse, OfAFourBarByTorquesAndALine) {
  const Json& cases = reference_of_inverse()["four_bar"]["cases"];
  Json states = {{"joint_order", {"crank_pin", "coupler_pin", "rocker_pin"}}};
  for (const Json& one : cases)
    states["states"].push_back({{"z", {one["crank_pin"], one["coupler_pin"], one["rocker_pin"]}},
                                {"zd", one["zd_all"]},
                                {"zdd", {{"crank_pin", one["zdd"]}}}});
  write("states.json", states.dump());
  for (const auto& [place, name, key] : {std::tuple("joint", "crank_pin", "torque_at_crank_pin"),
                                         {"joint", "coupler_pin", "torque_at_coupler_pin"},
                                         {"joint", "rocker_pin", "torque_at_rocker_pin"},
                                         {"spring", "return_spring", "force_pushing_apart_along_the_spring_line"}}) {
    write("bar.json", Json({{"mbgen", 1},
                            {"name", "bar"},
                            {"include", {kSource + "/models/four_bar.json"}},
                            {"actuators", {{"motor", {{place, name}}}}}})
                          .dump());
    for (const char* options : {"--project", "--project --batch 4"}) {
      const Json answer = forces("bar.json", options);
      for (std::size_t s = 0; s < cases.size(); ++s) {
        const double expected = cases[s][key];
        EXPECT_NEAR(answer["states"][s]["actuators"]["motor"], expected, 1e-9 * std::abs(expected)) << key << options;
      }
    }
  }
}

/// Long: solvers of every set, and lanes.
TEST_F(WholeInverse, OfVehicles) {
  for (const char* vehicle : {"coach", "truck"})
    for (const char* set : {"independent", "alternative"})
      for (const char* options : {"", "--batch 4"}) expect_vehicle(vehicle, set, options);
}

}  // namespace
}  // namespace mbgen::cli_test
