// Clutches and backlash between two shafts against closed forms. Source of the cases: the project's reference data
// contacts_driveline.json, exact flight by flight.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Driveline : public CommandLine {
 protected:
  /// Two shafts about x on ground, with inertias j1 and j2.
  void write_shafts(double j1, double j2, const std::string& more) const {
    write("shafts.json", fmt::format(R"({{ "mbgen": 1, "name": "shafts", "gravity": [0, 0, 0],
        "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
          "one": {{ "mass": 1, "inertia": [{}, 1, 1], "points": {{ "O": [0, 0, 0] }} }},
          "two": {{ "mass": 1, "inertia": [{}, 1, 1], "points": {{ "O": [0, 0, 0] }} }} }},
        "joints": {{ "one": {{ "type": "revolute", "from": "ground.O", "to": "one.O", "axis": "x" }},
          "two": {{ "type": "revolute", "from": "ground.O", "to": "two.O", "axis": "x" }} }}, {} }})",
                                     j1, j2, more));
  }
  Table run(const std::string& engine, const std::string& more) const {
    const Outcome done = mbgen("simulate shafts.json --engine " + engine + " --out m.csv " + more);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return table("m.csv");
  }
};

// An engine at 200 rad/s takes a load along through a slipping clutch of 80 N m; both turn as one from 0.8308 s on.
TEST_F(Driveline, AClutchLocksAtTheTimeOfEqualSpeeds) {
  write_shafts(0.3, 1.2, R"("frictions": { "clutch": { "joint": "one", "relative_to": "two", "law": "elasto_plastic",
      "coulomb": 80, "stiffness": 1e6, "damping": 200 } },
      "joint_forces": { "engine": { "joint": "one", "force": "30" }, "load": { "joint": "two", "force": "-20" } },
      "initial": { "velocities": { "one": 200, "two": 20 } })");
  // Bristles follow the first load within their lag, 1 ms.
  for (const char* engine : {"generic", "augmented", "generated"}) {
    const Table motion = run(engine, "--step 1e-4 --duration 1 --every 10");
    const auto gap = [&](std::size_t row) {
      return motion.at(row, "zd.one [rad/s]") - motion.at(row, "zd.two [rad/s]");
    };
    double locked = 0;
    for (std::size_t row = 0; row < motion.rows.size() && locked == 0; ++row)
      if (gap(row) < 1) locked = motion.rows[row][0] + gap(row) / (50 / 0.3 + 60 / 1.2);
    EXPECT_NEAR(locked, 0.8307692307692307, 1e-3) << engine;
    // Slipping: dw1/dt = (30 - 80)/0.3, dw2/dt = (80 - 20)/1.2; locked: (30 - 20)/1.5.
    EXPECT_NEAR(motion.at(500, "zd.one [rad/s]"), 200 - 0.5 * 50 / 0.3, 0.1) << engine;
    EXPECT_NEAR(motion.at(500, "zd.two [rad/s]"), 20 + 0.5 * 60 / 1.2, 0.1) << engine;
    EXPECT_NEAR(motion.last("zd.two [rad/s]"), 61.53846153846155 + (1 - 0.8307692307692307) * 10 / 1.5, 1e-4) << engine;
    EXPECT_LT(std::abs(gap(motion.rows.size() - 1)), 1e-3) << engine;
  }
  const Table implicit = run("generic", "--step 1e-3 --duration 1 --integrator rosenbrock");
  EXPECT_NEAR(implicit.last("zd.one [rad/s]"), 61.53846153846155 + (1 - 0.8307692307692307) * 10 / 1.5, 1e-4);
}

// Teeth with a play of 0.01 rad to both sides: free flight, contact, flight, ...; exact states at five times.
TEST_F(Driveline, BacklashIsAPairOfStopsBetweenTwoShafts) {
  write_shafts(0.02, 0.5, R"("bump_stops": {
      "drive": { "joint": "one", "relative_to": "two", "side": "above", "clearance": 0.01, "stiffness": 8000 },
      "coast": { "joint": "one", "relative_to": "two", "side": "below", "clearance": 0.01, "stiffness": 8000 } },
      "outputs": { "tooth": { "bump_stop": "drive", "quantity": "force" } },
      "joint_forces": { "motor": { "joint": "one", "force": "5" } })");
  const double exact[][3] = {{0.02, 0.00322531937609, 0.001870987224956},
                             {0.05, 0.01342241188879, 0.01196310352445},
                             {0.1, 0.05368964755515, 0.04785241409779}};
  for (const char* engine : {"generic", "augmented"}) {
    double error[2] = {0, 0};
    for (const int finer : {0, 1}) {
      const Table motion =
          run(engine, finer == 0 ? "--step 2e-5 --duration 0.1 --every 50" : "--step 1e-5 --duration 0.1 --every 100");
      double largest = 0;
      for (std::size_t row = 0; row < motion.rows.size(); ++row)
        largest = std::max(largest, motion.at(row, "tooth [N m]"));
      EXPECT_NEAR(largest, 32.95630993904701, 1.0) << engine;
      for (const auto& [t, one, two] : exact) {
        const auto row = static_cast<std::size_t>(std::lround(t / 1e-3));
        error[finer] = std::max({error[finer], std::abs(motion.at(row, "z.one [rad]") - one),
                                 std::abs(motion.at(row, "z.two [rad]") - two)});
      }
    }
    EXPECT_LT(error[1], 2e-6) << engine;
    EXPECT_LT(error[1], error[0]) << engine;
  }
}

TEST_F(Driveline, PairsThatAreNoneAreErrors) {
  const auto error = [&](const std::string& element) {
    write_shafts(1, 1, element);
    const std::string text = mbgen("check shafts.json").err;
    const std::size_t begin = text.find(": /");
    return text.substr(begin + 2, text.find('\n') - begin - 2);
  };
  EXPECT_EQ(error(R"("frictions": { "f": { "joint": "one", "relative_to": "one", "coulomb": 1, "velocity": 1 } })"),
            "/frictions/f/relative_to: friction is between coordinate \"one\" and itself");
  EXPECT_EQ(
      error(
          R"("bump_stops": { "b": { "joint": "one", "relative_to": "one", "side": "above", "clearance": 0, "stiffness": 1 } })"),
      "/bump_stops/b/relative_to: bump stop is between coordinate \"one\" and itself");
  EXPECT_EQ(
      error(
          R"("bump_stops": { "b": { "from": "ground.O", "to": "one.O", "axis": "x", "relative_to": "one", "clearance": 0, "stiffness": 1 } })"),
      "/bump_stops/b/relative_to: \"relative_to\" is of a stop on a coordinate");
}

}  // namespace
}  // namespace mbgen::cli_test
