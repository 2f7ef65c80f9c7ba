// Spherical and free joints through the poles of their angles, in generated code: alone, in lanes, in single precision;
// and what the commands say of a pole.

#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A body on a ball joint, closed by a rod: three freedoms but one, through the pole of its sequence.
const char* const kRodPendulum = R"({
  "mbgen": 1, "name": "rod_pendulum",
  "bodies": {
    "ground": { "points": { "O": [0, 0, 0], "A": [0.3, 0.2, 0.8] } },
    "arm": { "mass": 2, "com": [0, 0, -0.5], "inertia": [0.28, 0.3, 0.05],
      "points": { "O": [0, 0, 0], "B": [0.1, 0, -0.6], "tip": [0.3, 0.1, -1] } }
  },
  "joints": { "ball": { "type": "spherical", "from": "ground.O", "to": "arm.O", "sequence": "xzy" } },
  "rods": { "rod": { "from": "ground.A", "to": "arm.B", "mass": 0.3 } },
  "outputs": {
    "x": { "point": "arm.tip", "axis": "x" }, "y": { "point": "arm.tip", "axis": "y" },
    "z": { "point": "arm.tip", "axis": "z" }, "pitch": { "joint": "ball_rz" }
  },
  "initial": { "velocities": { "ball_rx": 6, "ball_ry": 4, "ball_rz": 7 } }
})";

/// A racket thrown about its middle axis; its drag looks at the angles of the model.
const char* const kRacket = R"json({
  "mbgen": 1, "name": "racket",
  "bodies": {
    "ground": { "points": { "O": [0, 0, 0] } },
    "racket": { "mass": 1, "inertia": [1, 2, 2.5], "points": { "O": [0, 0, 0], "tip": [1, 0.5, 0.2] } }
  },
  "joints": { "float": { "type": "free", "from": "ground.O", "to": "racket.O" } },
  "forces": { "drag": { "at": "racket.O", "force": ["-0.1*sin(z.float_ry)", 0, "0.2*sin(z.float_ry)"] } },
  "outputs": {
    "x": { "point": "racket.tip", "axis": "x" }, "y": { "point": "racket.tip", "axis": "y" },
    "z": { "point": "racket.tip", "axis": "z" }, "pitch": { "joint": "float_ry" },
    "alpha": { "body": "racket", "quantity": "angular_acceleration", "axis": "x" }
  },
  "initial": { "velocities": { "float_ry": 3, "float_rx": 0.02, "float_tz": 1 } }
})json";

