// Shafts, gears, joints and brakes of drivelines against closed forms. Source of the cases: the project's reference
// data contacts_driveline.json, section driveline.

#include <cmath>
#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Shafts : public CommandLine {
 protected:
  /// Shafts a, b, c, ... about x on ground with these inertias.
  void write_shafts(const std::vector<double>& inertias, const std::string& more) const {
    std::string bodies = R"("ground": { "points": { "O": [0, 0, 0] } })", joints;
    for (std::size_t i = 0; i < inertias.size(); ++i) {
      const char name = static_cast<char>('a' + i);
      bodies += fmt::format(R"(, "{}": {{ "mass": 1, "inertia": [{}, 100, 100], "points": {{ "O": [0, 0, 0] }} }})",
                            name, inertias[i]);
      joints += fmt::format(R"({}"{}": {{ "type": "revolute", "from": "ground.O", "to": "{}.O", "axis": "x" }})",
                            i == 0 ? "" : ", ", name, name);
    }
    write("shafts.json", fmt::format(R"({{ "mbgen": 1, "name": "shafts", "gravity": [0, 0, 0],
      "bodies": {{ {} }}, "joints": {{ {} }}, {} }})",
                                     bodies, joints, more));
  }

  /// rad/s, of the modes that vibrate, smallest first.
  std::vector<double> frequencies() const {
    std::vector<double> found;
    const Json linear = json_of("linearize shafts.json --json");
    for (const Json& mode : linear["modes"])
      if (const double at = std::abs(mode["eigenvalue"][1].get<double>()); at > 1) found.push_back(at);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end(), [](double a, double b) { return b - a < 1e-9 * b; }),
                found.end());
    return found;
  }

  Table run(const std::string& model, const std::string& engine, const std::string& more) const {
    const Outcome done = mbgen("simulate " + model + " --engine " + engine + " --out m.csv " + more);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return table("m.csv");
  }
};

TEST_F(Shafts, TwistAtTheFrequenciesOfTwoAndThreeInertias) {
  write_shafts({0.25, 90}, R"("joint_springs": { "shaft": { "joint": "a", "relative_to": "b", "stiffness": 9000 } })");
  ASSERT_EQ(frequencies().size(), 1u);
  EXPECT_NEAR(frequencies()[0], 190, 1e-9 * 190);
  write_shafts({0.2, 0.05, 4}, R"("joint_springs": { "ab": { "joint": "a", "relative_to": "b", "stiffness": 15000 },
    "bc": { "joint": "b", "relative_to": "c", "stiffness": 3000 } })");
  const std::vector<double> found = frequencies();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 106.1301656628, 1e-8);
  EXPECT_NEAR(found[1], 651.5261989639, 1e-8);
}

// Willis: 30 and 72 teeth; the ring is held by a stiff spring, the carrier drives a load.
TEST_F(Shafts, OfAPlanetaryGearTurnAndBearAsWillisSays) {
  write_shafts({0.01, 0.02, 0.03}, R"("couplings": { "gear": { "relation": "30*z.a + 72*z.b - 102*z.c" } },
    "joint_forces": { "sun": { "joint": "a", "force": 10 } },
    "joint_springs": { "ring": { "joint": "b", "stiffness": 1e5 }, "load": { "joint": "c", "stiffness": 200 } },
    "initial": { "equilibrium": true }, "outputs": { "ring": { "expression": "1e5*z.b", "unit": "N m" },
      "load": { "expression": "200*z.c", "unit": "N m" } })");
  for (const char* engine : {"generic", "augmented"}) {
    const Table rest = run("shafts.json", engine, "--step 1e-4 --duration 1e-3");
    EXPECT_NEAR(std::abs(rest.at(0, "ring [N m]")), 24, 1e-7) << engine;
    EXPECT_NEAR(std::abs(rest.at(0, "load [N m]")), 34, 1e-7) << engine;
  }
  write_shafts({0.01, 0.02, 0.03}, R"("couplings": { "gear": { "relation": "30*z.a + 72*z.b - 102*z.c" } },
    "motions": { "ring": { "joint": "b", "angle": 0 } }, "initial": { "velocities": { "a": 100 } })");
  EXPECT_NEAR(run("shafts.json", "generated", "--step 1e-3 --duration 0.1").last("zd.c [rad/s]"), 29.41176470588235,
              1e-11);
}

