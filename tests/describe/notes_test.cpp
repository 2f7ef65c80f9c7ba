// Notes of mbgen check on models that are allowed and likely not meant: tests/errors/notes/<name>.json, and the exact
// text in <name>.txt. MBGEN_UPDATE=1 cli_test --gtest_filter='Notes.*' rewrites the texts.
#include "tests/support/cli_support.hpp"
#include "tests/support/expected_text.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

class Notes : public CommandLine {};

TEST_F(Notes, HaveTheirExactTextAndTheModelIsOk) {
  const fs::path folder = fs::path(kSource) / "tests" / "errors" / "notes";
  int cases = 0;
  fs::copy(folder / "parts", path("parts"));
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const std::string name = entry.path().stem().string();
    fs::copy_file(entry.path(), path(name + ".json"));
    const Outcome run = mbgen("check " + name + ".json");
    EXPECT_EQ(run.exit_code, 0) << name << ": " << run.err;
    EXPECT_EQ(run.out.find(name + ".json: ok\n"), 0u) << run.out;
    EXPECT_NE(run.err.find(": note: "), std::string::npos) << name;
    testing::expect_text(fs::path(entry.path()).replace_extension(".txt"), run.err);
    ++cases;
  }
  EXPECT_GE(cases, 31);
}

TEST_F(Notes, ModelsOfTheProjectHaveNone) {
  std::vector<fs::path> models = {kSource + "/models/coach.json"};
  for (const char* folder : {"models/starters", "models/published"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(kSource) / folder)) {
      if (entry.path().extension() == ".json") models.push_back(entry.path());
    }
  }
  for (const fs::path& model : models) {
    const Outcome run = mbgen("check " + model.string());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "") << model;
    EXPECT_NE(run.out.find(", notes 0\n"), std::string::npos) << run.out;
  }
}

TEST_F(Notes, StaticToeAndCamberAsTheStarterHasThemDoNotWobble) {
  fs::copy_file(kSource + "/models/starters/tyre_rig.json", path("tyre_rig.json"));
  const auto wobble = [&](const std::string& name) {
    const Outcome run = mbgen("simulate " + name + ".json --engine generic --duration 3 --out " + name + ".csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Table rows = table(name + ".csv");
    double smallest = 1e9, largest = 0;
    for (std::size_t row = rows.rows.size() * 9 / 10; row < rows.rows.size(); ++row) {
      smallest = std::min(smallest, rows.at(row, "load [N]"));
      largest = std::max(largest, rows.at(row, "load [N]"));
    }
    return largest - smallest;
  };
  EXPECT_LT(wobble("tyre_rig"), 2);  // N of 3970: what is left of the start
  // The tyre about y, as a tyre without "axis" was taken: what its plane does shows once a turn.
  std::string text = read("tyre_rig.json");
  text.replace(text.find("\"data\": \"summer\""), 0, "\"axis\": [0.0035, 0.9997, -0.0262], ");
  write("upright.json", text);
  EXPECT_GT(wobble("upright"), 100);
}

TEST_F(Notes, AForgottenConnectionIsNamed) {
  write("leg.json", R"({ "bodies": { "hip": { "points": { "pin": [0, 0.3, 0] } },
      "leg": { "mass": 2, "com": [0, 0.3, -1], "inertia": [1, 1, 1], "points": { "pin": [0, 0.3, 0] } } },
    "joints": { "leg": { "type": "revolute", "from": "hip.pin", "to": "leg.pin", "axis": "x" } } })");
  write("robot.json", R"({ "mbgen": 1, "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "hip": { "mass": 9, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "hip": { "type": "free", "from": "ground.O", "to": "hip.O" } },
    "instances": { "left": { "file": "leg.json" } } })");
  const Outcome run = mbgen("check robot.json");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("body \"left_hip\" has no path to ground"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("hint: connect the instance's body: \"connect\": { \"hip\": \"hip\" }; 1 more body"),
            std::string::npos)
      << run.err;
}

TEST_F(Notes, MistypedWordsGetTheNearestName) {
  const auto said = [&](const std::string& arguments) {
    const Outcome run = mbgen(arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments;
    return run.err;
  };
  write("pendulum.json", kPendulum);
  EXPECT_NE(said("simluate pendulum.json").find("  hint: did you mean \"simulate\"?\n"), std::string::npos);
  EXPECT_NE(said("simulate pendulum.json --durration 3 --out a.csv").find("  hint: did you mean \"--duration\"?\n"),
            std::string::npos);
  EXPECT_NE(said("simulate pendulum.json --duration=3 --oot=a.csv").find("  hint: did you mean \"--out\"?\n"),
            std::string::npos);
  EXPECT_NE(
      said("simulate pendulum.json --engine generic --input torqe=3 --out a.csv").find("did you mean \"torque\"?"),
      std::string::npos);
  EXPECT_EQ(said("frobnicate").find("did you mean"), std::string::npos);
}

TEST_F(Notes, AShortOIsOutEverywhere) {
  write("pendulum.json", kPendulum);
  EXPECT_EQ(mbgen("simulate pendulum.json --engine generic --duration 0.01 -o a.csv").exit_code, 0);
  EXPECT_TRUE(fs::exists(path("a.csv")));
  EXPECT_EQ(mbgen("generate pendulum.json -o pendulum").exit_code, 0);
  EXPECT_TRUE(fs::exists(path("pendulum/pendulum.hpp")));
  EXPECT_EQ(mbgen("equilibrium pendulum.json -o rest.json").exit_code, 0);
  EXPECT_TRUE(fs::exists(path("rest.json")));
  EXPECT_EQ(mbgen("linearize pendulum.json -o linear.json").exit_code, 0);
  EXPECT_TRUE(fs::exists(path("linear.json")));
}

}  // namespace
}  // namespace mbgen::cli_test