std::string with_text(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// The racket that nothing acts on.
std::string free_racket() {
  std::string text = with_text(kRacket, R"("racket",)", R"("racket", "gravity": [0, 0, 0],)");
  const std::size_t forces = text.find(R"("forces")");
  return text.erase(forces, text.find(R"("outputs")") - forces);
}

/// Largest absolute value of a column.
double most(const Table& table, const std::string& column) {
  double largest = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    largest = std::max(largest, std::abs(table.at(row, column)));
  return largest;
}

TEST_F(CommandLine, GeneratedBallsGoThroughTheirPolesAsGenericOnesDo) {
  struct Case {
    const char *name, *model;
    double duration, step, tolerance;
  };
  // Of closed loops the engines project differently: within the error of the step.
  for (const Case& c : {Case{"racket", kRacket, 3, 1e-3, 1e-9}, Case{"rod_pendulum", kRodPendulum, 1, 2.5e-4, 1e-6}}) {
    for (const char* integrator : {"rk4", "abm4"}) {
      write("m.json",
            std::string(c.model).insert(1, fmt::format(R"("solver": {{ "integrator": "{}" }},)", integrator)));
      Table tables[2];
      for (int e = 0; e < 2; ++e) {
        const Json report =
            json_of(fmt::format("simulate m.json --engine {} --duration {} --step {} --every 20 --out o.csv --json",
                                kEngines[e], c.duration, c.step));
        EXPECT_EQ(report["status"], "ok") << c.name;
        tables[e] = table("o.csv");
      }
      for (const char* column : {"x [m]", "y [m]", "z [m]"})
        for (std::size_t row = 0; row < tables[0].rows.size(); ++row)
          ASSERT_NEAR(tables[0].at(row, column), tables[1].at(row, column), c.tolerance) << c.name << integrator << row;
      EXPECT_GT(most(tables[0], "pitch [rad]"), 1.4) << c.name;
      EXPECT_LT(most(tables[0], "pitch [rad]"), 1.6) << c.name;
    }
  }
}

// Lanes that are at different places of their ways: each as the solver of one instance, in the same bits.
TEST_F(CommandLine, LanesOfBallsGoAloneNearTheirPoles) {
  write("m.json", kRodPendulum);
  ASSERT_EQ(mbgen("generate m.json --batch 4 --out made").exit_code, 0);
  write("made/main.cpp", R"(
#include "rod_pendulum_batch.hpp"
#include <cstring>
using namespace rod_pendulum;
int main() {
  batch::State lanes = batch::initial_state();
  batch::History past{};
  State one[4];
  History history[4]{};
  for (int l = 0; l < 4; ++l) {
    one[l] = lane_of(lanes, l);
    one[l].zd[0] += 0.3 * l;
    if (!assemble({}, {}, one[l]).ok()) return 2;
    set_lane(lanes, l, one[l]);
  }
  int changed = 0;
  for (int k = 0; k < 2000; ++k) {
    const batch::Statuses statuses = batch::step_abm4({}, {}, lanes, past, 1e-3);
    for (int l = 0; l < 4; ++l) {
      if (!step_abm4({}, {}, one[l], history[l], 1e-3).ok() || !statuses.lane[l].ok()) return 3;
      changed += one[l].charts[0] > 0.5;
      const State lane = lane_of(lanes, l);
      if (std::memcmp(lane.z, one[l].z, sizeof lane.z) != 0 || lane.charts[0] != one[l].charts[0]) return 4;
      const State users = in_users_angles(lane);
      if (users.charts[0] != 0 || !(users.z[1] < 1.6 && users.z[1] > -1.6)) return 5;
    }
  }
  return changed > 50 ? 0 : 6;
}
)");
  const Outcome compiled = shell("c++ -std=c++17 -O1 -Wall -Wextra -Werror -Imade made/*.cpp -o made/main");
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  EXPECT_EQ(shell("made/main").exit_code, 0);
}

// Dzhanibekov's racket flips for a quarter of an hour.
TEST_F(CommandLine, RacketFlipsOnAndOn) {
  write("m.json", free_racket());
  const Json report = json_of("simulate m.json --duration 1000 --step 2e-3 --every 5000 --out o.csv --json");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_LT(std::abs(report["relative_energy_error"].get<double>()), 1e-7);
}

// A brick turns 1e5 times: 31416 s at 20 rad/s in steps of a fiftieth of a radian. Its loss of energy is the error
// of Runge-Kutta in angles, and no step meets a pole.
TEST_F(CommandLine, BrickTumblesAHundredThousandTurns) {
  const std::string start = R"("float_ry": 3, "float_rx": 0.02)";
  write("m.json", with_text(free_racket(), start, R"("float_rx": 4, "float_ry": 19, "float_rz": 5)"));
  ASSERT_EQ(mbgen("generate m.json --out made").exit_code, 0);
  write("made/main.cpp", R"(
#include "racket.hpp"
#include <cmath>
using namespace racket;
double energy_of(const State& state) {
  const double none[kCoordinates] = {};
  Derivative rates{};
  Outputs values{};
  if (!accelerations({}, {}, state, none, rates).ok() || !outputs({}, {}, state, none, rates, values).ok()) return NAN;
  return values.kinetic_energy;
}
int main() {
  State state = initial_state();
  const double start = energy_of(state);
  for (long k = 0; k < 31416000; ++k)
    if (step_rk4({}, {}, state, 1e-3).code != mbgen::Code::ok) return 2;
  return std::abs(energy_of(state) / start - 1) < 5e-3 ? 0 : 3;
}
)");
  const Outcome compiled = shell("c++ -std=c++17 -O2 -march=native -Imade made/*.cpp -o made/main");
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  EXPECT_EQ(shell("made/main").exit_code, 0);
}

/// The free racket at a quarter turn about y, the pole of zyx and none of xzy, turning about another axis.
std::string from_the_pole(const char* sequence, bool reversed) {
  const char* joint = R"("from": "ground.O", "to": "racket.O" })";
  const std::string ends =
      reversed ? R"("from": "racket.O", "to": "ground.O")" : R"("from": "ground.O", "to": "racket.O")";
  std::string text = with_text(free_racket(), joint, fmt::format(R"({}, "sequence": "{}" }})", ends, sequence));
  return with_text(text, R"({ "velocities": { "float_ry": 3, "float_rx": 0.02, "float_tz": 1 } })",
                   R"({ "orientations": { "float": { "rotation_vector": [0, 1.5707963267948966, 0],
                                                     "angular_velocity": [0.4, 2, -1.5] } } })");
}