TEST_F(Shafts, OfAnOpenDifferentialBearEqualTorques) {
  write_shafts({0.1, 0.2, 0.3}, R"("couplings": { "differential": { "relation": "z.a + z.b - 2*z.c" } },
    "joint_forces": { "input": { "joint": "c", "force": 600 } },
    "joint_springs": { "left": { "joint": "a", "stiffness": 1000 }, "right": { "joint": "b", "stiffness": 5000 } },
    "initial": { "equilibrium": true }, "outputs": { "left": { "expression": "1000*z.a", "unit": "N m" },
      "right": { "expression": "5000*z.b", "unit": "N m" } })");
  const Table rest = run("shafts.json", "generic", "--step 1e-4 --duration 1e-3");
  EXPECT_NEAR(std::abs(rest.at(0, "left [N m]")), 300, 1e-6);
  EXPECT_NEAR(std::abs(rest.at(0, "right [N m]")), 300, 1e-6);
}

// A universal joint between shafts with an angle of 0.35 rad: ratio of their speeds over the angle of the first.
TEST_F(Shafts, WithAHookeJointTurnUnevenly) {
  const double b = 0.35;
  write("hooke.json", fmt::format(R"json({{ "mbgen": 1, "name": "hooke", "gravity": [0, 0, 0],
    "bodies": {{ "ground": {{ "points": {{ "O": [-1, 0, 0], "E": [{0}, {1}, 0] }} }},
      "one": {{ "mass": 1, "inertia": [0.1, 0.1, 0.1], "points": {{ "O": [-1, 0, 0], "C": [0, 0, 0] }} }},
      "two": {{ "mass": 1, "inertia": [0.1, 0.1, 0.1], "points": {{ "C": [0, 0, 0], "E": [{0}, {1}, 0] }} }} }},
    "joints": {{ "one": {{ "type": "revolute", "from": "ground.O", "to": "one.O", "axis": "x" }},
      "two": {{ "type": "revolute", "from": "ground.E", "to": "two.E", "axis": [{0}, {1}, 0] }},
      "cross": {{ "type": "universal", "from": "one.C", "to": "two.C", "axis": [0, 1, 0], "axis2": "z" }} }},
    "motions": {{ "drive": {{ "joint": "one", "angle": "t" }} }} }})json",
                                  std::cos(b), std::sin(b)));
  for (const char* engine : {"generic", "generated", "augmented"}) {
    const Table motion = run("hooke.json", engine, "--step 1e-3 --duration 3.2");
    double least = 9, most = 0;
    for (std::size_t row = 0; row < motion.rows.size(); ++row) {
      const double ratio = std::abs(motion.at(row, "zd.two [rad/s]"));
      least = std::min(least, ratio), most = std::max(most, ratio);
    }
    EXPECT_NEAR(least, std::cos(b), 1e-6) << engine;
    EXPECT_NEAR(most, 1 / std::cos(b), 1e-6) << engine;
    // The driving fork lies in the plane of the shafts at t = 0: its angle from the normal is pi/2 - t or t.
    const auto ratio = [&](double a) { return std::cos(b) / (1 - std::pow(std::sin(b) * std::cos(a), 2)); };
    const double found = std::abs(motion.at(600, "zd.two [rad/s]"));
    const double nearest = std::min(std::abs(found - ratio(0.6)), std::abs(found - ratio(std::numbers::pi / 2 - 0.6)));
    EXPECT_LT(nearest, 1e-9) << engine << " " << found;
  }
  const auto ratio = [&](double a) { return std::cos(b) / (1 - std::pow(std::sin(b) * std::cos(a), 2)); };
  EXPECT_NEAR(ratio(0.6), 1.0211597093683165, 1e-12);
}

