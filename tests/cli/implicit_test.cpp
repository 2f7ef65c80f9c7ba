// The linearly implicit integrator as users meet it: stiff models at steps that Runge-Kutta does not bear; arms in
// rubber against the error-controlled motion.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

TEST_F(CommandLine, ImplicitStepsOfAStiffModelAreThoseOfTheGenericRuntime) {
  const std::string command = "simulate " + kSource +
                              "/models/iftomm/a05_flyball_governor.json --duration 0.1 "
                              "--step 1e-3 --out o.csv --integrator ";
  ASSERT_EQ(mbgen(command + "rosenbrock --engine generic").exit_code, 0);
  const double generic = table("o.csv").last("z.arm_right [rad]");
  const Outcome implicit = mbgen(command + "rosenbrock");
  ASSERT_EQ(implicit.exit_code, 0) << implicit.err;
  EXPECT_EQ(implicit.err, "") << "no warning of a step that is too long";
  EXPECT_NEAR(table("o.csv").last("z.arm_right [rad]"), generic, 1e-12);

  const Outcome explicit_one = mbgen(command + "rk4");
  EXPECT_EQ(explicit_one.exit_code, 1);
  EXPECT_NE(explicit_one.err.find("step 0.001 s is too long; the fastest mode at the start, decay at 8117 1/s"),
            std::string::npos)
      << explicit_one.err;
}

// A mass on a rod of 1e8 N/m, 1 m long, that turns at 2 rad/s, in the axes of the ground, beside a pendulum in whose
// energy its own is lost. By closed form it is at 1 m and 2 rad after 1 s; steps of 1 ms let it come 0.036 rad too far.
TEST_F(CommandLine, ImplicitStepsOfARodThatTurnsAreNotTrusted) {
  const auto write_rod = [&](double stiffness) {
    write("rod.json", fmt::format(R"({{ "mbgen": 1, "name": "rod", "gravity": [0, 0, -9.81],
      "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0], "P": [0, 5, 2] }} }},
        "mass": {{ "mass": 1, "inertia": [0.01, 0.01, 0.01], "points": {{ "O": [0, 0, 0] }} }},
        "bob": {{ "mass": 200, "com": [1, 5, 2], "inertia": [0.01, 0.01, 0.01], "points": {{ "P": [0, 5, 2] }} }} }},
      "joints": {{ "at": {{ "type": "planar", "from": "ground.O", "to": "mass.O", "axis": "z" }},
        "bob": {{ "type": "revolute", "from": "ground.P", "to": "bob.P", "axis": "y" }} }},
      "springs": {{ "rod": {{ "from": "ground.O", "to": "mass.O", "stiffness": {}, "free_length": 1 }} }},
      "initial": {{ "positions": {{ "at_tx": {:.17g} }}, "velocities": {{ "at_ty": {:.17g} }} }} }})",
                                  stiffness, 1 / (1 - 4 / stiffness), 2 / (1 - 4 / stiffness)));
  };
  const auto run = [&](double step) {
    const Json summary =
        json_of(fmt::format("simulate rod.json --engine generic --integrator rosenbrock --duration 1 --step {} --every "
                            "1000 --out o.csv --json",
                            step));
    const double phase = std::atan2(table("o.csv").last("z.at_ty [m]"), table("o.csv").last("z.at_tx [m]"));
    return std::pair(summary, std::abs(phase - 2));
  };
  write_rod(1e8);
  const auto [told, far] = run(1e-3);
  EXPECT_GT(far, 0.01);
  EXPECT_EQ(told["status"], "1 warning");
  EXPECT_NE(told["warnings"].dump().find("by two half steps in place of one the rate of at_t"), std::string::npos)
      << told["warnings"];
  write_rod(1e5);
  const auto [trusted, near] = run(1e-3);
  EXPECT_LT(near, 0.001);
  EXPECT_EQ(trusted["status"], "ok") << trusted["warnings"];
}

TEST_F(CommandLine, IntegratorThatSuitsTheModesOfTheStart) {
  const std::string governor = "simulate " + kSource +
                               "/models/iftomm/a05_flyball_governor.json --duration 0.01 --out o.csv --engine generic "
                               "--json --integrator auto --step ";
  const Outcome coarse = mbgen(governor + "1e-3"), fine = mbgen(governor + "1e-4");
  EXPECT_EQ(Json::parse(coarse.out)["integrator"], "rosenbrock");
  EXPECT_EQ(coarse.err.find("simulate: integrator rosenbrock: the fastest mode at the start, decay at 8117 1/s"), 0u)
      << coarse.err;
  EXPECT_EQ(Json::parse(fine.out)["integrator"], "rk4");
  EXPECT_EQ(fine.err, "simulate: integrator rk4: it bears every mode at the start\n");
}

/// A model whose arms sit in rubber, and the points whose accelerations count.
struct InRubber {
  std::string model;
  double duration;  ///< s
  std::vector<std::string> points;
};