// Rates of angles cannot say how a ball turns in their pole: it starts in its other angles, whichever way the tree
// runs.
TEST_F(CommandLine, ABallStartsTurningInItsPole) {
  for (const bool reversed : {false, true}) {
    write("far.json", from_the_pole("xzy", reversed));
    write("m.json", from_the_pole("zyx", reversed));
    ASSERT_EQ(mbgen("simulate far.json --engine generic --duration 1 --every 100 --out far.csv").exit_code, 0);
    const Table far = table("far.csv");
    for (const char* engine : kEngines) {
      const Outcome run =
          mbgen(fmt::format("simulate m.json --engine {} --duration 1 --every 100 --out o.csv", engine));
      ASSERT_EQ(run.exit_code, 0) << run.err;
      const Table here = table("o.csv");
      for (const char* column : {"x [m]", "y [m]", "z [m]", "alpha [rad/s^2]"})
        for (std::size_t row = 0; row < far.rows.size(); ++row)
          ASSERT_NEAR(here.at(row, column), far.at(row, column), 1e-9) << engine << reversed << column << row;
    }
  }
  ASSERT_EQ(mbgen("generate m.json --out made").exit_code, 0);
  EXPECT_NE(read("made/racket.cpp").find("0.0, {1.0}};"), std::string::npos);
  const Outcome judged = mbgen("simulate m.json --engine augmented --duration 1 --out o.csv");
  EXPECT_NE(judged.err.find("a joint starts in their pole"), std::string::npos) << judged.err;
  const Outcome unit = mbgen("export m.json --fmi 3 --sources-only -o o.fmu");
  EXPECT_NE(unit.err.find("the angles of joint \"float\" start in their pole"), std::string::npos) << unit.err;
  write("held.json", with_text(from_the_pole("zyx", false), R"("outputs")",
                               R"("joint_springs": { "s": { "joint": "float_rz", "stiffness": 1 } }, "outputs")"));
  const Outcome held = mbgen("check held.json");
  EXPECT_EQ(held.exit_code, 1);
  EXPECT_NE(held.err.find("have no rates: joint spring s is on float_rz"), std::string::npos) << held.err;
}

// A shaft on an arm that swings: at a right angle the cross lets it turn, and the loop through its bearing is singular.
TEST_F(CommandLine, AUniversalJointAtARightAngleIsNamed) {
  write("m.json", R"({ "mbgen": 1, "name": "shaft", "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "arm": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } },
      "shaft": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "arm": { "type": "revolute", "from": "ground.O", "to": "arm.O", "axis": "z" },
      "bearing": { "type": "revolute", "from": "arm.O", "to": "shaft.O", "axis": "x", "cut": true },
      "cross": { "type": "universal", "from": "ground.O", "to": "shaft.O", "axis": "y", "axis2": "z" } } })");
  write("s.json",
        fmt::format(R"({{ "states": [{{ "z": [{0:.17g}, 0, {0:.17g}], "zd": [0, 0, 0], "tau": [0, 0, 0] }}] }})",
                    std::numbers::pi / 2));
  for (const char* engine : kEngines) {
    const Outcome run = mbgen(fmt::format("evaluate m.json --states s.json --engine {}", engine));
    EXPECT_NE(run.out.find("loop singular: bearing, universal joint cross may be bent by a right angle"),
              std::string::npos)
        << run.out << run.err;
  }
}

TEST_F(CommandLine, PolesAreNamedWhereAnglesAreAskedFor) {
  write("m.json", kRacket);
  const std::string pole = fmt::format("[0, 0, 0, 0.2, {:.17g}, 0]", std::numbers::pi / 2);
  write("s.json", R"({ "states": [{ "z": )" + pole + R"(, "zd": [0, 0, 0, 0, 1, 0], "tau": [0, 0, 0, 0, 0, 0] }] })");
  for (const char* engine : kEngines) {
    const Outcome run = mbgen(fmt::format("evaluate m.json --states s.json --engine {}", engine));
    EXPECT_NE(run.out.find("the angles of joint float may be at their pole"), std::string::npos) << run.out << run.err;
  }
  const std::string text = kRacket;
  const std::string start = R"("float_tz": 1 })";
  write("at.json",
        std::string(text).replace(text.find(start), start.size(), start + R"(, "positions": { "float_ry": 1.5 })"));
  const Outcome linear = mbgen("linearize at.json");
  EXPECT_EQ(linear.exit_code, 1);
  EXPECT_NE(linear.err.find("the angles of joint \"float\" are near their pole"), std::string::npos) << linear.err;
  const std::string outputs = R"("outputs")";
  write("held.json",
        std::string(text).replace(text.find(outputs), outputs.size(),
                                  R"("joint_springs": { "s": { "joint": "float_rz", "stiffness": 1 } }, "outputs")"));
  const Outcome explained = mbgen("explain held.json");
  EXPECT_NE(explained.out.find("Joint float keeps its angles and their pole"), std::string::npos) << explained.out;
}

}  // namespace
}  // namespace mbgen::cli_test
