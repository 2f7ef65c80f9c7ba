// Derivatives of motions against mechanisms that were computed in complex arithmetic with multipliers (reference),
// closed forms and differences.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Sensitivities : public CommandLine {
 protected:
  static Json reference(const std::string& mechanism) {
    return Json::parse(std::ifstream(kSource + "/tests/data/reference/sensitivities.json"))[mechanism];
  }

  /// Largest error of the derivatives of each reference column, over its largest value.
  double worst_of(const std::string& mechanism, const std::vector<std::string>& columns, const std::string& options,
                  const std::string& file) {
    const Json data = reference(mechanism);
    std::string names;
    for (const std::string name : data["free"]) names += (names.empty() ? "" : ",") + name;
    const Outcome run = mbgen("simulate '" + kSource + "/models/sensitivities/" + mechanism + ".json' --out " + file +
                              " --sensitivities " + names + " " + options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Table table = this->table(file);
    const std::size_t steps = (table.rows.size() - 1) / 20;
    double worst = 0;
    for (std::size_t p = 0; p < data["free"].size(); ++p) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        double error = 0, largest = 0;
        const std::size_t column = column_of(table, columns[c], data["free"][p]);
        for (std::size_t k = 0; k < 21; ++k) {
          const double expected = data["derivatives"][p][k][c];
          error = std::max(error, std::abs(table.rows[k * steps][column] - expected));
          largest = std::max(largest, std::abs(expected));
        }
        EXPECT_GT(largest, 0) << columns[c];
        worst = std::max(worst, error / largest);
      }
    }
    return worst;
  }

  /// Largest error of the derivatives by a parameter of this value, over the largest one of an output, against central
  /// differences of motions of the generic engine that CVODE integrates.
  double worst_beside_cvode(const std::string& model, const std::string& name, double value, double part,
                            const std::string& integrator, const std::string& times) {
    const std::string run = "simulate '" + kSource + "/models/" + model + ".json' " + times;
    const Outcome tangents = mbgen(run + " --out by.csv --sensitivities " + name + " --integrator " + integrator);
    EXPECT_EQ(tangents.exit_code, 0) << tangents.err;
    const Table by = table("by.csv");
    Table sides[2];
    for (const int side : {0, 1}) {
      const double at = value * (side == 0 ? 1 - part : 1 + part);
      const Outcome judge = mbgen(fmt::format(
          "{} --out at.csv --engine generic --integrator cvode --tolerance 1e-12 --set {}={}", run, name, at));
      EXPECT_EQ(judge.exit_code, 0) << judge.err;
      sides[side] = table("at.csv");
    }
    double worst = 0;
    for (const std::string& heading : sides[0].names) {
      const std::string output = heading.substr(0, heading.find(" ["));
      const bool is_output = std::ranges::any_of(
          by.names, [&](const std::string& column) { return column.starts_with("d(" + output + ")/d("); });
      if (!is_output) continue;
      const std::size_t column = column_of(by, output, name);
      double error = 0, largest = 0;
      for (std::size_t row = 0; row < by.rows.size(); ++row) {
        const double difference = (sides[1].at(row, heading) - sides[0].at(row, heading)) / (2 * part * value);
        error = std::max(error, std::abs(by.rows[row][column] - difference));
        largest = std::max(largest, std::abs(difference));
      }
      EXPECT_GT(largest, 0) << output;
      worst = std::max(worst, error / largest);
    }
    return worst;
  }

  static std::size_t column_of(const Table& table, const std::string& output, const std::string& parameter) {
    const std::string name = "d(" + output + ")/d(" + parameter + ") [";
    for (std::size_t c = 0; c < table.names.size(); ++c)
      if (table.names[c].starts_with(name)) return c;
    ADD_FAILURE() << "no column " << name;
    return 0;
  }
};

const std::vector<std::string> kFourBarColumns = {"crank",   "crank_rate", "crank_acceleration",
                                                  "coupler", "rocker",     "cost"};
const std::vector<std::string> kFiveBarColumns = {"angle_1", "angle_4", "rate_1", "rate_4", "x_2", "y_2", "cost"};

TEST_F(Sensitivities, FourBarByEightParameters) {
  const double fine = worst_of("four_bar", kFourBarColumns, "--step 1e-3", "fine.csv");
  EXPECT_LT(fine, 1e-7);
  const double coarse = worst_of("four_bar", kFourBarColumns, "--step 4e-3", "coarse.csv");
  EXPECT_GT(coarse / fine, 64);  // of order four: 256
  EXPECT_LT(worst_of("four_bar", kFourBarColumns, "--step 5e-4 --integrator abm4", "abm4.csv"), 1e-7);
}

