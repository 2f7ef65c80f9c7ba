// Models that run: evaluate, simulate, bench, and the compiled solvers behind them.

#include <cmath>
#include <future>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

using Names = std::vector<std::string>;

/// Two evaluations of the same formulas round differently in the last digits: a hundred units in the last place.
constexpr double kRounding = 1e-14 * 100;

TEST_F(CommandLine, PendulumAcceleratesAsInTheTextbook) {
  write("pendulum.json", kPendulum);
  write("states.json", R"({"note": "ignored", "states": [
    {"z": [0.3], "zd": [2.0], "tau": [0], "colour": "red"}, {"z": [-1.1]}, {"z": [0], "tau": [6.0]},
    {"z": [0], "inputs": {"torque": 24}}]})");
  const double expected[] = {-9.81 / 2 * std::sin(0.3), 9.81 / 2 * std::sin(1.1), 0.5, 2.0};
  for (const char* engine : kEngines) {
    const Json result = json_of(fmt::format("evaluate pendulum.json --states states.json --engine {}", engine));
    EXPECT_EQ(result["joint_order"], Json({"pin"}));
    ASSERT_EQ(result["states"].size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const Json& state = result["states"][i];
      EXPECT_EQ(state["status"], "ok");
      EXPECT_NEAR(state["zdd"][0].get<double>(), expected[i], kRounding) << engine << " " << i;
      EXPECT_EQ(state["lambda"], Json::array());
      EXPECT_EQ(state["position_residual"], 0.0);
    }
  }
  const Json pushed = json_of("evaluate pendulum.json --states states.json --engine generic --input torque=12");
  EXPECT_NEAR(pushed["states"][2]["zdd"][0].get<double>(), 1.5, kRounding);
}

TEST_F(CommandLine, StatesThatHaveNoAccelerationsSaySo) {
  write("pendulum.json", kPendulum);
  write("states.json", R"({"states": [{"z": [null]}, {"z": [0.1], "zd": [1e300]}, {"z": [0.1]}]})");
  for (const char* engine : kEngines) {
    const Json result = json_of(fmt::format("evaluate pendulum.json --states states.json --engine {}", engine));
    EXPECT_EQ(result["states"][0]["status"], "not a number: pin") << engine;
    EXPECT_TRUE(result["states"][0]["zdd"].is_null());
    EXPECT_TRUE(result["states"][0]["lambda"].is_null());
    EXPECT_EQ(result["states"][2]["status"], "ok");
  }
}

TEST_F(CommandLine, EnginesAgreeOnAProjectedFourBar) {
  write("four_bar.json", kFourBar);
  write("states.json", R"({"states": [
    {"z": [0.3, -0.1, 0.1], "zd": [1, 0, 0], "tau": [0.5, 0, 0]},
    {"z": [-0.4, 0.2, 0], "zd": [-2, 1, 0], "tau": [0, 0.3, -0.2]}]})");
  const Json generated = json_of("evaluate four_bar.json --states states.json --project");
  const Json generic = json_of("evaluate four_bar.json --states states.json --project --engine generic");
  for (std::size_t i = 0; i < 2; ++i) {
    const Json &one = generated["states"][i], &other = generic["states"][i];
    ASSERT_EQ(one["status"], "ok");
    ASSERT_EQ(other["status"], "ok");
    EXPECT_EQ(one["lambda"].size(), 5u);
    EXPECT_EQ(other["lambda"].size(), 5u);
    EXPECT_LT(one["position_residual"].get<double>(), 1e-12);
    EXPECT_LT(one["velocity_residual"].get<double>(), 1e-12);
  }
  // Each engine chooses which coordinates it keeps while it closes the loop, so compare at the same closed state.
  Json closed;
  closed["states"] = Json::array();
  for (const Json& state : generated["states"]) closed["states"].push_back({{"z", state["z"]}, {"zd", state["zd"]}});
  write("closed.json", closed.dump());
  const Json first = json_of("evaluate four_bar.json --states closed.json");
  const Json second = json_of("evaluate four_bar.json --states closed.json --engine generic");
  for (std::size_t i = 0; i < 2; ++i) {
    double scale = 0;
    for (const Json& value : second["states"][i]["zdd"]) scale = std::max(scale, std::abs(value.get<double>()));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(first["states"][i]["zdd"][k].get<double>(), second["states"][i]["zdd"][k].get<double>(),
                  1e-11 * scale);
    }
  }
}

