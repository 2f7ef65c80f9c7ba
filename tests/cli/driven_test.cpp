// Driven coordinates and inputs over time, as a user meets them: runs of every engine, energy, tables, messages.

#include <cmath>
#include <functional>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

std::string source(const std::string& path) { return std::string(MBGEN_SOURCE_DIR) + "/" + path; }

std::string text_of(const std::string& path) {
  std::ifstream file(source(path));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class Driven : public CommandLine {
 protected:
  /// The table of a run, and its summary.
  struct Run {
    Table table;
    Json summary;
  };
  Run run(const std::string& arguments) const {
    const Json summary = json_of("simulate " + arguments + " --every 1 --out o.csv --json");
    return {table("o.csv"), summary};
  }

  /// A table of functions of time, one row every dt.
  std::string write_table(const std::string& header, double dt, double end,
                          const std::vector<std::function<double(double)>>& columns) const {
    std::string text = header + "\n";
    for (int k = 0; k * dt <= end + dt / 2; ++k) {
      text += fmt::format("{}", k * dt);
      for (const auto& column : columns) text += fmt::format(",{}", column(k * dt));
      text += "\n";
    }
    return write("table.csv", text);
  }
};

/// Largest difference of a column over its largest value.
double difference(const Table& a, const Table& b, const std::string& name) {
  EXPECT_EQ(a.rows.size(), b.rows.size());
  double largest = 1e-300, error = 0;
  for (std::size_t row = 0; row < std::min(a.rows.size(), b.rows.size()); ++row) {
    largest = std::max(largest, std::abs(b.at(row, name)));
    error = std::max(error, std::abs(a.at(row, name) - b.at(row, name)));
  }
  return error / largest;
}

double difference(const Table& a, const Table& b) {
  EXPECT_EQ(a.names, b.names);
  double worst = 0;
  for (const std::string& name : b.names)
    if (name != "residual [m]") worst = std::max(worst, difference(a, b, name));
  return worst;
}

// Engines differ in what they do inside a step where loops stay open: by less than the order of the method leaves.
TEST_F(Driven, EnginesDriveAlike) {
  for (const char* model : {"driven_five_bar", "driven_base"}) {
    const std::string arguments =
        source(fmt::format("tests/data/models/{}.json", model)) + " --duration 0.2 --step 1e-3";
    const Run generic = run(arguments + " --engine generic");
    for (const char* engine : {"generated", "maggi"}) {
      EXPECT_LT(difference(run(arguments + " --engine " + engine).table, generic.table), 1e-10) << model << engine;
    }
  }
}

TEST_F(Driven, CoordinatesStandAtTheirMotionsAfterEveryStep) {
  const std::string arguments =
      source("tests/data/models/driven_five_bar.json") + " --duration 0.3 --step 3e-3 --engine ";
  for (const char* engine : {"generated", "generic"}) {
    const Table motion = run(arguments + engine).table;
    ASSERT_EQ(motion.rows.size(), 101u);
    for (std::size_t row = 0; row < motion.rows.size(); ++row) {
      const double t = motion.at(row, "t [s]"), lift = 0.06 + t * (0.8 - 1.5 * t), rate = 0.8 - 3 * t;
      constexpr double kRounding = 4e-16;  // of values below 1
      EXPECT_NEAR(motion.at(row, "z.left [rad]"), 0.25 * std::sin(3 * t), kRounding) << engine;
      EXPECT_NEAR(motion.at(row, "zd.left [rad/s]"), 0.75 * std::cos(3 * t), kRounding) << engine;
      EXPECT_NEAR(motion.at(row, "z.right [rad]"), lift + 0.1 * std::sin(lift) * std::cos(2 * t), kRounding) << engine;
      EXPECT_NEAR(motion.at(row, "zd.right [rad/s]"),
                  rate + 0.1 * (std::cos(lift) * rate * std::cos(2 * t) - 2 * std::sin(lift) * std::sin(2 * t)),
                  kRounding)
          << engine;
    }
  }
}

// The work of the drives, integrated by Simpson's rule, is the change of energy, to the order of both.
TEST_F(Driven, PowerOfTheDrivesIsTheEnergyBalance) {
  const std::string four_bar = kFourBar;
  write("four_bar.json", four_bar.substr(0, four_bar.find("\"initial\"")) +
                             R"j("motions": { "turn": { "joint": "crank_pin", "angle": "0.5*sin(4*t)" } } })j");
  for (const std::string& model :
       {std::string("four_bar.json"), source("tests/data/models/driven_five_bar.json"),
        source("tests/data/models/driven_spatial.json"), source("tests/data/models/driven_base.json"),
        source("tests/data/models/driven_cart.json")}) {
    double error[2];
    for (const int refined : {0, 1}) {
      const Json summary =
          run(fmt::format("{} --duration 1 --step {} --engine generic", model, refined == 1 ? 2e-3 : 4e-3)).summary;
      EXPECT_GT(std::abs(summary["work"].get<double>()), 1e-2) << model;
      error[refined] = std::abs(summary["relative_energy_error"].get<double>());
    }
    EXPECT_LT(error[0], 1e-7) << model;
    EXPECT_GT(error[0] / error[1], 12) << model << " " << error[0] << " " << error[1];
  }
}

constexpr double kRide = 4;  // rad/s of the cart's motion 0.3 sin(4 t) m

// The cart moved over time, and by a table of the same motion: steps advance inputs by a parabola, order two.
TEST_F(Driven, TableOfAMotionGivesTheSameTrajectory) {
  const std::string cart = text_of("tests/data/models/driven_cart.json");
  write("by_time.json", replaced(cart, R"("position": "way")", R"j("position": "0.3*sin(4*t)")j"));
  write("by_table.json", cart);
  write_table("t [s],way [m],speed [m/s],acceleration [m/s^2]", 1e-3, 1.2,
              {[](double t) { return 0.3 * std::sin(kRide * t); }, [](double t) { return 1.2 * std::cos(kRide * t); },
               [](double t) { return -4.8 * std::sin(kRide * t); }});
  for (const char* engine : {"generated", "generic", "maggi"}) {
    double error[2];
    for (const int refined : {0, 1}) {
      const std::string how = fmt::format(" --duration 1.2 --step {} --engine {}", refined == 1 ? 1e-2 : 2e-2, engine);
      const Table by_time = run("by_time.json" + how).table;
      const Table by_table = run("by_table.json --input-table table.csv" + how).table;
      EXPECT_LT(difference(by_table, by_time, "z.cart [m]"), 1e-15) << engine;
      EXPECT_LT(difference(by_table, by_time, "zd.cart [m/s]"), 1e-15) << engine;
      error[refined] = difference(by_table, by_time, "z.swing [rad]");
    }
    EXPECT_LT(error[0], 2e-3) << engine;
    EXPECT_GT(error[0] / error[1], 3.5) << engine << " " << error[0] << " " << error[1];
  }
}

// Only the way is recorded: a spline through it gives speed and acceleration.
TEST_F(Driven, SplineGivesTheDerivativesThatATableLeavesOut) {
  const std::string cart = text_of("tests/data/models/driven_cart.json");
  write("by_time.json", replaced(cart, R"("position": "way")", R"j("position": "0.3*sin(4*t)")j"));
  write("by_table.json", cart);
  const std::string how = " --duration 1.2 --step 2e-3 --engine generic";
  const Table by_time = run("by_time.json" + how).table;
  double error[2];
  for (const int refined : {0, 1}) {
    write_table("t,way", refined == 1 ? 0.04 : 0.08, 1.2, {[](double t) { return 0.3 * std::sin(kRide * t); }});
    const Table by_table = run("by_table.json --interpolation spline --input-table table.csv" + how).table;
    EXPECT_LT(difference(by_table, by_time, "z.cart [m]"), 1e-3);
    EXPECT_LT(difference(by_table, by_time, "z.swing [rad]"), 1e-2);
    error[refined] = difference(by_table, by_time, "z.cart [m]");
  }
  EXPECT_GT(error[0] / error[1], 10) << "a cubic spline is of order four";
}

TEST_F(Driven, TableHoldsItsEndsAndInterpolatesBetweenRows) {
  write("cart.json", replaced(text_of("tests/data/models/driven_cart.json"), R"("outputs": {)",
                              R"("outputs": { "torque": { "unit": "N m", "expression": "torque" }, )"));
  write("table.csv", "\xEF\xBB\xBF\"t [s]\" , torque [N m]\r\n0.25,1\r\n\r\n0.75, 3e0\r\n");
  const Table motion =
      run("cart.json --input-table table.csv --input acceleration=0 --duration 1 --step 0.125 --engine generic").table;
  const double expected[] = {1, 1, 1, 1.5, 2, 2.5, 3, 3, 3};
  for (std::size_t row = 0; row < 9; ++row) {
    EXPECT_NEAR(motion.at(row, "torque [N m]"), expected[row], 1e-15);
    EXPECT_NEAR(motion.at(row, "z.cart [m]"), 0.6 * 0.125 * static_cast<double>(row), 1e-15);  // at constant speed
  }
  // One row is a constant.
  write("table.csv", "t,torque\n5,1.25\n");
  EXPECT_EQ(run("cart.json --input-table table.csv --duration 0.1 --engine generic").table.at(3, "torque [N m]"), 1.25);
}

TEST_F(Driven, TablesThatCannotBeUsedAreRefusedByLine) {
  write("cart.json", text_of("tests/data/models/driven_cart.json"));
  const std::pair<std::string, std::string> cases[] = {
      {"", "table.csv: the table has no rows\n"},
      {"t,torque\n", "table.csv: the table has no rows\n"},
      {"time,torque\n0,1\n", "table.csv:1: the first column must be \"t\", found \"time\"\n"},
      {"t [s];torque\n0;1\n",
       "table.csv:1: fields are separated by commas, found semicolons\n"
       "  hint: write the table with commas between fields, and points in numbers\n"},
      {"t [ms],torque\n0,1\n", "table.csv:1: t is in \"s\", found \"ms\"\n"},
      {"t\n0\n", "table.csv:1: there is no column of an input\n"},
      {"t,wind\n0,1\n", "table.csv:1: the model has no input \"wind\"; its inputs: way, speed, acceleration, torque\n"},
      {"t,torque [kN m]\n0,1\n", "table.csv:1: torque is in \"N m\", found \"kN m\"\n"},
      {"t,torque,torque\n0,1,1\n", "table.csv:1: column \"torque\" stands twice\n"},
      {"\nt,torque\n0,1\n0.1\n", "table.csv:4: must have 2 fields like the header, found 1\n"},
      {"t,torque\n0,1\n0.1,strong\n", "table.csv:3: torque: \"strong\" is not a finite number\n"},
      {"t,torque\n0,1e308\n", "table.csv:2: torque: must be at most 1e+15 in magnitude, got 1e308\n"},
      {"t,torque\n0,inf\n", "table.csv:2: torque: \"inf\" is not a finite number\n"},
      {"t,torque\n0,1\nlater,2\n", "table.csv:3: t: \"later\" is not a finite number\n"},
      {"t,torque\n0.2,1\n0.2,2\n", "table.csv:3: t must increase, found 0.2 after 0.2\n"},
      {"t,speed\n0,1\n", "table.csv:1: \"speed\" is the derivative of \"way\", which has no column\n"}};
  for (const auto& [table, message] : cases) {
    write("table.csv", table);
    const Outcome run = mbgen("simulate cart.json --engine generic --input-table table.csv --out o.csv");
    EXPECT_EQ(run.exit_code, 1) << table;
    EXPECT_EQ(run.err, message);
    EXPECT_EQ(run.out, "") << table;
  }
  write("table.csv", "t,way\n0,1\n");
  for (const char* input : {"way=1", "speed=2", "acceleration=3"}) {
    const Outcome run =
        mbgen(fmt::format("simulate cart.json --engine generic --input-table table.csv --out o.csv --input {}", input));
    const std::string name = std::string(input).substr(0, std::string(input).find('='));
    EXPECT_EQ(run.err, fmt::format("--input {0}: table.csv:1: the table has values of {0}\n", name));
  }
  const Outcome missing = mbgen("simulate cart.json --engine generic --input-table none.csv --out o.csv");
  EXPECT_EQ(missing.err, "none.csv: cannot read: No such file or directory\n");
  EXPECT_EQ(leftovers(), (std::vector<std::string>{"cart.json", "table.csv"}));
}

TEST_F(Driven, TwoInputsDoNotGetTheirDerivativeFromTwoSplines) {
  write("cart.json", replaced(text_of("tests/data/models/driven_cart.json"), R"("inputs": {)",
                              R"("inputs": { "other": { "derivative": "speed" },)"));
  write("table.csv", "t,way,other\n0,1,2\n1,2,3\n");
  EXPECT_EQ(mbgen("simulate cart.json --engine generic --input-table table.csv --out o.csv").err,
            "table.csv:1: \"speed\" is the derivative of several columns, give it a column of its own\n");
}

// New inputs start the multistep method anew at every step: what is left is Runge-Kutta.
TEST_F(Driven, MultistepMethodTakesInputsThatChange) {
  write("cart.json", text_of("tests/data/models/driven_cart.json"));
  write_table("t,torque", 0.01, 0.5, {[](double t) { return std::sin(9 * t); }});
  for (const char* engine : {"generated", "generic"}) {
    const std::string how =
        fmt::format("cart.json --input-table table.csv --duration 0.5 --step 5e-3 --engine {} --integrator ", engine);
    EXPECT_LT(difference(run(how + "abm4").table, run(how + "rk4").table), 1e-14) << engine;
  }
}

TEST_F(Driven, StartsWhereTheInputsPutTheMotions) {
  const std::string motions = R"("inputs": { "hold": { "unit": "rad" } },
    "motions": { "hold": { "joint": "crank_pin", "angle": "hold" } }, "initial": { "positions": { "rocker_pin": 0 } })";
  const std::string text = kFourBar;
  const std::string model = text.substr(0, text.find("\"initial\"")) + motions + "}";
  write("four_bar.json", replaced(model, R"({ "positions": { "rocker_pin": 0 } })", "{}"));
  const Table motion = run("four_bar.json --input hold=2.2 --duration 0.01 --engine generic").table;
  EXPECT_EQ(motion.at(0, "z.crank_pin [rad]"), 2.2);
  EXPECT_LT(motion.at(0, "residual [m]"), 1e-12);
  write("four_bar.json", replaced(model, R"("rocker_pin": 0)", R"("crank_pin": 0.5)"));
  const Outcome refused = mbgen("simulate four_bar.json --input hold=0.25 --engine generic --out o.csv");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("initial position of crank_pin contradicts its motion, 0.5 asked, the motion gives 0.25"),
            std::string::npos)
      << refused.err;
}

