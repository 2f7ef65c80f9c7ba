// mbgen simulate --integrator cvode: against published solutions and closed forms, as the judge of steps of one size,
// at rows of inputs and poles of angles, and where a motion cannot go on.

#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class ErrorControl : public CommandLine {
 protected:
  /// The table of a motion by the generic engine; `summary_` holds the summary.
  Table motion(const std::string& model, const std::string& arguments) {
    summary_ = json_of(fmt::format("simulate {} --json --out motion.csv {}{}", model, arguments,
                                   arguments.find("--engine") == std::string::npos ? " --engine generic" : ""));
    return table("motion.csv");
  }
  static std::string model(const std::string& path) { return "'" + kSource + "/" + path + "'"; }
  static Json reference(const std::string& path) {
    return Json::parse(std::ifstream(kSource + "/tests/data/reference/" + path));
  }
  long counted(const char* key) const { return summary_["error_control"][key].get<long>(); }

  Json summary_;
};

// Andrews' squeezer at 0.03 s as the IVP test set publishes it, and the same by quadruple precision.
TEST_F(ErrorControl, MeetsThePublishedSolution) {
  const Json data = reference("andrews.json");
  const char* const order[] = {"beta", "theta", "gamma", "phi", "delta", "omega", "epsilon"};
  for (const std::string integrator : {"cvode", "cvode-adams"}) {
    const Table table = motion(model("models/andrews_squeezer.json"),
                               "--duration 0.03 --step 0.01 --tolerance 1e-12 --integrator " + integrator);
    for (std::size_t i = 0; i < 7; ++i) {
      const double start = std::stod(data["initial"][order[i]].get<std::string>());
      const double angle = table.last(fmt::format("z.{} [rad]", order[i])) + start;
      EXPECT_NEAR(angle, data["published_y_at_0p03"][i].get<double>(), 5e-9) << order[i];
      for (const Json& row : data["rows"]) {
        if (std::abs(std::stod(row["t"].get<std::string>()) - 0.03) > 1e-12) continue;
        EXPECT_NEAR(angle, std::stod(row["q"][i].get<std::string>()), 2e-9) << order[i];
      }
    }
  }
}

// An eigenvalue of -8117 1/s holds Runge-Kutta to steps below 3.4e-4 s; in 10 s it would take 29000.
TEST_F(ErrorControl, StepsFarOverAStiffEigenvalue) {
  const Table table = motion(model("models/iftomm/a05_flyball_governor.json"),
                             "--duration 10 --step 0.1 --integrator cvode --tolerance 1e-9");
  for (const Json& row : reference("a05_flyball.json")["rows_t_s_beta_Omega"]) {
    const auto at = static_cast<std::size_t>(std::lround(10 * row[0].get<double>()));
    EXPECT_NEAR(table.at(at, "slider_height [m]"), row[1].get<double>(), 1e-7) << at;
    EXPECT_NEAR(table.at(at, "shaft_speed [rad/s]"), row[3].get<double>(), 1e-6) << at;
  }
  EXPECT_LT(counted("steps"), 15'000);
  EXPECT_GT(summary_["error_control"]["longest_step"].get<double>(), 3.4e-4);
}

// The error of a fixed step is known by it: order four.
TEST_F(ErrorControl, JudgesFixedSteps) {
  write("four_bar.json", kFourBar);
  const std::string how = "--duration 0.8 --step ";
  const Table judge = motion("four_bar.json", how + "0.02 --integrator cvode --tolerance 1e-12");
  for (const std::string integrator : {"rk4", "abm4"}) {
    double error[2];
    for (const int refined : {0, 1}) {
      const Table fixed =
          motion("four_bar.json", how + (refined == 1 ? "2e-3" : "4e-3") + " --integrator " + integrator);
      error[refined] = std::abs(fixed.last("z.crank_pin [rad]") - judge.last("z.crank_pin [rad]"));
    }
    EXPECT_GT(error[0] / error[1], 11) << integrator << " " << error[0] << " " << error[1];
    EXPECT_LT(error[1], 1e-5) << integrator;
  }
  const Table cartesian = motion("four_bar.json", how + "0.02 --integrator cvode --tolerance 1e-9 --engine augmented");
  expect_same_motion(judge, cartesian, 2e-6);
}

// A mass falls from rest against a damper by a smooth table, which is straight here: v = -g (1 - exp(-10 t)) / 10. The
// start lies on a line of the table, which steps from there found again a hundred times in each row.
TEST_F(ErrorControl, StartsAtACornerOfATable) {
  write("damper.json", R"json({ "mbgen": 1,
    "maps": { "damper": { "x": [0, 1], "y": [-1, 0, 1], "z": [[10, 0, -10], [10, 0, -10]],
                          "interpolation": "monotone_cubic", "outside": "hold" } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "mass": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "z": { "type": "prismatic", "from": "ground.O", "to": "mass.O", "axis": "z" } },
    "joint_forces": { "damper": { "joint": "z", "force": "table('damper', 0.5, zd.z)" } } })json");
  const Table table = motion("damper.json", "--duration 0.02 --step 1e-3 --integrator cvode --tolerance 1e-11");
  EXPECT_NEAR(table.last("zd.z [m/s]"), 0.981 * std::expm1(-0.2), 1e-9);
  EXPECT_LT(counted("restarts"), 10);
}

