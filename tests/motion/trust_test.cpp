// Checks that keep a wrong result from passing for a good one: the step against the model, tables against themselves,
// rows against time, an equilibrium that there is not.

#include <cmath>

#include "tests/support/cli_support.hpp"
#include "workbench/motion/course.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen::cli_test {
namespace {

class Trust : public CommandLine {
 protected:
  std::string text_of(const std::string& path) const {
    std::ifstream file(kSource + "/" + path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }
};

// The points of a table and what scipy.interpolate.PchipInterpolator (scipy 1.10.1) gives: t, value, derivative.
TEST(Course, PchipIsThatOfScipy) {
  constexpr double kScipy[][3] = {{0, 0, 0},
                                  {0.25, 0.016599876695437728, 0.13566584463625153},
                                  {0.6, 0.10139482120838469, 0.35449568434032058},
                                  {1.1, 0.55864673242910023, 3.4760326757090017},
                                  {1.15, 0.71527377466091258, 2.5262908446362538},
                                  {1.5, 0.78500000000000003, 0},
                                  {2.6, 0.43827999999999989, -0.94560000000000011},
                                  {3.5, -0.20000000000000001, 0},
                                  {3.75, -0.053676470588235284, 0.88529411764705901},
                                  {4.5, 0.12435661764705881, 0.039154411764705875},
                                  {5.9, 0.1499169117647059, 0.0016838235294117515}};
  const Course course = pchip({0, 1, 1.2, 2, 3.5, 4, 6}, {0, 0.3, 0.785, 0.785, -0.2, 0.1, 0.15});
  const Course rate = derivative(course);
  for (const auto& [t, value, slope] : kScipy) {
    EXPECT_NEAR(course.at(t), value, 1e-14) << t;
    EXPECT_NEAR(rate.at(t), slope, 1e-13) << t;
  }
}

// Both ends of a piece have the derivatives that were given: x^5, whose first three orders fix it.
TEST(Course, HermiteMeetsAllOrders) {
  const std::vector<double> t = {0.5, 1, 3};
  std::vector<std::vector<double>> orders(3);
  for (const double x : t) {
    orders[0].push_back(std::pow(x, 5));
    orders[1].push_back(5 * std::pow(x, 4));
    orders[2].push_back(20 * std::pow(x, 3));
  }
  const Course course = hermite(t, orders);
  for (const double x : {0.5, 0.7, 1.0, 1.9, 3.0}) {
    EXPECT_NEAR(course.at(x), std::pow(x, 5), 1e-12 * std::pow(3, 5)) << x;
    EXPECT_NEAR(derivative(course).at(x), 5 * std::pow(x, 4), 1e-11 * std::pow(3, 5)) << x;
  }
}

// The ends of the regions of stability, as textbooks give them: RK4 2.785 and 2.828; for PECE of order four -1.25
// (Hall, Watt, Modern Numerical Methods for ODEs, 1976).
TEST(StepVerdict, RegionsOfStability) {
  using Integrator = SolverSettings::Integrator;
  const auto stable = [](Integrator integrator, std::complex<double> z) {
    return growth_of_step(integrator, z) <= 1 + 1e-12;
  };
  EXPECT_TRUE(stable(Integrator::rk4, -2.785));
  EXPECT_FALSE(stable(Integrator::rk4, -2.786));
  EXPECT_TRUE(stable(Integrator::rk4, {0, 2.828}));
  EXPECT_FALSE(stable(Integrator::rk4, {0, 2.829}));
  EXPECT_TRUE(stable(Integrator::abm4, -1.2));
  EXPECT_FALSE(stable(Integrator::abm4, -1.3));
  for (const double z : {-1e-3, -1.0, -1e3, -1e9}) EXPECT_TRUE(stable(Integrator::rosenbrock, z)) << z;
  EXPECT_TRUE(stable(Integrator::rosenbrock, {0, 1e3}));
  EXPECT_NEAR(growth_of_step(Integrator::rosenbrock, -1e9), 0, 1e-8) << "L-stable";
}

constexpr const char* kRamp = "t,way\n0,0\n1,0\n1.2,0.785\n6,0.785\n";

TEST_F(Trust, TablesStayWithinTheirRows) {
  write("cart.json", text_of("tests/data/models/driven_cart.json"));
  write("table.csv", kRamp);
  const std::string simulate =
      "simulate cart.json --engine generic --input-table table.csv --duration 6 --step 5e-3 --out o.csv ";
  for (const char* kind : {"", "--interpolation pchip", "--interpolation linear", "--interpolation hold"}) {
    const Outcome run = mbgen(simulate + kind + " --json");
    const Json summary = Json::parse(run.out, nullptr, false);
    EXPECT_EQ(run.err.find("leaves"), std::string::npos) << run.err;
    EXPECT_EQ(summary["inputs"]["way"]["smallest"], 0) << kind;
    EXPECT_EQ(summary["inputs"]["way"]["largest"], 0.785) << kind;
    EXPECT_EQ(summary["inputs"]["way"]["last"], 0.785) << kind;
  }
  const Outcome spline = mbgen(simulate + "--interpolation spline");
  EXPECT_NE(spline.err.find("table.csv:1: warning: way leaves its column, 0 to 0.785, by "), std::string::npos)
      << spline.err;
  // Through four points the spline is one cubic, that of Lagrange's formula.
  const auto lagrange = [](double x) {
    const double t[] = {0, 1, 1.2, 6}, y[] = {0, 0, 0.785, 0.785};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      double term = y[i];
      for (int k = 0; k < 4; ++k) term *= k == i ? 1 : (x - t[k]) / (t[i] - t[k]);
      sum += term;
    }
    return sum;
  };
  double farthest = 0, at = 0;
  for (int k = 0; k <= 6000; ++k) {
    if (lagrange(1e-3 * k) > farthest) farthest = lagrange(at = 1e-3 * k);
  }
  const std::size_t place = spline.err.find(" at t = ");
  ASSERT_NE(place, std::string::npos) << spline.err;
  EXPECT_NEAR(std::stod(spline.err.substr(place + 8)), at, 4.8 / 64);
  EXPECT_NE(spline.err.find(" s, between lines 4 and 5: it is applied from "), std::string::npos) << spline.err;
  const std::size_t by = spline.err.find(", by ");
  EXPECT_NEAR(std::stod(spline.err.substr(by + 5)), farthest - 0.785, 2e-3 * farthest);
  EXPECT_NE(spline.err.find("hint: --interpolation pchip and linear stay within the rows\n"), std::string::npos)
      << spline.err;
  EXPECT_NE(spline.out.find("input "), std::string::npos) << spline.out;
  EXPECT_EQ(mbgen(simulate + "--interpolation cubic").err,
            "--interpolation: no interpolation \"cubic\"; there are: pchip, linear, spline, hold\n");
  EXPECT_EQ(mbgen("simulate cart.json --engine generic --interpolation hold --out o.csv").err,
            "--interpolation: goes with --input-table, found none\n");
}

// Accelerations of the drive jump at the rows: no energy comes of that, and no warning.
TEST_F(Trust, RowsCostNoEnergy) {
  write("cart.json", text_of("tests/data/models/driven_cart.json"));
  write("table.csv", "t,way\n0,0\n0.25,0.02\n0.5,0.1\n0.75,0.24\n1,0.4\n1.25,0.54\n1.5,0.62\n1.75,0.64\n2,0.64\n");
  const Outcome run =
      mbgen("simulate cart.json --engine generic --input-table table.csv --duration 2 --step 1e-3 --out o.csv --json");
  EXPECT_EQ(run.err, "");
  EXPECT_LT(std::abs(Json::parse(run.out)["relative_energy_error"].get<double>()), 1e-6);
}

TEST_F(Trust, RatesBelongToTheirValues) {
  write("cart.json", text_of("tests/data/models/driven_cart.json"));
  const std::string simulate =
      "simulate cart.json --engine generic --input-table table.csv --duration 1 --step 0.01 --out o.csv";
  write("table.csv", "t,way,speed\n0,0,0\n1,0,0\n1.2,0.785,0\n6,0.785,0\n");
  EXPECT_EQ(mbgen(simulate).err,
            "table.csv:4: speed contradicts way: from t = 1 to 1.2 s way changes by 0.785 m, speed makes 0 m of it\n"
            "  hint: leave out the column speed, it then follows from way\n");
  // Degrees instead of radians, a sign, zeros: refused. Four rows a period of a sine are enough for right ones.
  const auto sine = [&](int rows_a_period, double factor) {
    std::string text = "t,way,speed\n";
    for (int k = 0; k <= 2 * rows_a_period; ++k) {
      const double t = k * 2 * std::acos(-1.0) / rows_a_period;
      text += fmt::format("{},{},{}\n", t, std::sin(t + 0.3), factor * std::cos(t + 0.3));
    }
    write("table.csv", text);
    return mbgen(simulate).exit_code;
  };
  for (const int rows : {4, 5, 40}) {
    EXPECT_EQ(sine(rows, 1), 0) << rows;
    for (const double factor : {57.3, -1.0, 0.0}) EXPECT_EQ(sine(rows, factor), 1) << rows << " " << factor;
  }
  EXPECT_EQ(sine(40, 1.5), 1);
  write("table.csv", "t,way,acceleration\n0,0,0\n1,1,0\n");
  EXPECT_EQ(mbgen(simulate).err, "table.csv:1: \"acceleration\" is the derivative of \"speed\", which has no column\n");
}

/// 1 kg on a spring along z.
std::string mass_on_spring(double stiffness) {
  return fmt::format(R"({{ "mbgen": 1, "name": "mass", "gravity": [0, 0, 0],
    "bodies": {{ "ground": {{ "points": {{ "A": [0, 0, 0] }} }},
                 "block": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0] }} }} }},
    "joints": {{ "slide": {{ "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "z" }} }},
    "joint_springs": {{ "spring": {{ "joint": "slide", "stiffness": {} }} }},
    "initial": {{ "positions": {{ "slide": 0.01 }} }} }})",
                     stiffness);
}