TEST_F(Sensitivities, FourBarByImplicitSteps) {
  const double fine = worst_of("four_bar", kFourBarColumns, "--step 1e-3 --integrator rosenbrock", "fine.csv");
  EXPECT_LT(fine, 1e-4);
  EXPECT_GT(worst_of("four_bar", kFourBarColumns, "--step 4e-3 --integrator rosenbrock", "coarse.csv") / fine, 16);
}

TEST_F(Sensitivities, FiveBarByLengthsAndMasses) {
  const double fine = worst_of("five_bar", kFiveBarColumns, "--step 1e-3", "fine.csv");
  EXPECT_LT(fine, 1e-6);
  EXPECT_GT(worst_of("five_bar", kFiveBarColumns, "--step 4e-3", "coarse.csv") / fine, 64);
}

/// Oil of 1.2e9 Pa, a valve with a lag and a sampled controller.
TEST_F(Sensitivities, OfAHydraulicArmAreThoseOfCvode) {
  const std::string times = "--duration 0.5 --step 2.5e-4 --every 40";
  EXPECT_LT(worst_beside_cvode("hydraulic_arm", "edge", 3.6e-7, 1e-4, "rk4", times), 1e-5);
  EXPECT_LT(worst_beside_cvode("hydraulic_arm", "leak", 4e-12, 1e-4, "rk4", times), 1e-6);
}

/// A corner of a vehicle in rubber, with modes up to 730 Hz.
TEST_F(Sensitivities, OfACornerInRubberAreThoseOfCvode) {
  const auto worst = [&](const std::string& integrator, const std::string& steps) {
    return worst_beside_cvode("rubber_wishbone", "cornering", 2500, 3e-3, integrator, "--duration 0.3 " + steps);
  };
  EXPECT_LT(worst("rk4", "--step 2e-5 --every 500"), 1e-4);
  EXPECT_LT(worst("rosenbrock", "--step 2.5e-4 --every 40"), 1e-2);  // of its acceleration; 1e-4 of all else
}

/// A mass that hangs on two springs in a row of bodies, at rest: by the closed form.
TEST_F(Sensitivities, AStaticEquilibriumMovesWithItsParameters) {
  write("hung.json", R"json({
    "mbgen": 1, "name": "hung", "gravity": [0, 0, "-g"],
    "parameters": { "k": { "value": 500, "unit": "N/m" }, "m": { "value": 3, "unit": "kg", "tunable": true },
                    "g": { "value": 9.81, "unit": "m/s^2" } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "S": [0, 0, 1] } },
                "mass": { "mass": "m", "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "mass.O", "axis": "z" } },
    "springs": { "spring": { "from": "mass.O", "to": "ground.S", "stiffness": "k", "damping": 2, "free_length": 0.9 } },
    "outputs": { "height": { "joint": "slide", "quantity": "position" } },
    "initial": { "equilibrium": true },
    "solver": { "integrator": "rk4", "step": 1e-3, "duration": 0.1 }
  })json");
  const Outcome run = mbgen("simulate hung.json --sensitivities k,m,g --out hung.csv");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Table table = this->table("hung.csv");
  // k (1 - z - 0.9) = m g.
  for (const std::size_t row : {std::size_t{0}, table.rows.size() - 1}) {
    EXPECT_NEAR(table.rows[row][column_of(table, "height", "k")], 3 * 9.81 / (500.0 * 500), 1e-12);
    EXPECT_NEAR(table.rows[row][column_of(table, "height", "m")], -9.81 / 500, 1e-11);
    EXPECT_NEAR(table.rows[row][column_of(table, "height", "g")], -3.0 / 500, 1e-12);
  }
}

/// Fewer given positions than freedoms: independent coordinates stay beside them, as where the start is closed; a pose
/// that is only the nearest one to a given value is refused.
TEST_F(Sensitivities, AStartHoldsWhatItIsClosedFrom) {
  std::ifstream stream(kSource + "/models/sensitivities/five_bar.json");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  const auto started = [&](const std::string& positions) {
    const std::size_t first = text.find("\"initial\""), last = text.find("\"solver\"");
    write("started.json",
          text.substr(0, first) + "\"initial\": { \"positions\": { " + positions + " } },\n" + text.substr(last));
    return mbgen("simulate started.json --sensitivities l2 --duration 0.001 --out by.csv");
  };
  const Outcome by_independent = started("\"pin_2\": 0.2");
  ASSERT_EQ(by_independent.exit_code, 0) << by_independent.err;
  const auto at_start = [&](const std::string& l2) {
    EXPECT_EQ(
        mbgen("simulate started.json --engine generic --duration 0.001 --set l2=" + l2 + " --out at.csv").exit_code, 0);
    return table("at.csv").at(0, "x_2 [m]");
  };
  const double difference = (at_start("1.5001") - at_start("1.4999")) / 2e-4;
  const Table by = table("by.csv");
  EXPECT_NEAR(by.rows[0][column_of(by, "x_2", "l2")], difference, 1e-8);
  const Outcome nearest = started("\"pin_1\": 0.3");
  EXPECT_EQ(nearest.exit_code, 1);
  EXPECT_NE(nearest.err.find("do not tell which coordinates are held"), std::string::npos) << nearest.err;
}