TEST_F(CommandLine, JointOrderIsAnyPermutation) {
  write("four_bar.json", kFourBar);
  write("model.json", R"({"joint_order": ["crank_pin", "elbow", "rocker_pin"],
                          "states": [{"z": [0, 0, 0], "zd": [0.1, 0.2, 0.3], "tau": [1, 2, 3]}]})");
  write("other.json", R"({"joint_order": ["rocker_pin", "crank_pin", "elbow"],
                          "states": [{"z": [0, 0, 0], "zd": [0.3, 0.1, 0.2], "tau": [3, 1, 2]}]})");
  const Json one = json_of("evaluate four_bar.json --states model.json --engine generic");
  const Json other = json_of("evaluate four_bar.json --states other.json --engine generic");
  EXPECT_EQ(other["joint_order"], Json({"rocker_pin", "crank_pin", "elbow"}));
  const std::size_t place[] = {1, 2, 0};  // of crank_pin, elbow, rocker_pin in the other order
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one["states"][0]["zdd"][i], other["states"][0]["zdd"][place[i]]);
  }
  EXPECT_GT(one["states"][0]["velocity_residual"].get<double>(), 1e-3);  // taken as given
}

TEST_F(CommandLine, BadStatesAreNamed) {
  write("four_bar.json", kFourBar);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"({"states": [{"z": [0, 0]}]})", "/states/0/z: must have 3 numbers, found 2"},
      {R"({"states": [{"zd": [0, 0, 0]}]})", "/states/0: \"z\" is missing"},
      {R"({"states": [{"z": [0, "a", 0]}]})", "/states/0/z/1: must be a number, found string"},
      {R"({"states": [{"z": 7}]})", "/states/0/z: must be an array, found number"},
      {R"({"states": [3]})", "/states/0: must be an object, found number"},
      {R"({"states": {}})", "must be an object with an array \"states\""},
      {R"([1])", "must be an object with an array \"states\""},
      {R"({"states": [)", "no JSON"},
      {R"({"states": [{"z": [0, 1e999, 0]}]})", "no JSON"},
      {R"({"joint_order": ["crank_pin", "elbow"], "states": []})", "coordinates are missing: rocker_pin"},
      {R"({"joint_order": ["crank_pin", "elbow", "knee"], "states": []})", "the model has no coordinate \"knee\""},
      {R"({"joint_order": ["elbow", "elbow", "knee"], "states": []})", "coordinate \"elbow\" stands twice"},
      {R"({"joint_ordr": [], "states": []})", "unknown field \"joint_ordr\"; did you mean \"joint_order\"?"},
      {R"({"states": [{"z": [0, 0, 0]}, {"z": [0, 0, 0], "z": [1, 0, 0]}]})", "/states/1/z: stands twice"},
      {R"({"states": [{"z": [0, 0, 0], "tua": [1, 2, 3]}]})", "unknown field \"tua\"; did you mean \"tau\"?"},
      {R"({"states": [{"z": [0, 0, 0], "ZD": [1, 2, 3]}]})", "unknown field \"ZD\"; did you mean \"zd\"?"},
      {R"({"states": [{"z": [0, 0, 0], "inputs": {"wind": 1}}]})", "the model has no input \"wind\""}};
  for (const auto& [text, message] : cases) {
    write("states.json", text);
    const Outcome run = mbgen("evaluate four_bar.json --states states.json --engine generic");
    EXPECT_EQ(run.exit_code, 1) << text;
    EXPECT_EQ(run.out, "") << text;
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    EXPECT_EQ(run.err.rfind("states.json: ", 0), 0u) << run.err;
  }
}

TEST_F(CommandLine, UnknownEnginesListTheOnesThereAre) {
  write("pendulum.json", kPendulum);
  const Outcome run = mbgen("simulate pendulum.json --out o.csv --engine quantum");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(
      run.err,
      "--engine: no engine \"quantum\"; there are: generated, generic, augmented, range-space, null-space, maggi\n");
  EXPECT_EQ(leftovers(), Names{"pendulum.json"});
}

