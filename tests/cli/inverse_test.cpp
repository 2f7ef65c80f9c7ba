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
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
  };
  refused("four_bar.json", "the model has no actuators");
  std::string text = kFourBar;
  text.insert(text.find("\"initial\""), "\"actuators\": { \"drive\": { \"joint\": \"rocker_pin\" } },\n  ");
  write("driven.json", text);
  refused("driven.json", "the accelerations that \"zdd\" gives leave others open");
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

class WholeInverse : public Inverse {};

/// Long: solvers of every set, and lanes.
TEST_F(WholeInverse, OfVehicles) {
  for (const char* vehicle : {"coach", "truck"})
    for (const char* set : {"independent", "alternative"})
      for (const char* options : {"", "--batch 4"}) expect_vehicle(vehicle, set, options);
}

}  // namespace
}  // namespace mbgen::cli_test