void PrintTo(const InRubber& c, std::ostream* out) { *out << c.model << " " << c.duration << " s"; }

/// Errors of one table against another one over the motion, each as a part of the largest value of its quantity.
struct LargestErrors {
  double positions = 0, accelerations = 0;
  std::string position, acceleration;  ///< where they are
};

class ImplicitInRubber : public CommandLine, public ::testing::WithParamInterface<InRubber> {
 protected:
  /// The model with outputs "pointN_x" to "pointN_z" for the acceleration of each point.
  void write_model() const {
    std::string outputs;
    for (std::size_t i = 0; i < GetParam().points.size(); ++i)
      for (const char axis : {'x', 'y', 'z'})
        outputs += fmt::format(R"({}"point{}_{}": {{ "point": "{}", "quantity": "acceleration", "axis": "{}" }})",
                               outputs.empty() ? "" : ", ", i, axis, GetParam().points[i], axis);
    write("rubber.json", fmt::format(R"({{ "mbgen": 1, "name": "rubber", "include": ["{}/models/{}.json"],
      "outputs": {{ {} }} }})",
                                     kSource, GetParam().model, outputs));
  }
  Outcome run(const std::string& integrator) const {
    return mbgen(
        fmt::format("simulate rubber.json --engine generic --duration {} --step 1e-3 --out o.csv --integrator {}",
                    GetParam().duration, integrator));
  }
  Table motion(const std::string& integrator) const {
    const Outcome end = run(integrator);
    EXPECT_EQ(end.exit_code, 0) << end.err;
    return table("o.csv");
  }
  /// Every coordinate by itself; accelerations as vectors.
  LargestErrors errors(const Table& table, const Table& judge) const {
    LargestErrors result;
    const auto part = [&](const std::vector<std::size_t>& columns) {
      double error = 0, largest = 0;
      for (std::size_t row = 0; row < judge.rows.size(); ++row) {
        double value = 0, difference = 0;
        for (const std::size_t c : columns) {
          value = std::hypot(value, judge.rows[row][c]);
          difference = std::hypot(difference, table.rows[row][c] - judge.rows[row][c]);
        }
        largest = std::max(largest, value);
        error = std::max(error, difference);
      }
      return error / largest;
    };
    const auto keep = [](double error, const std::string& name, double& largest, std::string& where) {
      if (error <= largest) return;
      largest = error;
      where = name;
    };
    for (std::size_t c = 0; c < judge.names.size(); ++c)
      if (judge.names[c].starts_with("z.")) keep(part({c}), judge.names[c], result.positions, result.position);
    for (std::size_t i = 0; i < GetParam().points.size(); ++i) {
      const std::size_t x = judge.column(fmt::format("point{}_x [m/s^2]", i));
      keep(part({x, x + 1, x + 2}), GetParam().points[i], result.accelerations, result.acceleration);
    }
    return result;
  }
};

TEST_P(ImplicitInRubber, MeetsTheErrorControlledMotionAtAMillisecond) {
  write_model();
  const Table judge = motion("cvode --tolerance 1e-9"), table = motion("rosenbrock");
  ASSERT_EQ(table.rows.size(), judge.rows.size());
  const LargestErrors error = errors(table, judge);
  std::printf("%s, %g s at 1 ms: positions %.4f %% (%s), accelerations %.3f %% (%s)\n", GetParam().model.c_str(),
              GetParam().duration, 100 * error.positions, error.position.c_str(), 100 * error.accelerations,
              error.acceleration.c_str());
  EXPECT_LT(error.positions, 1e-3) << error.position;
  EXPECT_LT(error.accelerations, 1e-2) << error.acceleration;
  const Outcome diverged = run("rk4");
  EXPECT_EQ(diverged.exit_code, 1);
  EXPECT_NE(diverged.err.find("simulate: stopped after t = 0.00"), std::string::npos) << diverged.err;
  EXPECT_NE(diverged.err.find("step 0.001 s is too long"), std::string::npos) << diverged.err;
}

/// Wheels, carriers, balls of the arms, axle and chassis.
std::vector<InRubber> in_rubber(double corner, double vehicle) {
  std::vector<std::string> coach = {"chassis.centre", "chassis.driver", "rear_axle.centre"};
  for (const std::string side : {"_left", "_right"})
    for (const std::string point : {"lower_arm{}.ball", "upper_arm{}.ball", "carrier{}.tie_rod", "wheel_front{}.centre",
                                    "wheel_rear{}.centre", "long_rod{}.axle", "diag_rod{}.axle"})
      coach.push_back(fmt::format(fmt::runtime(point), side));
  return {{"rubber_wishbone",
           corner,
           {"lower_arm.lower_ball", "upper_arm.upper_ball", "knuckle.tie_rod", "knuckle.patch", "wheel.hub"}},
          {"rubber_coach", vehicle, coach}};
}

