// A solver is compiled when the equations of a model change, and only then.

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

namespace fs = std::filesystem;

class KeptSolver : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    set("XDG_CACHE_HOME", path("cache").string());
  }

  std::size_t kept() const {
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(path("cache/mbgen")))
      if (entry.path().extension() == ".so") ++count;
    return count;
  }

  /// Simulates with the kept solver, whose motion is that of the generic engine.
  void expect_own_motion(const std::string& arguments) {
    const std::string command = "simulate " + arguments + " --duration 0.02 --step 1e-2 --out ";
    const Outcome run = mbgen(command + "kept.csv");
    ASSERT_EQ(run.exit_code, 0) << arguments << run.err;
    ASSERT_EQ(mbgen(command + "judge.csv --engine generic").exit_code, 0) << arguments;
    const std::vector<double> kept = last_row("kept.csv"), judge = last_row("judge.csv");
    ASSERT_EQ(kept.size(), judge.size()) << arguments;
    for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_NEAR(kept[i], judge[i], 1e-10) << arguments;
  }

  std::vector<double> last_row(const std::string& table) const {
    const std::string text = read(table);
    std::istringstream row(text.substr(text.rfind('\n', text.size() - 2) + 1));
    std::vector<double> values;
    for (std::string word; std::getline(row, word, ',');) values.push_back(std::stod(word));
    return values;
  }
};

