// Rolling at the command line: freedoms of positions and of velocities, linear systems, FMUs, and motions that no
// real contact has.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A disc on its rim, that leans by 0.9 rad and is let go; gravity: along z.
std::string falling_disc(const std::string& gravity, const std::string& spin) {
  return R"({ "mbgen": 1, "name": "disc", "gravity": [0, 0, )" + gravity + R"(], "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "C": [0, 0, 0.3] } },
      "disc": { "mass": 2, "pose": { "origin": [0, 0, 0.3] }, "inertia": [0.045, 0.09, 0.045],
                "points": { "C": [0, 0, 0] } } },
    "joints": {
      "disc": { "type": "free", "from": "ground.C", "to": "disc.C", "sequence": "xyz" },
      "contact": { "type": "rolling_disc", "from": "ground.O", "to": "disc.C", "axis": "z", "axis2": "y" } },
    "initial": { "positions": { "disc_rx": 0.9 }, "velocities": { "disc_ry": )" +
         spin + R"( } } })";
}

class Rolling : public CommandLine {};

TEST_F(Rolling, FreedomsOfVelocitiesAreToldFromThoseOfPositions) {
  write("disc.json", falling_disc("-9.81", "0"));
  const Json report = json_of("inspect disc.json --json");
  EXPECT_EQ(report["relative_coordinates"], 6);
  EXPECT_EQ(report["velocity_equations"], 2);
  EXPECT_EQ(report["degrees_of_freedom"], 3);
  EXPECT_EQ(report["position_freedoms"], 5);
  EXPECT_NE(mbgen("explain disc.json").out.find("of positions there are 5 freedoms"), std::string::npos);
}

TEST_F(Rolling, PlacesAreStatesOfTheLinearSystemAndNeutral) {
  write("disc.json", falling_disc("-9.81", "8"));
  const Json linear = json_of("linearize disc.json --json");
  const std::vector<std::string> states = linear["states"];
  EXPECT_EQ(states.size(), 8u);
  for (const char* state : {"z.disc_tx", "z.disc_ty", "zd.disc_ry"})
    EXPECT_NE(std::find(states.begin(), states.end(), state), states.end()) << state;
  const std::string told = mbgen("linearize disc.json").out;
  EXPECT_NE(told.find("rigid body and rolling (4 eigenvalues): disc_ry, disc_tx, disc_ty"), std::string::npos) << told;
}

TEST_F(Rolling, AnFmuOfItHasCoSimulationAlone) {
  write("disc.json", falling_disc("-9.81", "8"));
  for (const std::string version : {"2", "3"}) {
    const Outcome done = mbgen("export disc.json --sources-only --fmi " + version + " -o disc.fmu");
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.err.find("disc.json:7:"), std::string::npos) << done.err;
    EXPECT_NE(done.err.find("the FMU has co-simulation alone"), std::string::npos) << done.err;
    EXPECT_EQ(shell("cmake -E tar xf disc.fmu modelDescription.xml").exit_code, 0);
    const std::string description = read("modelDescription.xml");
    EXPECT_NE(description.find("<CoSimulation"), std::string::npos);
    for (const char* absent : {"<ModelExchange", "StateDerivative", "<Derivatives>", "name=\"q."})
      EXPECT_EQ(description.find(absent), std::string::npos) << absent;
  }
}

// A plane is there to hold the height of a ball on it: nothing to note.
TEST_F(Rolling, AHeightThatAContactHoldsIsMeant) {
  write("marble.json", R"({ "mbgen": 1, "bodies": { "ground": { "points": { "O": [0, 0, 0], "C": [0, 0, 0.1] } },
      "marble": { "mass": 1, "pose": { "origin": [0, 0, 0.1] }, "inertia": [0.004, 0.004, 0.004], "points": { "C": [0, 0, 0] } } },
    "joints": { "marble": { "type": "free", "from": "ground.C", "to": "marble.C", "sequence": "zyx" },
      "contact": { "type": "rolling_ball", "from": "ground.O", "to": "marble.C", "axis": "z" } } })");
  const Outcome done = mbgen("check marble.json");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ((done.out + done.err).find("by less than 1e-6 of the motion"), std::string::npos) << done.out << done.err;
}

// The disc lies flat after 0.25 s, which a step goes over; upside down it hangs on its plane from the start.
TEST_F(Rolling, NeitherFallsFlatNorLiftsOffUnseen) {
  write("disc.json", falling_disc("-9.81", "0"));
  const Outcome flat = mbgen("simulate disc.json --engine generic --duration 0.5 --out flat.csv");
  EXPECT_EQ(flat.exit_code, 1);
  EXPECT_NE(flat.err.find("\"contact\" fell flat before t = "), std::string::npos) << flat.err;
  write("hanging.json", falling_disc("9.81", "20"));
  const Outcome hanging = mbgen("simulate hanging.json --engine generic --duration 0.02 --out hanging.csv");
  EXPECT_EQ(hanging.exit_code, 0) << hanging.err;
  EXPECT_NE(hanging.err.find("rolling_disc \"contact\" pulls from t = 0 s on"), std::string::npos) << hanging.err;
}

}  // namespace
}  // namespace mbgen::cli_test