TEST_F(Trust, StepThatIsTooLongIsAnError) {
  write("mass.json", mass_on_spring(8.2e6));
  for (const char* integrator : {"rk4", "abm4"}) {
    const std::string simulate = fmt::format(
        "simulate mass.json --engine generic --integrator {} --duration 0.2 --out o.csv --json", integrator);
    const Outcome run = mbgen(simulate + " --step 1e-3");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("the values blew up, slide reached "), std::string::npos) << run.err;
    EXPECT_NE(
        run.err.find("step 0.001 s is too long; the fastest mode at the start, 455.8 Hz (slide +1.00), needs steps"),
        std::string::npos)
        << run.err;
    const Json summary = Json::parse(run.out, nullptr, false);
    EXPECT_EQ(summary["status"], "values blew up");
    EXPECT_EQ(summary["warnings"].size(), 1u);
    const double stable = summary["stable_step"].get<double>(), fitting = summary["fitting_step"].get<double>();
    EXPECT_LT(stable, 1e-3);
    // The advised step serves; a step that is stable and no more is warned of.
    const Outcome good = mbgen(simulate + fmt::format(" --step {}", fitting));
    EXPECT_EQ(good.exit_code, 0);
    EXPECT_EQ(good.err, "") << integrator << fitting;
    EXPECT_LT(std::abs(Json::parse(good.out)["relative_energy_error"].get<double>()), 1e-3);
    const Outcome stable_only = mbgen(simulate + fmt::format(" --step {}", 0.9 * stable));
    EXPECT_EQ(stable_only.exit_code, 1) << stable_only.err;
    EXPECT_NE(stable_only.err.find("simulate: the energy balance is off by "), std::string::npos) << stable_only.err;
    EXPECT_NE(stable_only.err.find("; o.csv holds the motion"), std::string::npos) << stable_only.err;
    const Json lost = Json::parse(stable_only.out);
    EXPECT_TRUE(lost["status"].get<std::string>().starts_with("energy balance off by ")) << lost["status"];
    EXPECT_GT(std::abs(lost["relative_energy_error"].get<double>()), 0.1);
    EXPECT_NEAR(table("o.csv").rows.back()[0], 0.2, 1e-12) << "the table is whole";
    const double part = integrator == std::string("rk4") ? 0.1 : 0.4;
    const Outcome less = mbgen(simulate + fmt::format(" --step {}", part * stable));
    EXPECT_EQ(less.exit_code, 0) << less.err;
    EXPECT_NE(less.err.find("simulate: warning: the energy balance is off by "), std::string::npos) << less.err;
    EXPECT_EQ(Json::parse(less.out)["status"], "1 warning");
  }
}