TEST_F(Sensitivities, RefusesWhatHasNoDerivatives) {
  const auto refused = [&](const std::string& options, const std::string& text) {
    const Outcome run = mbgen("simulate '" + kSource + "/models/sensitivities/four_bar.json' --out f.csv " + options);
    EXPECT_EQ(run.exit_code, 1) << options;
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("f.csv")));
  };
  refused("--sensitivities l4", "--sensitivities: the model has no parameter \"l4\"; did you mean \"l2\"?");
  refused("--sensitivities k --engine generic", "--sensitivities is of the generated solver");
  refused("--sensitivities k --integrator cvode", "--sensitivities needs a fixed step");
}

/// A parallelogram that turns through its singular position: d(ax)/d(m) was 1.98 there, where differences give 1.38.
TEST_F(Sensitivities, PastASingularPositionAreDoubted) {
  write("parallelogram.json", R"({ "mbgen": 1, "name": "parallelogram",
    "parameters": { "m": { "value": 2, "tunable": true } },
    "bodies": { "ground": { "points": { "A": [0, 0, 0], "D": [1, 0, 0] } },
      "crank": { "mass": 1, "com": [0, 0, 0.1], "inertia": [0.1, 0.1, 0.1],
                 "points": { "A": [0, 0, 0], "B": [0, 0, 0.4] } },
      "rod": { "pose": { "origin": [0, 0, 0.4] }, "mass": "m", "com": [0.3, 0, 0], "inertia": [0.1, 0.1, 0.1],
               "points": { "B": [0, 0, 0], "C": [1, 0, 0] } },
      "rocker": { "pose": { "origin": [1, 0, 0] }, "mass": 1, "com": [0, 0, 0.2], "inertia": [0.1, 0.1, 0.1],
                  "points": { "D": [0, 0, 0], "C": [0, 0, 0.4] } } },
    "joints": { "a": { "type": "revolute", "from": "ground.A", "to": "crank.A", "axis": "y" },
      "b": { "type": "revolute", "from": "crank.B", "to": "rod.B", "axis": "y" },
      "d": { "type": "revolute", "from": "ground.D", "to": "rocker.D", "axis": "y" },
      "c": { "type": "revolute", "from": "rod.C", "to": "rocker.C", "axis": "y" } },
    "outputs": { "a": { "joint": "a" } }, "initial": { "velocities": { "a": 9 } } })");
  const std::string run = "simulate parallelogram.json --sensitivities m --step 2e-3 --out a.csv --duration ";
  const Outcome past = mbgen(run + "0.4");
  EXPECT_EQ(past.exit_code, 0) << past.err;
  EXPECT_NE(past.err.find("are not exact: the motion passed a singular position"), std::string::npos) << past.err;
  EXPECT_EQ(mbgen(run + "0.1").err.find("are not exact"), std::string::npos);
}

// Closed form: with the jump of -b at x = s the velocity at the end is u - b (T - (s - x0) / u), so its derivative by s
// is b / u = 60; that of the steps is 0. A kink at the same place, and a jump at an instant that does not move, are
// exact.
TEST_F(Sensitivities, PastAJumpAreDoubted) {
  const auto warned = [&](const std::string& force, const std::string& parameter) {
    write("jump.json", R"({ "mbgen": 1, "gravity": [0, 0, 0],
      "parameters": { "s": { "value": 0.00505 }, "b": { "value": 6 } },
      "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
                  "m": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
      "joints": { "x": { "type": "prismatic", "from": "ground.A", "to": "m.A", "axis": "x" } },
      "joint_forces": { "f": { "joint": "x", "force": ")" +
                           force + R"(" } },
      "initial": { "velocities": { "x": 0.1 } }, "outputs": { "v": { "joint": "x", "quantity": "velocity" } } })");
    const Outcome run =
        mbgen("simulate jump.json --step 1e-3 --duration 0.06 --out jump.csv --sensitivities " + parameter);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.err.find("derivatives after t = 0.051 s are not exact: a law jumps there") != std::string::npos;
  };
  EXPECT_TRUE(warned("-b*step(z.x - s)", "s"));
  EXPECT_FALSE(warned("-b*step(t - 0.051) - 9*b*max(z.x - s, 0)", "b"));
}

}  // namespace
}  // namespace mbgen::cli_test