// A controller every 10 ms, with a delay, and a sensor every 15 ms: steps stop at each instant. Runge-Kutta's method is
// exact on the parabolas between them; tests/fmi holds that motion against its difference equation.
TEST_F(ErrorControl, StopsAtInstantsOfSampledValues) {
  const std::string slide = model("tests/data/fmi/sampled_slide.json");
  const Table fixed = motion(slide, "--duration 0.5 --step 2.5e-3");
  for (const std::string how : {"--engine generic", "--engine augmented", "--integrator cvode-adams"}) {
    const Table controlled = motion(slide, "--duration 0.5 --step 2.5e-3 --tolerance 1e-11 " + how +
                                               (how[2] == 'i' ? "" : " --integrator cvode"));
    EXPECT_EQ(counted("restarts"), 49 + 33 - 16) << how;  // of 10 ms, 15 ms, and both
    EXPECT_LT(summary_["relative_energy_error"].get<double>(), 1e-6) << how;
    for (std::size_t row = 0; row <= 200; ++row) {
      EXPECT_NEAR(controlled.at(row, "z.slide [m]"), fixed.at(row, "z.slide [m]"), 1e-8) << how << row;
      EXPECT_NEAR(controlled.at(row, "x.force [N]"), fixed.at(row, "x.force [N]"), 1e-5) << how << row;
      EXPECT_NEAR(controlled.at(row, "x.seen [m]"), fixed.at(row, "x.seen [m]"), 1e-8) << how << row;
    }
  }
}

// A force that is held between rows makes parabolas, which steps of high order meet exactly, and start anew at the
// rows.
TEST_F(ErrorControl, StartsAnewAtRowsOfInputs) {
  write("pushed.json", R"({ "mbgen": 1, "gravity": [0, 0, 0], "inputs": { "push": { "unit": "N" } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "cart": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "cart.O", "axis": "x" } },
    "joint_forces": { "push": { "joint": "x", "force": "push" } } })");
  write("push.csv", "t [s],push [N]\n0,2\n0.3337,-6\n0.71,4\n");
  const Table table = motion("pushed.json",
                             "--duration 1 --step 0.25 --integrator cvode --tolerance 1e-10 --input-table push.csv "
                             "--interpolation hold");
  double x = 0, v = 0;
  for (const auto& [push, time] : {std::pair{2.0, 0.3337}, {-6.0, 0.71 - 0.3337}, {4.0, 0.29}}) {
    x += time * (v + time * push / 4);
    v += time * push / 2;
  }
  EXPECT_NEAR(table.last("z.x [m]"), x, 1e-9);
  EXPECT_NEAR(table.last("zd.x [m/s]"), v, 1e-9);
  EXPECT_EQ(counted("restarts"), 2);
}

// A brick that tumbles through the poles of its angles keeps its energy and its angular momentum about a fixed axis.
TEST_F(ErrorControl, ChangesChartsOfBalls) {
  write("thrown.json", R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "brick": { "mass": 3, "inertia": [0.01, 0.02, 0.025], "points": { "O": [0, 0, 0] } } },
    "joints": { "throw": { "type": "spherical", "from": "ground.O", "to": "brick.O" } },
    "outputs": { "energy": { "body": "brick", "quantity": "kinetic_energy" },
                 "spin": { "body": "brick", "quantity": "angular_momentum", "axis": "y" } },
    "initial": { "orientations":
      { "throw": { "rotation_vector": [0, 0.5, 0], "angular_velocity": [0.1, 12, 0] } } } })");
  const Table table = motion("thrown.json", "--duration 2 --step 0.05 --integrator cvode --tolerance 1e-11");
  for (const char* kept : {"energy [J]", "spin [kg m^2/s]"})
    EXPECT_NEAR(table.last(kept) / table.at(0, kept), 1, 1e-8) << kept;
  EXPECT_GE(counted("restarts"), 4);
}

// A crank that is driven beyond the reach of its rod: the table ends there, and the message says when and why.
TEST_F(ErrorControl, SaysWhenAndWhyAMotionEnds) {
  const std::string four_bar = kFourBar;
  write("driven.json", four_bar.substr(0, four_bar.find("\"initial\"")) +
                           R"j("motions": { "turn": { "joint": "rocker_pin", "angle": "-0.5*t" } } })j");
  const Outcome end =
      mbgen("simulate driven.json --duration 10 --step 0.1 --integrator cvode --engine generic --out motion.csv");
  EXPECT_EQ(end.exit_code, 1);
  EXPECT_NE(end.err.find("stopped after t = "), std::string::npos) << end.err;
  EXPECT_NE(end.err.find(": tip (At t = 2.30"), std::string::npos) << end.err;
  const Outcome wrong = mbgen("simulate driven.json --integrator rk4 --tolerance 1e-3 --out motion.csv");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("--tolerance: goes with --integrator cvode"), std::string::npos) << wrong.err;
}