// 3 kg on 2 m: torque = m l^2 zdd + m g l sin z; positive where it pushes along the coordinate.
TEST_F(Driven, EvaluatePrintsTheDrivingForces) {
  const std::string text = replaced(
      kPendulum, R"("outputs")", R"("motions": { "swing": { "joint": "pin", "angle": "0.5 + 0.1*t^2" } }, "outputs")");
  write("pendulum.json", text);
  write("states.json", R"({ "states": [{ "z": [0.5], "zd": [0], "t": 0, "tau": [7], "inputs": { "torque": 4 } }] })");
  for (const char* engine : {"generated", "generic", "augmented"}) {
    const Json report = json_of(fmt::format("evaluate pendulum.json --states states.json --engine {}", engine));
    const Json& state = report["states"][0];
    EXPECT_NEAR(state["zdd"][0].get<double>(), 0.2, 1e-14);
    EXPECT_NEAR(state["drive"]["swing"].get<double>(), 12 * 0.2 + 3 * 9.81 * 2 * std::sin(0.5) - 4 - 7, 1e-12)
        << engine;
  }
  write("pendulum.json", kPendulum);
  const Json without = json_of("evaluate pendulum.json --states states.json --engine generic");
  EXPECT_FALSE(without["states"][0].contains("drive"));
}