/// A pendulum with a place for each thing that is no equation.
std::string pendulum(const std::string& head, const std::string& mass, const std::string& initial,
                     const std::string& torque, const std::string& end) {
  return R"({ "mbgen": 1, "name": "pendulum", )" + head + R"(
  "gravity": [0, 0, -9.81],
  "parameters": { "mass": { "value": )" +
         mass + R"(, "unit": "kg", "tunable": true } },
  "inputs": { "torque": { "unit": "N m", "default": )" +
         torque + R"( } },
  "bodies": {
    "ground": { "points": { "O": [0, 0, 0] } },
    "bob": { "mass": "mass", "com": [0, 0, -2], "inertia": [0, 0, 0], "points": { "O": [0, 0, 0], "tip": [0, 0, -2] } }
  },
  "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "bob.O", "axis": "y" } },
  "joint_forces": { "motor": { "joint": "pin", "force": "torque" } },
  "outputs": { "height": { "unit": "m", "point": "bob.tip", "quantity": "position", "axis": "z" } },
  "initial": { "positions": { "pin": )" +
         initial + " } }" + end + "}\n";
}

TEST_F(KeptSolver, ServesEveryModelOfItsEquations) {
  const std::pair<const char*, std::string> models[] = {
      {"plain.json", pendulum("", "3", "0.5", "0", "")},
      {"comment.json", "// longer\n" + pendulum("/* and here */", "3", "0.5", "0", "")},
      {"described.json", pendulum(R"("description": "swings",)", "3", "0.5", "0", "")},
      {"heavy.json", pendulum("", "5", "0.5", "0", "")},
      {"high.json", pendulum("", "3", "1.5", "0", "")},
      {"pushed.json", pendulum("", "3", "0.5", "7.5", "")},
      {"red.json", pendulum("", "3", "0.5", "0",
                            R"(, "shapes": { "ball": { "type": "sphere", "from": "bob.tip", "radius": 0.1,
                               "colour": "#ff0000" } })")}};
  for (const auto& [name, text] : models) {
    write(name, text);
    expect_own_motion(name);
  }
  expect_own_motion("plain.json --set mass=4");
  expect_own_motion("plain.json --input torque=-2");
  EXPECT_EQ(kept(), 1u);
}

TEST_F(KeptSolver, IsFoundWithoutTranslatingAgain) {
  write("plain.json", pendulum("", "3", "0.5", "0", ""));
  expect_own_motion("plain.json");
  std::vector<fs::path> requests;
  for (const fs::directory_entry& entry : fs::directory_iterator(path("cache/mbgen")))
    if (entry.path().extension() == ".request") requests.push_back(entry.path());
  ASSERT_EQ(requests.size(), 1u);
  // A request that leads to another solver of that name shows that the way is taken, and nothing else.
  const std::string own = read("cache/mbgen/" + requests[0].filename().string());
  fs::copy_file(path("cache/mbgen/" + own), path("cache/mbgen/other.so"));
  std::ofstream(requests[0]) << "other.so";
  fs::remove(path("cache/mbgen/" + own));
  expect_own_motion("plain.json");
  EXPECT_EQ(kept(), 1u);
  // Requests that lead nowhere, or out of the cache, are as none.
  for (const char* name : {"gone.so", "", "../other.so", "/tmp/x.so"}) {
    std::ofstream(requests[0], std::ios::trunc) << name;
    expect_own_motion("plain.json");
    EXPECT_EQ(read("cache/mbgen/" + requests[0].filename().string()), own) << name;
  }
}

TEST_F(KeptSolver, IsTakenByAutoWithOneQuestionToTheCompiler) {
  write("plain.json", pendulum("", "3", "0.5", "0", ""));
  write("cxx", "#!/bin/sh\necho \"$*\" >>'" + path("questions").string() + "'\nexec c++ \"$@\"\n");
  fs::permissions(path("cxx"), fs::perms::owner_all);
  set("CXX", path("cxx").string());
  expect_own_motion("plain.json");
  fs::remove(path("questions"));
  const Outcome run = mbgen("simulate plain.json --engine auto --duration 0.02 --step 1e-2 --out auto.csv");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("simulate: engine generated: its solver is kept\n"), std::string::npos) << run.err;
  EXPECT_EQ(read("questions"), "--version\n");
}

TEST_F(KeptSolver, IsOneOfRegularPositionsUntilAMotionLeavesThem) {
  const std::string robot = "simulate '" + kSource + "/models/delta.json' --step 2e-3 --out ";
  const std::string chosen = "coordinates chosen again";
  Outcome run = mbgen(robot + "short.csv --duration 0.2");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.find(chosen), std::string::npos) << run.out;
  EXPECT_EQ(kept(), 1u);
  for (const char* integrator : {"rk4", "abm4"}) {
    SCOPED_TRACE(integrator);
    const std::string options = fmt::format(" --duration 0.44 --integrator {}", integrator);
    fs::remove_all(path("cache"));
    run = mbgen(robot + "long.csv" + options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find(chosen), std::string::npos) << run.out;
    EXPECT_EQ(kept(), 2u);
    // From now on the whole solver serves from the start.
    EXPECT_EQ(mbgen(robot + "whole.csv" + options).exit_code, 0);
    EXPECT_EQ(kept(), 2u);
    EXPECT_EQ(read("long.csv"), read("whole.csv"));
  }
  EXPECT_EQ(mbgen(robot + "whole.csv --duration 0.2").exit_code, 0);
  EXPECT_EQ(read("whole.csv"), read("short.csv"));
}

TEST_F(KeptSolver, IsListedRemovedAndLimited) {
  write("plain.json", pendulum("", "3", "0.5", "0", ""));
  expect_own_motion("plain.json");
  Outcome listed = mbgen("cache");
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_NE(listed.out.find(": 1 solver, "), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find(" MB of at most 1024 MB\n"), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find("pendulum-"), std::string::npos) << listed.out;
  const auto json = nlohmann::json::parse(mbgen("cache --json").out);
  EXPECT_EQ(json.at("solvers").size(), 1u);
  EXPECT_EQ(json.at("bytes"), json.at("solvers")[0].at("bytes"));
  // A limit that holds one solver: the one that was used last stays.
  const double size = json.at("bytes").get<double>() / (1 << 20);
  EXPECT_EQ(mbgen(fmt::format("cache --limit {}", 1.5 * size)).exit_code, 0);
  std::string longer = pendulum("", "3", "0.5", "0", "");
  longer.replace(longer.find("[0, 0, -2]"), 10, "[0, 0, -3]");
  write("longer.json", longer);
  expect_own_motion("longer.json");
  EXPECT_EQ(kept(), 1u);
  listed = mbgen("cache --clean");
  EXPECT_NE(listed.out.find(": 0 solvers, 0.0 MB"), std::string::npos) << listed.out;
  EXPECT_EQ(kept(), 0u);
  EXPECT_EQ(mbgen("cache --limit -1").err, "--limit: must be from 0 to 1073741824 MB, found -1\n");
}

TEST_F(KeptSolver, MakesRoomAndSaysSoOnce) {
  write("plain.json", pendulum("", "3", "0.5", "0", ""));
  expect_own_motion("plain.json");
  fs::path old;
  for (const fs::directory_entry& entry : fs::directory_iterator(path("cache/mbgen")))
    if (entry.path().extension() == ".so") old = entry.path();
  // A solver of last year that takes all the room.
  fs::copy_file(old, old.parent_path() / "large.so");
  fs::resize_file(old.parent_path() / "large.so", std::uintmax_t{1} << 30);
  fs::last_write_time(old.parent_path() / "large.so", fs::file_time_type::clock::now() - std::chrono::hours(8760));
  for (const char* length : {"-3]", "-4]"}) {
    std::string longer = pendulum("", "3", "0.5", "0", "");
    longer.replace(longer.find("-2]"), 3, length);
    write("longer.json", longer);
    const Outcome run = mbgen("simulate longer.json --duration 0.02 --step 1e-2 --out o.csv");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err.find("the least recently used solver made room") != std::string::npos,
              std::string(length) == "-3]")
        << run.err;
  }
  EXPECT_EQ(kept(), 3u);
  EXPECT_FALSE(fs::exists(old.parent_path() / "large.so"));
}

TEST_F(KeptSolver, IsOfOneSetOfEquations) {
  write("plain.json", pendulum("", "3", "0.5", "0", ""));
  expect_own_motion("plain.json");
  std::string longer = pendulum("", "3", "0.5", "0", "");
  longer.replace(longer.find("[0, 0, -2]"), 10, "[0, 0, -3]");
  write("longer.json", longer);
  expect_own_motion("longer.json");
  EXPECT_EQ(kept(), 2u);
}

/// The coach: its width is for manoeuvres, its speed a start value.
TEST_F(KeptSolver, ServesManoeuvresOfEverySpeed) {
  const std::string models = kSource + "/models/";
  write("fast.json", R"({ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": 22, "lateral_acceleration": 2 })");
  write("slow.json", R"({ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": 15, "lateral_acceleration": 2 })");
  for (const char* manoeuvre : {"fast.json", "slow.json"}) {
    const Outcome run = mbgen(fmt::format(
        "simulate '{}coach_driver.json' --manoeuvre {} --duration 0.02 --step 1e-3 --out o.csv", models, manoeuvre));
    EXPECT_LE(run.exit_code, 1) << run.err;
    EXPECT_EQ(kept(), 1u) << run.err;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