// A block that sticks on an incline stands for 1000 s where its bristles bent to.
TEST_F(ErrorControl, BlockOnAnInclineStandsForAThousandSeconds) {
  write("block.json", R"j({ "mbgen": 1, "gravity": ["9.81*sin(0.3)", 0, "-9.81*cos(0.3)"],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                "block": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "block.O", "axis": "x" } },
    "frictions": { "floor": { "joint": "x", "law": "elasto_plastic", "coulomb": "0.6*2*9.81*cos(0.3)",
                              "stiffness": 1e5, "damping": 600 } } })j");
  const Table table = motion("block.json", "--duration 1000 --step 100 --integrator cvode --tolerance 1e-10");
  const double bent = 2 * 9.81 * std::sin(0.3) / 1e5;
  for (std::size_t row = 1; row < table.rows.size(); ++row) EXPECT_NEAR(table.at(row, "z.x [m]"), bent, 1e-8) << row;
}

/// Period of a mass that a spring drags at a speed over rigid friction with a viscous part: it slides from where the
/// spring pulls with the stiction until it stands, and sticks until the spring pulls so again. 1 kg.
double dragged_period(double spring, double speed, double coulomb, double stiction, double viscous) {
  // The spring's length e: e'' + viscous e' + spring e = coulomb + viscous speed; it stands where e' = speed.
  const double decay = viscous / 2, omega = std::sqrt(spring - decay * decay);
  const double rest = (coulomb + viscous * speed) / spring, a = stiction / spring - rest,
               b = (speed + decay * a) / omega;
  const auto length = [&](double t) {
    return rest + std::exp(-decay * t) * (a * std::cos(omega * t) + b * std::sin(omega * t));
  };
  const auto rate = [&](double t) {
    return std::exp(-decay * t) *
           ((b * omega - decay * a) * std::cos(omega * t) - (a * omega + decay * b) * std::sin(omega * t));
  };
  double low = std::numbers::pi / (2 * omega), high = 3 * low;  // shortening, lengthening fast
  for (int k = 0; k < 60; ++k) (rate((low + high) / 2) < speed ? low : high) = (low + high) / 2;
  return low + (stiction / spring - length(low)) / speed;
}

// LuGre's friction at the numbers of its authors (1 kg, 1e5 N/m, sqrt(1e5) N s/m, 0.4 N s/m, 1 and 1.5 N, 1 mm/s, a
// spring of 2 N/m that is drawn at 0.1 m/s): it begins to slide at 1.5 N and goes on by stick and slip. Bristles slide
// a little before, so that it breaks loose at less, and Stribeck's curve falls over a little way: the period is 1.4 %
// shorter than that of rigid friction, at any tolerance. Stiffer bristles and a narrower curve come to 0.3 %.
TEST_F(ErrorControl, LuGreSticksAndSlipsAtItsAuthorsNumbers) {
  struct Law {
    const char *stiffness, *stribeck;
    double tolerance;
  };
  for (const Law law : {Law{"1e5", "1e-3", 0.02}, Law{"1e7", "1e-4", 0.005}}) {
    write("lugre.json", R"j({ "mbgen": 1, "gravity": [0, 0, 0],
      "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                  "hand": { "mass": 1, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } },
                  "mass": { "mass": 1, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
      "joints": { "y": { "type": "prismatic", "from": "ground.O", "to": "hand.O", "axis": "x" },
                  "x": { "type": "prismatic", "from": "ground.O", "to": "mass.O", "axis": "x" } },
      "motions": { "y": { "joint": "y", "position": "0.1*t" } },
      "joint_springs": { "spring": { "joint": "x", "relative_to": "y", "stiffness": 2 } },
      "frictions": { "floor": { "joint": "x", "law": "lugre", "coulomb": 1, "stiction": 1.5, "viscous": 0.4, "lag": 0,
        "stribeck_velocity": )j" +
                            std::string(law.stribeck) + ", \"stiffness\": " + law.stiffness + ", \"damping\": \"sqrt(" +
                            law.stiffness + ")\" } } }");
    const Table table = motion("lugre.json", "--duration 40 --step 0.01 --integrator cvode --tolerance 1e-8");
    std::vector<double> sliding;  // s, when the mass came to half the speed of the hand
    for (std::size_t row = 1; row < table.rows.size(); ++row)
      if (table.at(row - 1, "zd.x [m/s]") < 0.05 && table.at(row, "zd.x [m/s]") >= 0.05)
        sliding.push_back(table.at(row, "t [s]"));
    ASSERT_GE(sliding.size(), 4u);
    EXPECT_NEAR(sliding[0], 7.5, 0.15);
    const double period = (sliding.back() - sliding[0]) / static_cast<double>(sliding.size() - 1);
    EXPECT_NEAR(period / dragged_period(2, 0.1, 1, 1.5, 0.4), 1, law.tolerance);
  }
}

}  // namespace
}  // namespace mbgen::cli_test