TEST_F(Shafts, ConstantPowerAcceleratesByTheRootOfTime) {
  write("power.json", R"json({ "mbgen": 1, "name": "power", "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "car": { "mass": 1500, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "s": { "type": "prismatic", "from": "ground.O", "to": "car.O", "axis": "x" } },
    "joint_forces": { "engine": { "joint": "s", "force": "75000/zd.s" } }, "initial": { "velocities": { "s": 5 } } })json");
  const Table motion = run("power.json", "generated", "--step 1e-3 --duration 8");
  EXPECT_NEAR(motion.last("zd.s [m/s]"), 28.722813232690143, 1e-9);
  EXPECT_NEAR(motion.last("z.s [m]"), 157.14213944646247, 1e-9);
}

// A wheel under its brake and the ground's moment mu N R, and a body that slides to its stop.
TEST_F(Shafts, BrakesLockAWheelAndStopABody) {
  write_shafts({1.1}, R"("joint_forces": { "ground": { "joint": "a", "force": "0.9*3800*0.31" } },
    "frictions": { "brake": { "joint": "a", "law": "elasto_plastic", "coulomb": 2000, "stiffness": 1e7, "damping": 5 } },
    "initial": { "velocities": { "a": 80 } }, "solver": { "step": 1e-5 })");
  const Table locking = run("shafts.json", "generated", "--duration 0.12");
  double locked = 0;
  for (std::size_t row = 0; row < locking.rows.size() && locked == 0; ++row)
    if (locking.at(row, "zd.a [rad/s]") < 1e-2) locked = locking.rows[row][0];
  EXPECT_NEAR(locked, 0.09363694403064482, 5e-5);  // the bristle bears its first load within a few steps
  write("stop.json", R"json({ "mbgen": 1, "name": "stop", "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "car": { "mass": 10, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "s": { "type": "prismatic", "from": "ground.O", "to": "car.O", "axis": "x" } },
    "frictions": { "ground": { "joint": "s", "law": "elasto_plastic", "coulomb": "0.9*10*9.81", "stiffness": 1e7,
      "damping": 300 } }, "initial": { "velocities": { "s": 25 } },
    "solver": { "step": 1e-4 } })json");
  const Table stop = run("stop.json", "generated", "--duration 3");
  EXPECT_NEAR(stop.last("z.s [m]"), 35.394721939064446, 3e-3);  // 25 m/s for such a time
  EXPECT_LT(std::abs(stop.last("zd.s [m/s]")), 5e-3);           // the bristle swings
}

// At stall the converter takes the torque where its capacity meets the engine's map, and multiplies it by 2.1.
TEST_F(Shafts, ADrivelineThatIsHeldStallsWhereConverterAndEngineMeet) {
  write("stall.json", R"({ "mbgen": 1, "name": "stall", "gravity": [0, 0, 0], "include": [")" + kSource +
                          R"(/models/parts/driveline_automatic.json"],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "wheel": { "mass": 1, "inertia": [10, 10, 10], "points": { "O": [0, 0, 0] } } },
    "joints": { "wheel": { "type": "revolute", "from": "ground.O", "to": "wheel.O", "axis": "x" } },
    "values": { "drive_speed": "zd.wheel" }, "motions": { "held": { "joint": "wheel", "angle": 0 } } })");
  const Table stall = run("stall.json", "generated", "--step 1e-3 --duration 8 --input pedal=1");
  // From 150 to 200 rad/s the engine gives 2000 to 1500 N m: 0.085 w^2 = 2000 - 10 (w - 150).
  const double w = (std::sqrt(100 + 4 * 0.085 * 3500) - 10) / (2 * 0.085), torque = 0.085 * w * w;
  EXPECT_NEAR(stall.last("engine_speed [rad/s]"), w, 1e-6 * w);
  EXPECT_EQ(stall.last("gear [1]"), 1);
  EXPECT_NEAR(stall.last("drive_torque [N m]"), 4.9 * 3.43 * 2.1 * torque, 1e-6 * 4.9 * 3.43 * 2.1 * torque);
}

}  // namespace
}  // namespace mbgen::cli_test