TEST_F(CommandLine, PendulumSwingsBackAfterItsPeriod) {
  write("pendulum.json", kPendulum);
  const double period = 4 * std::sqrt(2 / 9.81) * std::comp_ellint_1(std::sin(0.25));
  for (const char* engine : kEngines) {
    for (const char* integrator : {"rk4", "abm4"}) {
      const Outcome run =
          mbgen(fmt::format("simulate pendulum.json --duration {} --step 1e-3 --out o.csv --engine {} "
                            "--integrator {}",
                            period, engine, integrator));
      ASSERT_EQ(run.exit_code, 0) << run.err;
      EXPECT_EQ(run.err, "");  // no progress bar in a pipe
      const Table motion = table("o.csv");
      EXPECT_EQ(motion.names, (Names{"t [s]", "z.pin [rad]", "zd.pin [rad/s]", "height [m]", "residual [m]"}));
      EXPECT_DOUBLE_EQ(motion.at(0, "z.pin [rad]"), 0.5);
      EXPECT_NEAR(motion.last("t [s]"), period, 1e-12);
      EXPECT_NEAR(motion.last("z.pin [rad]"), 0.5, 1e-10) << engine << integrator;  // (1e-3)^4 times a few tens
      EXPECT_NEAR(motion.last("zd.pin [rad/s]"), 0, 1e-10) << engine << integrator;
      EXPECT_NEAR(motion.last("height [m]"), -2 * std::cos(0.5), 1e-10);
    }
  }
}

TEST_F(CommandLine, SummaryHoldsTheEnergyBalance) {
  write("pendulum.json", kPendulum);
  const Json report =
      json_of("simulate pendulum.json --duration 2 --step 1e-3 --out o.csv --engine generic --input torque=15 --json");
  EXPECT_EQ(report["steps"], 2000);
  EXPECT_EQ(report["rows"], 2001);
  EXPECT_EQ(report["status"], "ok");
  const Table motion = table("o.csv");
  const double work = 15 * (motion.last("z.pin [rad]") - 0.5);  // constant torque times angle
  EXPECT_GT(std::abs(work), 0.1);
  EXPECT_NEAR(report["work"].get<double>(), work, 1e-9);
  EXPECT_NEAR(report["energy_change"].get<double>(), work, 1e-9);
  EXPECT_LT(std::abs(report["energy_error"].get<double>()), 1e-9);
  double lowest = 0;
  for (std::size_t row = 0; row < motion.rows.size(); ++row) lowest = std::min(lowest, motion.at(row, "height [m]"));
  EXPECT_EQ(report["outputs"]["height"]["smallest"].get<double>(), lowest);
}

TEST_F(CommandLine, FourBarStartsWhereAskedAndStaysClosed) {
  write("four_bar.json", kFourBar);
  for (const char* engine : kEngines) {
    const Json report =
        json_of(fmt::format("simulate four_bar.json --duration 1 --step 1e-3 --out o.csv --engine {} --json", engine));
    const Table motion = table("o.csv");
    EXPECT_NEAR(motion.at(0, "z.crank_pin [rad]"), 0.6, 1e-12);
    EXPECT_NEAR(motion.at(0, "zd.crank_pin [rad/s]"), 3, 1e-12);
    EXPECT_LT(report["position_residual"].get<double>(), 1e-12);
    EXPECT_LT(report["velocity_residual"].get<double>(), 1e-11);
    EXPECT_LT(std::abs(report["relative_energy_error"].get<double>()), 1e-8);
  }
}

TEST_F(CommandLine, TableIsDecimatedButKeepsTheEnds) {
  write("pendulum.json", kPendulum);
  ASSERT_EQ(mbgen("simulate pendulum.json --duration 1 --step 0.01 --every 30 --out o.csv --engine generic").exit_code,
            0);
  const Table motion = table("o.csv");
  ASSERT_EQ(motion.rows.size(), 5u);  // 0, 30, 60, 90, 100
  EXPECT_NEAR(motion.at(3, "t [s]"), 0.9, 1e-12);
  EXPECT_NEAR(motion.at(4, "t [s]"), 1.0, 1e-12);
  const Json report = json_of("simulate pendulum.json --duration 1.1 --step 1e-4 --out o.csv --engine generic --json");
  EXPECT_EQ(report["rows"], 11001) << "all, unless the user asks for fewer";
}

