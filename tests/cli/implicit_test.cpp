// The linearly implicit integrator as users meet it: stiff models at steps that Runge-Kutta does not bear.

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
  for (const Json& call : manifest["worst_case"]["calls"])
    if (call["function"] == "step_rosenbrock")
      EXPECT_EQ(call["operations"], 4 * total("accelerations") + total("tangents") + 4 * total("changes"));
  write("swing.json", std::string(kPendulum));
  ASSERT_EQ(mbgen("generate swing.json --out plain --no-runtime").exit_code, 0);
  EXPECT_EQ(read("plain/pendulum.hpp").find("rosenbrock"), std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