// The coach steered at its pitman arm by recorded steering, against the motion over time that was recorded.
TEST_F(Driven, CoachIsSteeredByATable) {
  const std::string slalom = text_of("models/parts/coach_slalom.json");
  const auto write_coach = [&](const std::string& name, const std::string& drives) {
    write(name + "_drives.json", drives);
    std::string text = text_of("models/coach.json");
    for (const char* part : {"coach_mechanism", "parts/coach_road", "parts/coach_shapes", "tyres/315_80_R22"})
      text = replaced(text, fmt::format("\"{}.json\"", part), fmt::format("\"{}/{}.json\"", source("models"), part));
    write(name + ".json", replaced(text, "parts/coach_slalom.json", name + "_drives.json"));
  };
  write_coach("coach", slalom);
  const std::string by_input =
      replaced(slalom, R"j("steer_amplitude*sin(2*pi*steer_frequency*t)*(1 - exp(-(t/0.4)^2))")j", R"("steer")");
  write_coach("steered", replaced(by_input, R"("motions": {)", R"("inputs": {
    "steer": { "unit": "rad", "derivative": "steer_rate" },
    "steer_rate": { "unit": "rad/s", "derivative": "steer_acceleration" }, "steer_acceleration": { "unit": "rad/s^2" } },
    "motions": {)"));
  write_table("t [s],steer [rad]", 0.01, 0.3, {[](double t) {
                return 0.14 * std::sin(2 * std::acos(-1.0) * 0.4 * t) * (1 - std::exp(-t * t / 0.16));
              }});
  const std::string how = " --duration 0.25 --step 2.5e-3 --engine generic";
  const Run by_time = run("coach.json" + how),
            by_table = run("steered.json --interpolation spline --input-table table.csv" + how);
  EXPECT_LT(difference(by_table.table, by_time.table, "z.pitman_arm [rad]"), 1e-5);
  EXPECT_LT(difference(by_table.table, by_time.table, "yaw_rate [rad/s]"), 1e-4);
  EXPECT_LT(difference(by_table.table, by_time.table, "steering_torque [N m]"), 1e-2);
  // Of what went back and forth in a quarter of a second, a tenth of the coach's kinetic energy.
  EXPECT_LT(std::abs(by_time.summary["relative_energy_error"].get<double>()), 1e-5);
  EXPECT_LT(std::abs(by_table.summary["relative_energy_error"].get<double>()), 1e-5);
}

}  // namespace
}  // namespace mbgen::cli_test