TEST_F(CommandLine, BadArgumentsOfSimulateLeaveNoFile) {
  write("pendulum.json", kPendulum);
  for (const char* arguments :
       {"--out missing/o.csv", "--out .", "--out o.csv --step 0", "--out o.csv --step -1", "--out o.csv --duration nan",
        "--out o.csv --duration 0", "--out o.csv --step 1e-300", "--out o.csv --integrator euler",
        "--out o.csv --input torque", "--out o.csv --input wind=1", "--out o.csv --input torque=strong",
        "--out o.csv --every -1"}) {
    const Outcome run = mbgen(fmt::format("simulate pendulum.json --engine generic {}", arguments));
    EXPECT_EQ(run.exit_code, 1) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err, "") << arguments;
  }
  EXPECT_EQ(leftovers(), Names{"pendulum.json"});
}

/// The four-bar with these positions at the start.
std::string four_bar_from(const std::string& positions) {
  std::string text = kFourBar;
  return text.replace(text.find("\"crank_pin\": 0.6"), 16, positions);
}

TEST_F(CommandLine, StartsThatDoNotFitAreMovedAndTold) {
  write("four_bar.json", four_bar_from(R"("crank_pin": { "value": 0.6, "locked": true }, "rocker_pin": -0.9)"));
  const std::string run = "simulate four_bar.json --duration 0.01 --step 1e-3 --out o.csv --engine generic";
  const Outcome told = mbgen(run);
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_TRUE(told.err.starts_with("four_bar.json:")) << told.err;
  EXPECT_NE(told.err.find(": note: initial position of rocker_pin is moved from -0.9 to "), std::string::npos)
      << told.err;
  const Json notes = json_of("check four_bar.json --json")["notes"];
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0]["pointer"], "/initial/positions/rocker_pin");
  const Json moved = json_of(run + " --json")["moved_start"];
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0]["coordinate"], "rocker_pin");
  EXPECT_EQ(moved[0]["quantity"], "position");
  EXPECT_EQ(moved[0]["asked"], -0.9);
  // The crank alone leads to the only closed position at hand.
  write("four_bar.json", four_bar_from(R"("crank_pin": 0.6)"));
  const Json start = json_of("linearize four_bar.json --json")["positions"];
  EXPECT_NEAR(moved[0]["found"].get<double>(), start["rocker_pin"].get<double>(), 1e-9);
}

TEST_F(CommandLine, LocksThatDoNotFitNameTheOpenLoop) {
  write("four_bar.json", four_bar_from(R"("crank_pin": { "value": 0.6, "locked": true },
    "rocker_pin": { "value": -0.9, "locked": true })"));
  for (const char* command :
       {"simulate four_bar.json --duration 1 --step 1e-3 --out o.csv --engine generic", "check four_bar.json"}) {
    const Outcome run = mbgen(command);
    EXPECT_EQ(run.exit_code, 1) << command;
    const std::size_t at =
        run.err.find("the locked positions do not fit together: loop \"tip\" stays open by 138.5 mm");
    EXPECT_NE(at, std::string::npos) << run.err;
    EXPECT_TRUE(run.err.starts_with("four_bar.json:")) << run.err;
  }
  EXPECT_EQ(leftovers(), Names{"four_bar.json"});
}

TEST_F(CommandLine, MotionThatBreaksOffKeepsWhatThereIs) {
  std::string text = kPendulum;  // the torque grows beyond all bounds towards t = 0.5
  text.replace(text.find("\"force\": \"torque\""), 17, "\"force\": \"1/(0.5-t)^2\"");
  write("pendulum.json", text);
  for (const char* engine : kEngines) {
    const Outcome run =
        mbgen(fmt::format("simulate pendulum.json --duration 1 --step 0.125 --out o.csv --engine {}", engine));
    EXPECT_EQ(run.exit_code, 1) << engine;
    EXPECT_NE(run.err.find("stopped after t = 0.375 s: not a number: pin"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("o.csv holds the motion up to there"), std::string::npos) << run.err;
    EXPECT_EQ(table("o.csv").rows.size(), 4u) << engine;
  }
}

TEST_F(CommandLine, BenchComparesTheEngines) {
  write("four_bar.json", kFourBar);
  const Json report = json_of("bench four_bar.json --json --evaluations 2000");
  EXPECT_EQ(report["model"], "four_bar");
  EXPECT_EQ(report["evaluations"], 2000);
  std::vector<std::string> names;
  for (const Json& engine : report["engines"]) {
    names.push_back(engine["name"]);
    if (const std::string library = engine["linear_algebra"]; !library.empty()) names.back() += " " + library;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"generated", "generic entries", "generic eigen", "generic blas",
                                             "generic sparse", "generic eigen qr", "augmented eigen",
                                             "range-space eigen", "null-space eigen", "maggi eigen"}));
  for (const Json& engine : report["engines"]) {
    EXPECT_EQ(engine["batch"], 1);
    EXPECT_GE(engine["evaluations"].get<long>(), 2000);
    EXPECT_GT(engine["us_per_evaluation"].get<double>(), 0);
    EXPECT_LT(engine["max_relative_error"].get<double>(), 1e-9);
  }
}