// At rest, between springs without gravity, all energies are rounding: their error says nothing.
TEST_F(Trust, RestIsNoTrouble) {
  write("rest.json", R"({ "mbgen": 1, "name": "rest", "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "A": [0, 0, 0], "P": [1, 0.3, 0.2], "Q": [-0.7, 0.9, -0.1], "R": [0.1, -1.1, 0.4] } },
                "block": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "block": { "type": "free", "from": "ground.A", "to": "block.A" } },
    "springs": { "p": { "from": "ground.P", "to": "block.A", "stiffness": 1e3, "preload": 100, "damping": 30 },
                 "q": { "from": "ground.Q", "to": "block.A", "stiffness": 1e3, "preload": 120, "damping": 30 },
                 "r": { "from": "ground.R", "to": "block.A", "stiffness": 1e3, "preload": 90, "damping": 30 } },
    "initial": { "equilibrium": true } })");
  const Outcome run = mbgen("simulate rest.json --engine generic --duration 0.5 --step 1e-3 --out o.csv");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
}

// A case of a study that blew up has no values.
TEST_F(Trust, CasesThatBlowUpHaveNoValues) {
  std::string model = mass_on_spring(1);
  model.replace(model.find("\"stiffness\": 1 "), 14, "\"stiffness\": \"k\"");
  model.replace(model.find("\"bodies\""), 0, "\"parameters\": { \"k\": { \"value\": 1 } }, ");
  write("mass.json", model);
  const Outcome run = mbgen(
      "sweep mass.json --engine generic --vary k=1e3,8.2e6 --metric \"max(z.slide)\" --duration 0.2 --step 1e-3 --out "
      "s.csv");
  const std::string table = read("s.csv");
  EXPECT_NE(table.find("values blew up"), std::string::npos) << table << run.err;
  EXPECT_NE(table.find(",ok"), std::string::npos) << table;
}