INSTANTIATE_TEST_SUITE_P(Start, ImplicitInRubber, ::testing::ValuesIn(in_rubber(0.4, 0.8)));
INSTANTIATE_TEST_SUITE_P(WholeSlalom, ImplicitInRubber, ::testing::ValuesIn(in_rubber(5, 5)));

// A lag of 1e-5 s behind what pushes: it asks for the implicit method, and is what messages name.
TEST_F(CommandLine, StiffStatesAskForImplicitStepsByName) {
  write("lag.json", R"j({ "mbgen": 1, "name": "lag", "gravity": [0, 0, 0], "bodies": {
    "ground": { "points": { "A": [0, 0, 0] } },
    "slide": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "slide.A", "axis": "x" } },
    "joint_forces": { "push": { "joint": "slide", "force": "drive - 4*zd.slide" } },
    "states": { "drive": { "derivative": "1e5*(10*sin(t) - 20*z.slide - drive)", "nominal": 10 } } })j");
  const std::string command = "simulate lag.json --duration 0.1 --step 1e-3 --out o.csv --integrator ";
  const Outcome chosen = mbgen(command + "auto --engine generic");
  EXPECT_EQ(chosen.exit_code, 0) << chosen.err;
  EXPECT_EQ(chosen.err,
            "simulate: integrator rosenbrock: the fastest mode at the start, decay at 1e+05 1/s (x.drive, slide "
            "+1.00), needs steps below 2.79e-05 s with rk4\n");
  const double generic = table("o.csv").last("z.slide [m]");
  ASSERT_EQ(mbgen(command + "rosenbrock").exit_code, 0);
  EXPECT_NEAR(table("o.csv").last("z.slide [m]") / generic, 1, 1e-12);
  const Outcome explicit_one = mbgen(command + "rk4 --engine generic");
  EXPECT_EQ(explicit_one.exit_code, 1);
  EXPECT_NE(explicit_one.err.find("decay at 1e+05 1/s (x.drive, slide +1.00), needs steps below"), std::string::npos)
      << explicit_one.err;
}

constexpr const char* kPushed = R"({ "mbgen": 1, "name": "pushed", "bodies": {
    "ground": { "points": { "A": [0, 0, 0] } },
    "arm": { "mass": 1, "com": [0, 0, -1], "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.A", "to": "arm.A", "axis": "y" } },
    "joint_forces": { "push": { "joint": "pin", "force": "1e9*z.pin" } }, "solver": { "integrator": "rosenbrock" } })";

TEST_F(CommandLine, ImplicitStepsRefuseWhatGivesWayTooFast) {
  write("pushed.json", kPushed);
  for (const char* engine : {"generic", "generated"}) {
    const Outcome run = mbgen(fmt::format("simulate pushed.json --duration 0.01 --out o.csv --engine {}", engine));
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("implicit equations singular: pin"), std::string::npos) << run.err;
  }
}

TEST_F(CommandLine, ImplicitStepsAreInTheCostSheetWhereAModelAsksForThem) {
  write("pushed.json", kPushed);
  ASSERT_EQ(mbgen("generate pushed.json --out made --no-runtime").exit_code, 0);
  const Json manifest = Json::parse(read("made/pushed.json")), programs = manifest["programs"];
  ASSERT_TRUE(programs.contains("tangents") && programs.contains("changes"));
  const auto total = [&](const char* program) { return programs[program]["operations"]["total"].get<long>(); };
  for (const Json& call : manifest["worst_case"]["calls"]) {
    if (call["function"] == "step_rosenbrock") {
      EXPECT_EQ(call["operations"], 4 * total("accelerations") + total("tangents") + 4 * total("changes"));
    }
  }
  write("swing.json", std::string(kPendulum));
  ASSERT_EQ(mbgen("generate swing.json --out plain --no-runtime").exit_code, 0);
  EXPECT_EQ(read("plain/pendulum.hpp").find("rosenbrock"), std::string::npos);
}

// Without the closures of the projection, which both integrators have alike.
TEST_F(CommandLine, ImplicitStepOfVehiclesInRubberCostsAtMostTwoOfRungeKutta) {
  for (const std::string model : {"rubber_wishbone", "rubber_coach"}) {
    ASSERT_EQ(mbgen(fmt::format("generate {}/models/{}.json --out made --no-runtime", kSource, model)).exit_code, 0);
    const Json programs = Json::parse(read("made/" + model + ".json"))["programs"];
    const auto total = [&](const char* program) { return programs[program]["operations"]["total"].get<double>(); };
    const double more = (total("tangents") + 4 * total("changes")) / (4 * total("accelerations"));
    std::printf("%s: an implicit step has %.2f times the operations\n", model.c_str(), 1 + more);
    EXPECT_LE(1 + more, 2) << model;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