TEST_F(CommandLine, BenchTimesTheNineSteps) {
  write("four_bar.json", kFourBar);
  const Json engine = json_of("bench four_bar.json --json --evaluations 2000")["engines"][0];
  const std::vector<double> steps = engine["steps"];
  ASSERT_EQ(steps.size(), 9u);
  double sum = 0;
  for (const double step : steps) {
    EXPECT_GE(step, 0);
    sum += step;
  }
  EXPECT_NEAR(sum, engine["us_per_evaluation"].get<double>(), 1e-9 * sum) << "shares of the whole";
  const std::string table = mbgen("bench four_bar.json --evaluations 2000").out;
  for (const char* row : {"1 b, A, J, M; accumulated inertias MR", "9 zdd; driving forces", "elapsed time"}) {
    EXPECT_NE(table.find(row), std::string::npos) << row << " in\n" << table;
  }
}

TEST_F(CommandLine, CompiledSolversAreKeptAndFoundAgain) {
  write("pendulum.json", kPendulum);
  write("compiler",
        "#!/bin/sh\nif [ -e \"$(dirname \"$0\")/broken\" ] && [ \"$1\" != --version ]; then\n"
        "  echo this compiler is broken; exit 1\nfi\nexec c++ \"$@\"\n");
  std::filesystem::permissions(path("compiler"), std::filesystem::perms::owner_all);
  set("CXX", path("compiler").string());
  set("XDG_CACHE_HOME", path("cache").string());
  const std::string run_it = "simulate pendulum.json --duration 0.1 --step 1e-2 --out o.csv";
  std::future<Outcome> beside = std::async(std::launch::async, [&] { return mbgen(run_it, "/dev/null"); });
  const Outcome first = mbgen(run_it);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  ASSERT_EQ(beside.get().exit_code, 0);
  std::vector<std::filesystem::path> kept(std::filesystem::directory_iterator(path("cache/mbgen")), {});
  ASSERT_EQ(kept.size(), 3u);  // the solver, the request that led to it, the decisions, and nothing temporary
  std::ranges::sort(kept, {}, [](const auto& file) { return file.extension() != ".so"; });

  write("broken", "");
  EXPECT_EQ(mbgen(run_it).exit_code, 0);
  const Outcome anew = mbgen(run_it + " --no-cache");
  EXPECT_EQ(anew.exit_code, 2);
  EXPECT_NE(anew.err.find("this compiler is broken"), std::string::npos) << anew.err;

  std::filesystem::remove(path("broken"));
  std::ofstream(kept[0]) << "no shared object";
  EXPECT_EQ(mbgen(run_it).exit_code, 0);  // made again
}

TEST_F(CommandLine, MissingCompilerSuggestsTheGenericEngine) {
  write("pendulum.json", kPendulum);
  set("CXX", "no-such-compiler");
  const Outcome run = mbgen("simulate pendulum.json --duration 0.1 --step 1e-2 --out o.csv");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("--engine generic"), std::string::npos) << run.err;
  EXPECT_EQ(leftovers(), Names{"pendulum.json"});
  EXPECT_EQ(mbgen("simulate pendulum.json --duration 0.1 --step 1e-2 --out o.csv --engine generic").exit_code, 0);
}

}  // namespace
}  // namespace mbgen::cli_test