// A linkage at a step of a third of its turn: the loop does not close, for the step.
TEST_F(Trust, StopForTheStepSaysSo) {
  std::string model = kFourBar;
  model.replace(model.find("\"crank_pin\": 3"), 14, "\"crank_pin\": 60");
  write("four_bar.json", model);
  const std::string simulate = "simulate four_bar.json --engine generic --duration 0.6 --out o.csv --step ";
  const Outcome run = mbgen(simulate + "0.1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("stopped after t = "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("  hint: step 0.1 s is too long; the fastest mode at the start, "), std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("; --step 0.002 would do\n"), std::string::npos) << run.err;
  // There it goes on, with an energy balance that is off by 0.15 % of what the bars exchange; half of it is quiet.
  EXPECT_EQ(mbgen(simulate + "2e-3").exit_code, 0);
  EXPECT_EQ(mbgen(simulate + "1e-3").err, "");
}

// The coach's solver holds other coordinates than the generic engine: the modes of the start are the same.
TEST_F(Trust, FastestModeIsThatOfTheModelWhateverTheEngine) {
  std::string said[2];
  for (int k = 0; k < 2; ++k) {
    const Outcome run = mbgen(fmt::format(
        "simulate '{}/models/coach.json' --integrator abm4 --duration 0.3 --step 1e-2 --out o.csv --engine {}", kSource,
        kEngines[k]));
    EXPECT_EQ(run.exit_code, 1);
    const std::size_t at = run.err.find("the fastest mode at the start, "), end = run.err.find("needs steps", at);
    ASSERT_NE(end, std::string::npos) << run.err;
    said[k] = run.err.substr(at, end - at);
  }
  EXPECT_EQ(said[0], said[1]);
}

TEST_F(Trust, TimeIsTheStepsNumberTimesTheStep) {
  write("pendulum.json", kPendulum);
  for (const char* integrator : {"rk4", "abm4"}) {
    const std::string simulate = fmt::format(
        "simulate pendulum.json --engine generic --integrator {} --duration 12 --step 1e-3 --out o.csv", integrator);
    const Outcome run = mbgen(simulate);
    EXPECT_NE(run.out.find("(12001 rows, every step)"), std::string::npos) << run.out;
    const Table all = table("o.csv");
    ASSERT_EQ(all.rows.size(), 12001u);
    for (std::size_t k = 0; k < all.rows.size(); ++k) ASSERT_EQ(all.rows[k][0], static_cast<double>(k) / 1000);
    EXPECT_NE(mbgen(simulate + " --every 5000").out.find("(4 rows, every 5000 steps and the last)"), std::string::npos);
    EXPECT_EQ(table("o.csv").rows.back()[0], 12.0);
  }
}

// A multistep method goes on from step to step although the time is no sum: two evaluations, not the four of a start.
TEST_F(Trust, MultistepMethodGoesOn) {
  write("pendulum.json", kPendulum);
  const std::string simulate =
      "simulate pendulum.json --engine generic --duration 2 --step 2e-2 --out o.csv --integrator ";
  ASSERT_EQ(mbgen(simulate + "abm4").exit_code, 0);
  const double by_abm4 = table("o.csv").last("z.pin [rad]");
  ASSERT_EQ(mbgen(simulate + "rk4").exit_code, 0);
  EXPECT_GT(std::abs(table("o.csv").last("z.pin [rad]") - by_abm4), 1e-9) << "started anew it would be Runge-Kutta";
}

TEST_F(Trust, MissingEquilibriumIsExplained) {
  write("mass.json", R"({ "mbgen": 1, "name": "mass",
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
                "block": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "z" } },
    "initial": { "equilibrium": true } })");
  const std::string message =
      "mass.json: there is no static equilibrium near the initial state: slide -9.81 m/s^2 is the largest "
      "acceleration; "
      "the "
      "search came to slide -4.95 m\n"
      "  hint: nothing holds slide of joint \"slide\" (mass.json:4:17): a spring, a tyre or a joint may be missing\n";
  EXPECT_EQ(mbgen("simulate mass.json --engine generic --out o.csv").err, message);
  EXPECT_EQ(mbgen("check mass.json").err, message);
}

TEST_F(Trust, ParametersAreSetFromTheCommandLine) {
  std::string model = kPendulum;
  model.replace(model.find("\"inputs\""), 0,
                "\"parameters\": { \"mass\": { \"value\": 3 }, \"reach\": { \"value\": 2, \"tunable\": true } }, ");
  model.replace(model.find("\"mass\": 3,"), 10, "\"mass\": \"mass\",");
  model.replace(model.find("[0, 0, -2]"), 10, "[0, 0, \"-reach\"]");
  write("pendulum.json", model);
  const std::string simulate = "simulate pendulum.json --engine generic --duration 1 --step 0.01 --out o.csv --json";
  const Json as_written = json_of(simulate);
  const Json set = json_of(simulate + " --set reach=1 --set mass=1");
  EXPECT_NEAR(set["energy_change"].get<double>(), 0, 1e-6);
  EXPECT_NE(set["outputs"], as_written["outputs"]);
  EXPECT_EQ(Json::parse(read("o.csv.run.json"))["set"], Json({"reach=1", "mass=1"}));
  // As if it stood in the file.
  const Table by_option = table("o.csv");
  model.replace(model.find("\"value\": 3"), 10, "\"value\": 1");
  model.replace(model.find("\"value\": 2"), 10, "\"value\": 1");
  write("pendulum.json", model);
  ASSERT_EQ(mbgen(simulate).exit_code, 0);
  EXPECT_EQ(by_option.rows, table("o.csv").rows);
  EXPECT_EQ(mbgen(simulate + " --set raech=1").err,
            "--set: the model has no parameter \"raech\"; did you mean \"reach\"?\n");
  EXPECT_EQ(mbgen(simulate + " --set reach").err, "--set: \"reach\" is not of the form name=value\n");
  EXPECT_EQ(mbgen(simulate + " --set reach=1 --set reach=2").err, "--set: \"reach\" stands twice\n");
  EXPECT_EQ(mbgen(simulate + " --set reach=long").err, "--set reach: \"long\" is not a finite number\n");
}

// A wheel that is pulled at 3 m/s over the end of a road that has no height there: by the border modes of the standard.
TEST_F(Trust, ARoadThatIsLeftIsNamed) {
  write("short.crg",
        "$ROAD_CRG\nREFERENCE_LINE_INCREMENT = 1\n$\n$ROAD_CRG_OPTS\nBORDER_MODE_U = 0\n$\n$KD_Definition\n#:LRFI\n"
        "D:long section at v = -1,m\nD:long section at v = 1,m\n$$$$\n 0.0000000 0.0000000\n 0.0000000 0.0000000\n");
  write("cart.json", R"({ "mbgen": 1, "name": "cart", "bodies": { "ground": { "points": { "o": [0.0994, 0, 0.28] } },
    "hub": { "mass": 10, "com": [0.0994, 0, 0.28], "inertia": [1, 1, 1], "points": { "o": [0.0994, 0, 0.28] } } },
    "joints": { "hub": { "type": "prismatic", "from": "ground.o", "to": "hub.o", "axis": "x" } },
    "tyre_data": { "rubber": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000, "PCX1": 1.6,
      "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 } } },
    "roads": { "short": { "crg": { "file": "short.crg" } } },
    "tyres": { "front": { "centre": "hub.o", "data": "rubber", "stiffness": 1e5, "friction": 0, "rolling_resistance": 0 } },
    "initial": { "velocities": { "hub": 3 } } })");
  for (const char* engine : {"generated", "generic", "augmented"}) {
    const Outcome run =
        mbgen(std::string("simulate cart.json --step 1e-3 --duration 1 --out o.csv --engine ") + engine);
    EXPECT_EQ(run.exit_code, 1) << engine;
    EXPECT_NE(run.err.find("stopped after t = 0.3 s"), std::string::npos) << engine << run.err;
    EXPECT_NE(run.err.find("hint: tyre \"front\" leaves the road \"short\" beyond its end (u = 1.00"),
              std::string::npos)
        << engine << run.err;
    EXPECT_NE(run.err.find("v = 0 m), where that has no height: beyond_ends is \"refuse\""), std::string::npos);
  }
}

}  // namespace
}  // namespace mbgen::cli_test
